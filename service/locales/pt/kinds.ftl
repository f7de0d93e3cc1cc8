### Tipos de pergunta: o que se pede e o que se diz das respostas.

field-matrix = Matriz
field-component_order = Ordem das componentes do quaternião
field-quaternion = Quaternião
field-axis = Eixo de rotação
field-angle = Ângulo de rotação
field-angles = Ternos de ângulos
field-middle = No bloqueio de cardan: o ângulo do meio
field-combination = No bloqueio de cardan: que combinação do primeiro e do último ângulo fica determinada
field-value = O seu valor
field-matrix_claim = Esta matriz
field-pose_claim = Esta pose
field-position_claim = Esta posição
field-pose = Pose
option-wxyz = w, x, y, z: o escalar primeiro
option-xyzw = x, y, z, w: o escalar por último
option-sum = a soma: primeiro + último
option-difference = a diferença: primeiro − último
option-rotation = é uma rotação
option-unit_columns = não é uma rotação: uma coluna não tem comprimento 1
option-perpendicular_columns = não é uma rotação: duas colunas não são perpendiculares
option-right_handed = não é uma rotação: as suas colunas formam um triedro esquerdo (determinante −1)
given-rotation = A orientação como matriz de rotação
given-quaternion = A orientação como quaternião unitário
given-axis_angle = A orientação como eixo e ângulo
given-angles = A orientação em ângulos
given-matrix = A matriz
given-frame-pose = Pose do referencial { $end } no referencial { $start }

task-orientation =
    { $given ->
        [angles] Um referencial é rodado de três ângulos em torno dos eixos { $turning ->
            [fixed] fixos
           *[current] correntes
        } { $axes }, nesta ordem.
       *[other] É dada a orientação de um referencial.
    } Escreva-a nas notações indicadas abaixo.{ $ask ->
        [every] {" "}Dos ângulos em torno dos eixos { $asked_turning ->
            [fixed] fixos
           *[current] correntes
        } { $asked_axes } pedem-se todos os ternos: os dois ou, no bloqueio de cardan, o ângulo do meio e a combinação dos outros dois que fica determinada.
        [one] {" "}Dos ângulos em torno dos eixos { $asked_turning ->
            [fixed] fixos
           *[current] correntes
        } { $asked_axes } basta um terno.
       *[none] {""}
    }
task-rotation-check = Esta matriz é uma rotação? Se não for, diga que propriedade das rotações falha.
task-frame-chain = Conhecem-se as poses seguintes. Escreva a pose do referencial { $end } no referencial { $start } como matriz 4×4, comprimentos em { unit-word }.
feedback-orientation_right = Todas as notações descrevem a orientação dada.
feedback-orientation_wrong =
    { $notation ->
        [matrix] A matriz não é a desta orientação.
        [quaternion] O quaternião não é o desta orientação.
        [axis_angle] O eixo e o ângulo não são os desta orientação.
        [angles] Os ângulos não são os desta orientação.
       *[other] Os ângulos não estão todos certos, ou faltam alguns.
    }
feedback-orientation_missing =
    { $notation ->
        [matrix] Falta a matriz.
        [quaternion] Falta o quaternião.
        [axis_angle] Faltam o eixo e o ângulo.
       *[other] Faltam os ângulos.
    }

