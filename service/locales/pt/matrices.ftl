field-cell_row = Linha de um elemento errado
field-cell_column = Coluna de um elemento errado
field-mistake = O que está errado
field-mended_matrix = A matriz como deveria ser
option-entry_sign = um elemento da rotação tem o sinal errado
option-sine_for_cosine = num elemento da rotação, seno e cosseno foram trocados
option-position_sign = um elemento da posição tem o sinal errado
option-position_missing = falta um elemento da posição
option-position_sine_for_cosine = num elemento da posição, seno e cosseno foram trocados
option-rotation_transposed = a rotação está transposta
option-matrix_other_convention = foi formada na outra convenção
option-link_missing = um elo ficou de fora do produto
given-matrix-with-mistake =
    { $matrix ->
        [link] A matriz da linha { $row }, com um erro
       *[transform] ⁰T_N, com um erro
    }

task-matrix-mistake =
    { $matrix ->
        [link] A tabela está certa. Alguém escreveu a matriz da sua linha { $row }, do referencial { $row } para o anterior, e cometeu um erro.
       *[transform] A tabela está certa. Alguém escreveu ⁰T_N, o produto de todas as suas matrizes, e cometeu um erro.
    } Dê um elemento errado, diga o que está errado nele e escreva a matriz inteira como deveria ser.

feedback-matrix_mistake_place_wrong = Este elemento está certo; o erro está noutro lugar.
feedback-matrix_mistake_name_wrong = O erro é de outro tipo.
feedback-matrix_not_mended = Esta ainda não é a matriz da tabela.
feedback-matrix_mistake_missing =
    { $what ->
        [cell_row] Dê a linha e a coluna de um elemento errado.
        [mistake] Diga o que está errado.
       *[mended_matrix] Escreva a matriz como deveria ser.
    }
