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
        [link] A tabela está certa. Alguém escreveu a matriz da sua linha { $row }, a pose do referencial { $row } no anterior, e cometeu um erro.
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

field-wrong_frame = Referencial com o erro
field-mended_origin = A sua origem como deveria ser
field-mended_x = O seu eixo x como deveria ser
field-mended_y = O seu eixo y como deveria ser
field-mended_z = O seu eixo z como deveria ser
option-z_not_along_axis = z não segue o eixo da sua junta
option-origin_not_on_axis = a origem não está no eixo da sua junta
option-origin_not_on_common_normal = a origem não está na normal comum
option-origin_not_at_intersection = a origem não está onde os dois eixos se intersetam
option-x_not_across_z = x não é perpendicular a z
option-x_not_along_common_normal = x não segue a normal comum
option-x_not_across_both_axes = x não é perpendicular aos dois eixos
option-first_x_misses_axis = x do primeiro referencial não interseta o eixo 1 em ângulo reto
option-last_x_misses_axis = x do último referencial não interseta o último eixo em ângulo reto
option-y_left_handed = o referencial é esquerdo: y não é z × x
given-drawn-frames = Os referenciais tal como estão desenhados

task-frame-mistake =
    { $convention ->
        [standard] Os referenciais da figura deveriam seguir a convenção standard, com z do referencial i ao longo da junta i+1
       *[modified] Os referenciais da figura deveriam seguir a convenção modificada, com z do referencial i ao longo da junta i
    }, mas um deles tem um erro. Que referencial está errado, o que tem de errado e como deveria estar? Os pontos e as direções são dados nas coordenadas da figura; o comprimento de uma direção é livre. { figure-place }

feedback-frame_mistake_place_wrong = Este referencial está certo; o erro está noutro.
feedback-frame_mistake_name_wrong = O erro é de outro tipo.
feedback-frame_not_mended = Com este referencial o desenho ainda viola uma regra.
feedback-frame_mistake_missing =
    { $what ->
        [wrong_frame] Diga que referencial está errado.
        [mistake] Diga o que está errado.
       *[mended_origin] Indique a origem, x, y e z como deveriam ser.
    }