feedback-rotation_transposed = Esta é a rotação inversa: linhas e colunas, ou o sentido de rotação, foram trocados.
feedback-rotation_order_reversed = As rotações foram multiplicadas na ordem inversa: confundiram-se eixos fixos e eixos correntes.
feedback-rotation_degrees = Um ângulo em graus foi tomado por radianos, ou o contrário.
feedback-rotation_handedness = Tudo roda ao contrário: foi seguida a regra da mão esquerda.
feedback-rotation_half_angle = Este quaternião roda o dobro: leva o seno e o cosseno de metade do ângulo.
feedback-rotation_component_order = Na outra ordem das componentes este quaternião estaria certo.
feedback-rotation_not_unit = O quaternião não tem norma 1.
feedback-rotation_no_axis = O eixo tem comprimento zero.
feedback-rotation_solution_missing = Há um segundo terno com a mesma orientação.
feedback-rotation_solution_twice = Os seus ternos diferem só por voltas completas: são o mesmo. Há outro.
feedback-rotation_family_missing = Há bloqueio de cardan: existem infinitos ternos. Diga que combinação do primeiro e do último ângulo fica determinada.
feedback-rotation_combination = É a outra combinação que fica determinada: a diferença em vez da soma, ou a soma em vez da diferença.
feedback-rotation_not_locked = Não há bloqueio de cardan: exatamente dois ternos têm esta orientação.
feedback-rotation_quadrant = Um ângulo está no quadrante errado, a meia volta: use atan2 em vez de atan.
feedback-rotation_angle_sign = Um ângulo, ou uma combinação de ângulos, tem o sinal errado.
feedback-rotation_rounded = Os elementos estão demasiado arredondados: calcule com mais casas decimais.
feedback-rotation_unit_columns = Isto não é uma rotação: uma coluna não tem comprimento 1.
feedback-rotation_perpendicular_columns = Isto não é uma rotação: duas colunas não são perpendiculares.
feedback-rotation_right_handed = Isto não é uma rotação, mas uma reflexão: o seu determinante é −1.
feedback-claim_right = É verdade para esta matriz.
feedback-claim_not_rotation = Não é uma rotação: verifique os comprimentos das colunas, os ângulos entre elas e o determinante.
feedback-claim_rotation = É mesmo uma rotação: colunas de comprimento 1, perpendiculares, determinante +1.
feedback-claim_other_property = Não é uma rotação, mas esta propriedade verifica-se; é outra que falha.
feedback-chain_right = A pose é a que decorre da cadeia de referenciais.
feedback-chain_wrong = Esta não é a pose que decorre das conhecidas.
feedback-chain_rotation_right = A rotação dela está certa.
feedback-chain_position_right = A posição dela está certa.
feedback-chain_inverted = Esta é a inversa: a pose do primeiro referencial no último.
feedback-chain_not_inverted = Uma pose conhecida foi usada tal como está, embora antes tenha de ser invertida.
feedback-chain_inverse_without_transpose = A inversa de uma pose foi formada com R; é preciso Rᵀ: (Rᵀ, −Rᵀp).
feedback-chain_inverse_position = A posição de uma inversa é −Rᵀp, e não −p.
feedback-chain_order_reversed = Os fatores foram multiplicados na ordem inversa.
feedback-chain_transposed = A rotação está transposta.
feedback-chain_not_rigid = Isto não é um movimento rígido: as suas colunas não são vetores unitários perpendiculares, ou formam um triedro esquerdo (determinante −1), ou a última linha não é 0 0 0 1.
error-euler_axes_unknown = { $axes } não é uma sequência de eixos: três de X, Y, Z, com vizinhos diferentes.
error-component_order_missing = Diga onde está o escalar do quaternião: wxyz ou xyzw.
error-axis_and_angle = Um eixo precisa de um ângulo, e um ângulo precisa de um eixo.
error-family_incomplete = Uma família de ternos precisa das três coisas: o ângulo do meio, a soma ou a diferença, e o seu valor.
error-orientation_empty = Escreva a orientação numa das notações pedidas.
error-mistake_empty = Diga onde está o erro, qual é ou como se corrige.
error-frames_not_connected = As poses conhecidas não levam do referencial { $start } ao referencial { $end }.
error-pose_without_table = Uma pose é a da tabela do próprio estudante ou de ⁰T: peça também uma delas, ou deixe que as regras fixem o zero, o sentido, o referencial 0 e o último referencial.

error-one_notation = Dê a orientação numa só notação: { $known }.
error-name_without_value = O nome { $name } não tem valor aqui.{ $found ->
    [0] {""}
   *[one] {" "}Queria dizer { $close }?
} Conhecem-se { $known }.
error-rate_in_marks = { $text } não é um nome aqui. Queria dizer a velocidade da junta { $suggestion }?
error-expected_not_rotation =
    A matriz esperada não é uma rotação: { $property ->
        [unit_columns] uma coluna não tem comprimento 1.
        [perpendicular_columns] duas colunas não são perpendiculares.
       *[right_handed] é uma reflexão, com determinante −1.
    }

