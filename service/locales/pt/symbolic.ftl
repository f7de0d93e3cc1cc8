# Formas fechadas.

error-form_too_large = A forma expandida exige mais de { $limit } produtos de termos. Peça menos linhas.
error-closed_form_too_large = Escrita por extenso, uma matriz tem mais de { $limit } operações. Peça menos linhas, ou uma função (python, c, matlab e outras), que calcula uma só vez o que se repete.
error-closed_form_too_deep = Um elemento tem demasiados níveis de aninhamento para uma árvore JSON. Peça texto ou LaTeX.
error-computation_out_of_time = O cálculo leva mais de { $seconds } s. Peça menos linhas, partes ou formatos ou, em vez de fórmulas, números para valores dados das juntas.
error-computation_out_of_memory = O cálculo ocupa mais de { $megabytes } MiB de memória. Peça menos linhas, partes ou formatos ou, em vez de fórmulas, números para valores dados das juntas.
error-computation_aborted = O cálculo foi interrompido por um problema do servidor, não do seu pedido. Tente de novo dentro de momentos.
