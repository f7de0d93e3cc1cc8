# O que o corretor diz de uma tabela: de uma certa, de uma errada, e o que a emendaria.

## Uma resposta certa, e como os seus referenciais ficam em relação aos da solução de referência

feedback-same_frames = Os seus referenciais são os da solução de referência.
feedback-other_convention = A sua tabela está na convenção { $convention ->
    [modified] modificada e a solução de referência na standard
   *[standard] standard e a solução de referência na modificada
}; ambas descrevem o mesmo robô.
feedback-axis_reversed = O seu z{ $frame }, o eixo da junta { $joint }, aponta no sentido oposto ao da solução de referência. Ambos os sentidos estão certos, e os sinais da sua tabela concordam com o que escolheu.
feedback-end_axis_reversed = O seu z{ $frame } aponta no sentido oposto ao da solução de referência. Ambos os sentidos estão certos.
feedback-x_turned = O seu x{ $frame } está rodado de { $degrees }° em torno de z{ $frame } em relação à solução de referência. A sua tabela leva isso em conta.
feedback-origin_slid = A origem do seu referencial { $frame } está num ponto de z{ $frame } diferente do da solução de referência. Aqui qualquer ponto está certo.
feedback-axis_moved = O seu z{ $frame } está sobre outra reta, paralela à da solução de referência. Aqui só a direção importa.
feedback-frame_elsewhere = O seu referencial { $frame } não está no mesmo lugar que na solução de referência. A escolha era livre.
feedback-variable_reversed = A sua q{ $joint } cresce no sentido oposto ao da solução de referência. Ambos os sentidos estão certos.
feedback-variable_offset = Onde a q{ $joint } da solução de referência é zero, a sua vale { $offset }. O zero de uma variável de junta é de livre escolha.
feedback-rounded = Os seus valores concordam com a solução de referência dentro da tolerância, mas não exatamente; podem ter sido arredondados.

## Uma resposta errada: o conjunto

feedback-not_equivalent = A sua tabela não descreve este robô, seja qual for a escolha dos referenciais.
feedback-right_robot = A sua tabela descreve o robô certo, mas não cumpre tudo o que o exercício pede.
feedback-not_accepted = A sua tabela não cumpre tudo o que o exercício pede.
feedback-convention_not_asked = O exercício pede a convenção { $asked ->
    [modified] modificada
   *[standard] standard
}; a sua tabela está na { $given ->
    [modified] modificada
   *[standard] standard
}.
feedback-joint_count_wrong = { $given ->
    [0] A sua tabela não tem juntas
    [1] A sua tabela tem uma junta
   *[other] A sua tabela tem { $given } juntas
}; o robô tem { $asked }.
feedback-mirrored = A sua tabela descreve a imagem do robô num espelho: todos os comprimentos e ângulos conferem, mas um deles mede-se no sentido contrário. Confira os sinais com a regra da mão direita.
feedback-entries_imprecise = Nenhum comprimento nem ângulo da sua tabela difere mais do que o arredondamento explica, mas todos os arredondamentos juntos ultrapassam o que o exercício permite. Escreva os ângulos de forma exata, como pi/2 ou 90°, e os comprimentos com mais algarismos.
feedback-lengths_rounded = Vários comprimentos da sua tabela têm o valor certo, mas com algarismos a menos. Escreva-os com mais algarismos; os outros erros aqui indicados não vêm do arredondamento.
feedback-base_axis_missed = O seu z0 não está sobre o eixo da junta 1.
feedback-base_origin_missed = A origem do seu referencial 0 não está onde o exercício a quer.
feedback-base_frame_missed = O seu referencial 0 não é o que o exercício prescreve.
feedback-tool_point_missed = A origem do seu último referencial não está no ponto marcado.
feedback-tool_axis_missed = O eixo z do seu último referencial não está sobre o eixo da última junta.
feedback-tool_frame_missed = O seu último referencial não é o que o exercício prescreve.
feedback-zero_missed = Na configuração da figura, todas as variáveis de junta deveriam ser zero; as suas não são.
feedback-direction_missed = As variáveis de junta deveriam crescer no sentido das setas da figura; nem todas as suas o fazem.
feedback-whole_table = Um mesmo erro percorre toda a tabela.
feedback-columns_throughout = As colunas a e α não condizem com a convenção que a tabela declara.
feedback-columns_in_disorder = As colunas da tabela estão noutra ordem.
feedback-angles_throughout = Os ângulos da tabela não estão na unidade declarada.
feedback-lengths_throughout = Os comprimentos da tabela não estão na unidade declarada.
feedback-turns_throughout = Os ângulos de junta crescem no sentido errado em toda a tabela.
feedback-twists_throughout = Os ângulos de torção α têm o sinal errado em toda a tabela.
feedback-twists_out_of_place = Os ângulos de torção α da tabela não estão nas linhas a que pertencem.
feedback-names_throughout = Uma dimensão tem o nome errado na sua tabela.
feedback-parameter_unknown = O robô não tem dimensão chamada { $name }. As suas dimensões são: { $known }.
feedback-names_asked = As dimensões do robô não têm valores aqui. Escreva os seus nomes: { $known }.