field-solutions = Valores das juntas
field-combinations = Se forem infinitas: a combinação que permanece constante (coeficientes)
option-finite = é alcançada com estes valores das juntas
option-infinite = é alcançada com infinitos valores; estes são alguns
option-out_of_reach = está fora do espaço de trabalho
option-joint_limits = não é alcançada dentro dos limites das juntas
given-target = A pose
given-target-position = A posição da última origem
given-table = A tabela DH, convenção { $convention ->
    [modified] modificada
   *[standard] standard
}

task-inverse-kinematics =
    { $variables ->
        [own] Que valores das suas próprias variáveis das juntas levam o último referencial a este lugar no referencial 0?
       *[given] É dada a tabela do robô. Que valores das juntas levam o seu último referencial a este lugar no referencial 0?
    } { $solutions ->
        [one] Basta uma solução.
       *[all] Dê todas; voltas completas não contam.
    } { $reach ->
        [position] Só importa a posição da última origem, em { unit-word }.
       *[pose] Importam a posição, em { unit-word }, e a orientação.
    }

feedback-joints_right = A resposta está certa: contém tudo o que se pede.
feedback-joints_searched = Para esta pose as soluções foram encontradas por pesquisa; pode haver mais.
feedback-joints_need_table = Os valores são os das suas próprias variáveis: entregue também uma tabela certa.
feedback-claim_wrong = Não é assim: conte de novo quantas soluções alcançam esta pose, se houver alguma.
feedback-joints_wrong = A linha { $row } não alcança a pose.
feedback-joints_twice = As linhas { $other } e { $row } diferem só por voltas completas: são uma só solução.
feedback-joints_missing =
    { $count ->
        [one] Falta uma solução.
       *[other] Faltam { $count } soluções.
    }
feedback-branch_shoulder =
    { $count ->
        [one] O braço também pode alcançar por trás, com o outro ombro.
       *[other] O braço também pode alcançar por trás, com o outro ombro: faltam { $count } soluções deste tipo.
    }
feedback-branch_elbow =
    { $count ->
        [one] O cotovelo também pode dobrar para o outro lado.
       *[other] O cotovelo também pode dobrar para o outro lado: faltam { $count } soluções deste tipo.
    }
feedback-branch_wrist =
    { $count ->
        [one] O punho também pode estar virado.
       *[other] O punho também pode estar virado: faltam { $count } soluções deste tipo.
    }
feedback-branch_other =
    { $count ->
        [one] Há outro ramo de soluções.
       *[other] Há outros { $count } ramos de soluções.
    }
feedback-joints_quadrant = Linha { $row }: q{ $joint } está no quadrante errado, a meia volta. Use atan2 em vez de atan.
feedback-joints_sign = Linha { $row }: q{ $joint } tem o sinal errado.
feedback-joints_degrees = Linha { $row }: tomaram-se graus por radianos, ou o contrário.
feedback-joints_swapped = Linha { $row }: q{ $joint } é 90° menos o valor correto; os argumentos de atan2 foram trocados.
feedback-joints_half_branch = A linha { $row } é a linha { $other } em que só q{ $joint } mudou: noutro ramo mudam com ela outras juntas.
feedback-joints_position_only = A linha { $row } alcança a posição, mas não a orientação.
feedback-joints_orientation_only = A linha { $row } alcança a orientação, mas não a posição.
feedback-joints_limits = A linha { $row } alcança a pose com a junta { $joint } além do limite.
feedback-joints_rounded = A linha { $row } aproxima-se de uma solução, mas não o bastante: calcule com mais casas decimais.
feedback-joints_family_missing = A pose é singular: diga que combinação das variáveis das juntas permanece igual nas soluções.
feedback-joints_taken_off = O que está errado é descontado do que está certo, para que adivinhar não dê pontos: aqui não sobra nada das linhas certas.
feedback-joints_combination_wrong = A combinação { $row } não permanece igual nas soluções.
feedback-joints_combination_zero = A combinação { $row } vale 0 façam as juntas o que fizerem, e não diz nada.
feedback-joints_combination_loose = A combinação { $row } permanece igual nas soluções, mas isso não basta: outros valores das juntas com a mesma combinação não alcançam a pose.
error-pose_frames_free = A pose é dada no referencial 0 e para o último: as regras têm de fixar os dois, base = "frame" e tool = "frame".
error-pose_within_reach = Este braço alcança poses por mais distantes que estejam, pois aqui as juntas prismáticas não têm limites: retire out_of_reach de cases.
error-joint_row_length = Uma linha contém um valor por junta. Necessários: { $expected }; dados: { $given }.
error-joint_rows_empty = Dê os valores das juntas que alcançam a pose.

