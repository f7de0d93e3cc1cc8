# Valores das juntas, poses, helicoides e tabelas numéricas.

error-target_unanswered = O cálculo parou ao fim de { $seconds } s, com { $answered } dos alvos respondidos. Peça este e os seguintes noutro pedido.
error-joints_wrong_length =
    { $expected ->
        [one] A tabela tem uma junta, mas foi dada uma configuração com { $given ->
            [one] { $given } valor
           *[other] { $given } valores
        }.
       *[other] A tabela tem { $expected } juntas, mas foi dada uma configuração com { $given ->
            [one] { $given } valor
           *[other] { $given } valores
        }.
    }
error-joints_malformed = Os valores das juntas são números: uma configuração [q1, …, qn] ou uma lista de configurações do mesmo comprimento.
error-joint_not_finite = O valor da junta { $joint } não é um número finito.
error-result_not_finite = O resultado é demasiado grande para um número de precisão dupla. Os comprimentos e os valores das juntas devem ser menores.
error-entry_not_finite = { $cell } não é um número finito.
error-value_undefined = Com estes parâmetros a expressão não tem valor finito.

error-pose_not_numbers = Uma pose é uma matriz 4×4 de números.
error-pose_wrong_shape = Uma pose é uma matriz 4×4 de números; esta é { $shape }.
error-pose_not_finite = Este elemento não é um número finito.
error-pose_in_one_row = Dezasseis números numa só lista não são uma pose: escreva quatro linhas de quatro números, [[…], […], […], [0, 0, 0, 1]].
error-inertia_in_one_row = Uma inércia não se escreve numa só lista: escreva três linhas de três, [[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]], Ixy = −∫ x y dm.
error-pose_bottom_row = A última linha de uma pose é 0, 0, 0, 1.
error-pose_not_orthonormal = A parte de rotação não é ortonormal (desvio de { $error }): as colunas devem ser vetores unitários perpendiculares, com tolerância de { $tolerance }. Dê mais casas decimais ou, na cinemática inversa, uma tolerância (`tolerance`).
error-pose_left_handed = A parte de rotação forma um triedro esquerdo: o determinante é −1, uma reflexão. Deve ser +1.

error-notation_wrong_length =
    { $expected ->
        [one] { $what } recebe um número: { $names }.
       *[other] { $what } recebe { $expected } números: { $names }.
    }
error-notation_not_finite = { $name } de { $what } não é um número finito.
error-quaternion_length = Um quaternião de norma nula ou demasiado grande não é uma orientação. Dê um quaternião unitário.
error-axis_length = Um eixo de comprimento nulo ou demasiado grande não tem direção. Dê um vetor unitário.

error-screw_not_finite = Um helicoide é formado por seis números finitos.
error-screw_not_unit = A parte angular do helicoide de uma junta rotativa e a parte linear do de uma junta prismática têm de ter comprimento 1.
error-screw_has_pitch = Este helicoide tem passo de { $pitch } por radiano. Uma junta ou roda ou desliza.
error-screw_of_other_type = O helicoide { $joint } não é do tipo indicado: uma junta rotativa tem parte angular, uma prismática não.
error-tree_after_unknown = A linha { $row } segue o referencial { $given }: tem de seguir a base (0) ou uma linha anterior. Não são admitidas cadeias fechadas.
error-frame_unknown = Não existe o referencial { $given }; o último é o { $count }.