## Uma resposta errada: as linhas

feedback-one_of_these = Apenas um dos pontos seguintes é o erro; a tabela, por si só, não mostra qual.
feedback-row_wrong = A linha { $row } não está certa.
feedback-twist_wrong = Linha { $row }: a torção α, o ângulo de z{ $before } a z{ $row }, não está certa.
feedback-length_wrong = Linha { $row }: o comprimento a, a distância de z{ $before } a z{ $row }, não está certo.
feedback-offset_wrong = Linha { $row }: o deslocamento d, a distância de x{ $before } a x{ $row } ao longo de z, não está certo.
feedback-angle_wrong = Linha { $row }: o ângulo θ, de x{ $before } a x{ $row } em torno de z, não está certo.
feedback-sign_wrong = Linha { $row }: um sinal está ao contrário. Verifique: { $cells }.
feedback-joint_type_wrong = Linha { $row }: o tipo da junta não está certo.
feedback-variable_zero_wrong = Linha { $row }: na configuração da figura, a variável de junta não é zero.
feedback-variable_direction_wrong = Linha { $row }: a variável de junta cresce no sentido contrário ao da seta da figura.
feedback-row_missing = Falta uma linha { $after ->
    [0] antes da linha 1
   *[other] depois da linha { $after }
}.
feedback-row_not_needed = A linha { $row } está a mais.
feedback-rows_out_of_order = As linhas { $row } e { $other } estão fora de ordem.

## O que a tornaria certa

repair-convention = Lida na convenção { $meant ->
    [modified] modificada
   *[standard] standard
}, a sua tabela estaria certa; foi declarada a { $declared ->
    [modified] modificada
   *[standard] standard
}.
repair-angles_in_degrees = Os ângulos estão em graus, mas a tabela declara radianos.
repair-angles_in_radians = Os ângulos estão em radianos, mas a tabela declara graus.
repair-length_unit = Os comprimentos estão numa unidade diferente da declarada: milímetros em vez de metros, por exemplo.
repair-columns_late = As colunas a e α estão uma linha abaixo, como na outra convenção. A que elo pertence cada linha?
repair-columns_early = As colunas a e α estão uma linha acima, como na outra convenção. A que elo pertence cada linha?
repair-twists_late = A coluna α está uma linha abaixo; a está no seu lugar. Numa linha, a e α pertencem ao mesmo elo.
repair-twists_early = A coluna α está uma linha acima; a está no seu lugar. Numa linha, a e α pertencem ao mesmo elo.
repair-columns_exchanged = As colunas { $one } e { $other } estão trocadas. Compare a ordem das colunas com a dos seus apontamentos.
repair-columns_reordered = O que está em α pertence a { $alpha }, o que está em a pertence a { $a } e o que está em d pertence a { $d }. Compare a ordem das colunas com a dos seus apontamentos.
repair-parameter_misnamed = { $name } não é uma dimensão deste robô. A qual da figura se refere?
repair-parameters_swapped = { $name } e { $other } estão trocadas. Compare-as com a figura.
repair-alpha_sign = Linha { $row }: α tem o sinal errado. Rode z{ $before } até z{ $row } em torno de x, pela regra da mão direita.
repair-alpha_value = Linha { $row }: α tem um valor errado. Veja de novo como z{ $before } e z{ $row } ficam um em relação ao outro.
repair-turns_all_reversed = Todos os ângulos de junta crescem no sentido errado. Rode em torno de z com a mão direita, não com a esquerda.
repair-twists_all_reversed = Todos os α têm o sinal errado. Rode um eixo z até ao seguinte em torno de x com a mão direita, não com a esquerda.
repair-a_sign = Linha { $row }: a tem o sinal errado. Mede-se no sentido de x.
repair-d_sign = Linha { $row }: d tem o sinal errado. Mede-se no sentido de z.
repair-twists_swapped = Linhas { $row } e { $other }: os valores de α estão trocados.
repair-a_d_swapped = Linha { $row }: a e d estão trocados. a mede-se ao longo de x, d ao longo de z.
repair-a_value = Linha { $row }: a tem um valor errado. Meça sobre a normal comum a z{ $before } e z{ $row }.
repair-a_missing = Linha { $row }: a não deveria ser zero, pois z{ $before } e z{ $row } não se intersetam.
repair-a_not_zero = Linha { $row }: a deveria ser zero, pois z{ $before } e z{ $row } intersetam-se ou coincidem.
repair-d_value = Linha { $row }: d tem um valor errado. Meça ao longo de z, de x{ $before } a x{ $row }.
repair-d_missing = Linha { $row }: falta o deslocamento d ao longo de z, de x{ $before } a x{ $row }.
repair-d_not_zero = Linha { $row }: d deveria ser zero, pois x{ $before } e x{ $row } encontram z no mesmo ponto.
repair-cell_length_unit = Linha { $row }: um comprimento está numa unidade diferente da dos demais.
repair-cell_parameter = Linha { $row }: aqui cabe outra dimensão da figura.
repair-cell_in_degrees = Linha { $row }: um ângulo está em graus, mas a tabela declara radianos.
repair-cell_in_radians = Linha { $row }: um ângulo está em radianos, mas a tabela declara graus.
repair-theta_value = Linha { $row }: o ângulo constante θ tem um valor errado. Rode x{ $before } até x{ $row } em torno de z.
repair-theta_offset = Linha { $row }: em θ é preciso somar à variável outra constante, para que a variável seja zero na configuração da figura.
repair-d_offset = Linha { $row }: em d é preciso somar à variável outra constante, para que a variável seja zero na configuração da figura.
repair-variable_sign = Linha { $row }: a variável de junta cresce no sentido errado. Dê-lhe o sinal oposto.
repair-joint_type = Linha { $row }: esta junta { $joint_type ->
    [prismatic] desliza; a sua variável fica em d
   *[revolute] roda; a sua variável fica em θ
}.
repair-joint_fixed = Linha { $row }: esta junta move-se; falta a sua variável.
repair-joint_moving = Linha { $row }: aqui nada se move; a linha só tem constantes.
repair-rows_swapped = As linhas { $row } e { $other } estão trocadas.
repair-fixed_row_missing = Falta uma última linha sem variável: a que leva da última junta ao ponto marcado ou ao último referencial prescrito.
repair-row_missing = Falta uma linha { $after ->
    [0] antes da linha 1
   *[other] depois da linha { $after }
}.
repair-row_extra = A linha { $row } está a mais.