field-row = Linha com o erro
field-name = O que está errado
field-mended = A linha como deveria ser
field-verdict = As duas tabelas descrevem
field-reason = porque
option-alpha_sign = α tem o sinal errado
option-alpha_value = α tem um valor errado
option-a_sign = a tem o sinal errado
option-d_sign = d tem o sinal errado
option-a_value = a tem um valor errado
option-d_value = d tem um valor errado
option-a_d_swapped = a e d foram trocados
option-a_missing = a é zero, mas não deveria ser
option-a_not_zero = a não é zero, mas deveria ser
option-d_missing = falta um deslocamento d
option-d_not_zero = d não é zero, mas deveria ser
option-angles_in_degrees = todos os ângulos em graus, embora se declarem radianos
option-angles_in_radians = todos os ângulos em radianos, embora se declarem graus
option-cell_in_degrees = um ângulo em graus entre radianos
option-cell_in_radians = um ângulo em radianos entre graus
option-cell_length_unit = um comprimento noutra unidade
option-cell_parameter = é usada outra dimensão da figura
option-columns_early = a e α uma linha acima
option-columns_late = a e α uma linha abaixo
option-columns_exchanged = duas colunas trocadas
option-columns_reordered = colunas noutra ordem
option-convention = está declarada a convenção errada
option-fixed_row_missing = falta a última linha, sem variável
option-joint_fixed = uma junta sem a sua variável
option-joint_moving = uma variável onde nada se move
option-joint_type = o tipo da junta está errado
option-length_unit = todos os comprimentos noutra unidade
option-parameter_misnamed = um nome que não está na figura
option-parameters_swapped = duas dimensões trocadas
option-row_extra = uma linha a mais
option-row_missing = falta uma linha
option-rows_swapped = duas linhas trocadas
option-theta_offset = a constante somada à variável θ está errada
option-d_offset = a constante somada à variável d está errada
option-theta_value = a constante θ tem um valor errado
option-turns_all_reversed = todos os ângulos de junta crescem no sentido errado
option-twists_all_reversed = todos os α têm o sinal errado
option-twists_early = só α uma linha acima
option-twists_swapped = α de duas linhas trocados
option-twists_late = só α uma linha abaixo
option-variable_sign = uma variável de junta cresce no sentido errado
option-same = o mesmo robô
option-different = robôs diferentes
option-axis_reversed = os referenciais diferem: um eixo z, ou uma variável de uma junta, está invertido
option-x_turned = os referenciais diferem: um eixo x está rodado, e a variável é zero noutro lugar
option-origin_moved = os referenciais diferem: uma origem está noutro lugar, ou o primeiro ou o último referencial está colocado de outra forma
option-other_convention = os referenciais diferem: a convenção é outra
option-twist = o ângulo entre dois eixos é diferente
option-length = a distância entre dois eixos é diferente
option-offset = um deslocamento ao longo de um eixo, ou um ângulo constante em torno dele, é diferente
given-table-with-mistake = A tabela com um erro ({ $convention ->
    [modified] convenção modificada
   *[standard] convenção standard
})
given-first-table = A primeira tabela ({ $convention ->
    [modified] convenção modificada
   *[standard] convenção standard
})
given-second-table = A segunda tabela ({ $convention ->
    [modified] convenção modificada
   *[standard] convenção standard
})

task-find-mistake = Esta tabela deveria descrever o robô da figura, mas uma linha tem um erro. Qual é a linha, o que está errado e como deveria ser?
task-compare-tables = Estas duas tabelas descrevem o mesmo robô, seja qual for a escolha dos referenciais? Diga porquê.

feedback-mistake_found = Encontrou o erro, nomeou-o e corrigiu-o.
feedback-mistake_row_wrong = O erro está noutra linha.
feedback-mistake_name_wrong = O erro é de outro tipo.
feedback-mistake_not_mended = Com esta linha a tabela ainda não descreve o robô.
feedback-mistake_missing =
    { $what ->
        [row] Diga em que linha está o erro.
        [name] Diga o que está errado.
       *[mended] Escreva a linha como deveria ser.
    }
feedback-tables_right = Certo, e pela razão certa.
feedback-tables_same = São o mesmo robô: só os referenciais foram escolhidos de outro modo.
feedback-tables_different = São robôs diferentes: nenhuma escolha de referenciais transforma uma tabela na outra.
feedback-tables_reason_wrong = O veredicto está certo, mas não por esta razão.
feedback-tables_reason_missing = O veredicto está certo; diga também porquê.
error-row_unknown = Dê o número de uma linha, de 1 a { $count }.
error-column_unknown = Dê o número de uma coluna, de 1 a { $count }.
error-vector_length = O vetor tem { $expected } componentes, não { $given }.
error-joint_variable_in_number = { $name } é uma variável de junta, e aqui pede-se um número: ponha o seu valor.
error-no_mistake_does_harm = Nenhum destes erros altera este robô segundo as suas regras.
error-frame_mistakes_not_shown = Os referenciais deste robô não podem mostrar nenhum destes erros. O que podem mostrar: { $known }.
error-key_given_away = Esta parte mostra uma tabela; um exercício que pede a tabela não pode tê-la.
error-not_plantable = Nenhum dos erros pedidos altera este robô.

field-frame = Os helicoides são escritos no
field-order = Ordem de v e ω
field-screws = Helicoides, uma linha por junta
field-home = Pose inicial M
option-space = referencial fixo (espaço)
option-body = referencial da ferramenta na posição zero (corpo)
option-linear_first = v, ω: a parte linear primeiro
option-angular_first = ω, v: a parte angular primeiro

task-screws = Escreva o robô como produto de exponenciais: os helicoides das juntas 1 a { $n } e a pose inicial M, comprimentos em { unit-word }. Escolha o referencial, a posição zero e o sentido de cada eixo dentro das regras.

feedback-screws_right = Os helicoides e a pose inicial descrevem este robô.
feedback-screws_right_robot = Este produto de exponenciais descreve o robô certo, mas não cumpre tudo o que o exercício pede.
feedback-screws_wrong = Este produto de exponenciais não descreve o robô, sejam quais forem o referencial, o zero e os sentidos.
feedback-screw_not_unit = Junta { $joint }: ω de uma junta rotativa é um vetor unitário.
feedback-screw_pitch = Junta { $joint }: v tem uma componente ao longo de ω; uma junta rotativa não avança ao longo do eixo.
feedback-screw_joint_type = Junta { $joint }: uma prismática tem ω = 0 e um vetor unitário v; uma rotativa tem ω de comprimento 1.
feedback-screw_halves = v e ω estão trocados: na outra ordem as linhas estariam certas.
feedback-screw_moment_sign =
    { $joint ->
        [0] Todos os v têm o sinal errado
       *[other] Junta { $joint }: v tem o sinal errado
    }: v = −ω × p, com p um ponto qualquer do eixo.
feedback-screw_other_frame = Estes são os helicoides no outro referencial: confundiram-se espaço e corpo.
feedback-screw_home_inverted = A pose inicial está invertida.
feedback-screw_sign_or_home = Ou v tem o sinal errado em toda a parte (v = −ω × p, com p um ponto qualquer do eixo), ou a pose inicial está invertida.
feedback-screw_home = Os helicoides estão certos; a pose inicial M não.
feedback-screw_not_rigid = A pose inicial não é um movimento rígido: as suas colunas não são vetores unitários perpendiculares, ou formam um triedro esquerdo (determinante −1), ou a última linha não é 0 0 0 1.
feedback-screw_length_unit = Os comprimentos estão noutra unidade que não a do robô: na unidade dele as linhas estariam certas.
feedback-screw_exchanged = As linhas da junta { $joint } e da seguinte estão trocadas.
feedback-screw_reversed = As linhas estão na ordem inversa: a primeira é a da junta mais próxima da base.
feedback-screws_relation_wrong = Os eixos das juntas { $joint } e { $next } não estão dispostos entre si como na figura.
error-screw_count =
    O robô tem { $expected ->
        [one] { $expected } junta
       *[other] { $expected } juntas
    }, e { $given ->
        [one] foi dado { $given } helicoide
       *[other] foram dados { $given } helicoides
    }.