## Recusado

error-tables_without_value = Não se encontraram valores dos parâmetros para os quais todas as células das duas tabelas tenham valor. Verifique as raízes, os quocientes e as funções inversas.

feedback-frame_wrong = O referencial { $frame } viola uma regra.
feedback-frame_missing = O referencial { $frame } não foi colocado.
feedback-frame_z_not_along_axis = Referencial { $frame }: { rule-z_not_along_axis }
feedback-frame_origin_not_on_axis = Referencial { $frame }: { rule-origin_not_on_axis }
feedback-frame_origin_not_on_common_normal = Referencial { $frame }: { rule-origin_not_on_common_normal }
feedback-frame_origin_not_at_intersection = Referencial { $frame }: { rule-origin_not_at_intersection }
feedback-frame_x_not_across_z = Referencial { $frame }: { rule-x_not_across_z }
feedback-frame_x_not_along_common_normal = Referencial { $frame }: { rule-x_not_along_common_normal }
feedback-frame_x_not_across_both_axes = Referencial { $frame }: { rule-x_not_across_both_axes }
feedback-frame_first_x_misses_axis = Referencial { $frame }: { rule-first_x_misses_axis }
feedback-frame_last_x_misses_axis = Referencial { $frame }: { rule-last_x_misses_axis }
feedback-frames_other_convention = Estes referenciais cumprem as regras da outra convenção.
feedback-frames_not_as_asked = Os referenciais cumprem as regras, mas não estão colocados como o exercício pede.
feedback-frames_right = Os referenciais estão certos.
feedback-repairs_one_cell = Várias alterações corrigiriam, cada uma por si, a tabela; todas estão na célula { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
} da linha { $row }.
feedback-repairs_one_row = Várias alterações corrigiriam, cada uma por si, a tabela; todas estão na linha { $row }.
feedback-repairs_one_column = Várias alterações corrigiriam, cada uma por si, a tabela; todas estão na coluna { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
}.
feedback-repairs_one_kind = { $count } alterações corrigiriam, cada uma por si, a tabela; são todas do mesmo tipo.