error-screw_too_large = Um número é demasiado grande para um robô; o maior é { $limit }.

field-jacobian = Jacobiana, uma coluna por junta
field-forces = Binários e forças nas juntas
given-configuration = A configuração
given-wrench = Força e momento que a ferramenta exerce

task-jacobian =
    { $variables ->
        [own] Tome a sua própria tabela e as suas próprias variáveis das juntas nestes valores.
       *[given] São dadas a tabela do robô e uma configuração.
    } { $ask ->
        [jacobian] Escreva a jacobiana geométrica da última origem, comprimentos em { unit-word }, por radiano.
        [forces] Que binários e forças nas juntas, τ = Jᵀ(f, m), correspondem à força e ao momento na última origem, comprimentos em { unit-word }?
       *[both] Escreva a jacobiana geométrica da última origem, comprimentos em { unit-word }, por radiano, e os binários e forças nas juntas τ = Jᵀ(f, m).
    } { $frame ->
        [end] Todos os vetores estão nos eixos do último referencial.
       *[base] Todos os vetores estão nos eixos do referencial 0.
    }

feedback-jacobian_right = Está tudo certo.
feedback-jacobian_follows_table = Isto decorre da sua tabela e vale os seus pontos, embora a tabela não esteja certa.
feedback-jacobian_needs_table = A jacobiana é a da sua própria tabela: entregue também a tabela, com todas as juntas.
feedback-jacobian_missing =
    { $what ->
        [jacobian] Falta a jacobiana.
       *[forces] Faltam os binários e forças nas juntas.
    }
feedback-jacobian_wrong = Nem todas as colunas da jacobiana estão certas.
feedback-forces_wrong = Nem todos os binários e forças nas juntas estão certos.
feedback-jacobian_next_axis =
    { $count ->
        [1] A coluna { $joint } usa o eixo de uma junta vizinha: veja que z pertence a cada junta na sua convenção.
       *[other] As colunas { $joints } usam o eixo de uma junta vizinha: veja que z pertence a cada junta na sua convenção.
    }
feedback-jacobian_point_swapped =
    { $count ->
        [1] Coluna { $joint }: a parte linear é z × (pₙ − p), e não z × (p − pₙ).
       *[other] Colunas { $joints }: a parte linear é z × (pₙ − p), e não z × (p − pₙ).
    }
feedback-jacobian_prismatic =
    { $count ->
        [1] Coluna { $joint }: uma prismática dá (z, 0); uma rotativa, (z × (pₙ − p), z).
       *[other] Colunas { $joints }: uma prismática dá (z, 0); uma rotativa, (z × (pₙ − p), z).
    }
feedback-jacobian_other_frame =
    { $count ->
        [0] Esta é a jacobiana nos eixos do outro referencial.
        [1] A coluna { $joint } está nos eixos do outro referencial.
       *[other] As colunas { $joints } estão nos eixos do outro referencial.
    }
feedback-jacobian_rows_exchanged = As linhas lineares e angulares foram trocadas.
feedback-jacobian_spatial = Esta é a velocidade do ponto na origem do referencial 0; pede-se a origem do último referencial.
feedback-forces_sign = Todos os sinais estão invertidos: pede-se τ = Jᵀ(f, m), com a força e o momento dados.
feedback-forces_other_frame = A força e o momento foram tomados nos eixos do outro referencial.
feedback-forces_rows_exchanged = Força e momento foram trocados.
feedback-forces_spatial = Supôs-se que a força atua na origem do referencial 0.
error-row_order_missing = Diga que linhas vêm primeiro: (v, ω) ou (ω, v).
error-jacobian_empty = Dê a jacobiana ou os binários e forças nas juntas.

error-wrench_missing = Os binários e forças nas juntas correspondem a uma força e a um momento: dê “wrench”.
