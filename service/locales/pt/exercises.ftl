### Exercícios: o que se pede, o que se diz das respostas, o que uma definição não pode conter.

## A figura em palavras

figure-title = { $title }: juntas, eixos e cotas
figure-coordinates = { $joints ->
    [one] Um robô com uma junta.
   *[other] Um robô com { $joints } juntas, uma após a outra, contadas a partir da base.
} As posições são dadas em { unit-word } como (X; Y; Z). { figure-place }
figure-place = X aponta { $x ->
    [back] para trás, Y para a esquerda
    [left] para a esquerda, Y para a frente
    [front] para a frente, Y para a direita
   *[right] para a direita, Y para trás
}, Z para cima; { $fixed ->
    [ground] o robô está fixado
   *[joint] o corpo da junta 1 está
} em { $at }.
figure-joint-revolute = A junta { $joint } é rotativa. O seu corpo está em { $place }; o seu eixo { $course ->
    [vertical] é vertical
    [sideways] vai da esquerda para a direita
    [depthways] vai da frente para trás
   *[oblique] tem a direção { $direction }
}.
figure-joint-revolute-signed = A junta { $joint } é rotativa. O seu corpo está em { $place }; o seu eixo { $course ->
    [vertical] é vertical
    [sideways] vai da esquerda para a direita
    [depthways] vai da frente para trás
   *[oblique] é oblíquo
}. Pela regra da mão direita, a variável da junta é positiva em torno da direção { $direction }.
figure-joint-prismatic = A junta { $joint } é prismática. O seu corpo está em { $place }; a sua direção { $course ->
    [vertical] é vertical
    [sideways] vai da esquerda para a direita
    [depthways] vai da frente para trás
   *[oblique] é { $direction }
}.
figure-joint-prismatic-signed = A junta { $joint } é prismática. O seu corpo está em { $place }; a sua direção { $course ->
    [vertical] é vertical
    [sideways] vai da esquerda para a direita
    [depthways] vai da frente para trás
   *[oblique] é oblíqua
}. A variável da junta é positiva ao longo da direção { $direction }.
figure-dimension = { $name } mede { $length } { $unit }, { $course ->
    [vertical] na vertical
    [sideways] da esquerda para a direita
    [depthways] da frente para trás
   *[oblique] obliquamente
}, entre { $start } e { $end }.
figure-point = O ponto { $name } está em { $place }.
figure-frame = O referencial { $number } tem a origem em { $place }; o seu eixo x aponta segundo { $x }, o eixo z segundo { $z }.
figure-not-to-scale = O desenho não está à escala: nele, { $names } { $count ->
    [one] não tem o comprimento dado
   *[other] não têm os comprimentos dados
} aqui.
figure-note = não está à escala

## O que é livre e o que é fixado

rule-convention-any = Aceitam-se a convenção standard e a modificada.
rule-convention-standard = Escreva a tabela na convenção standard.
rule-convention-modified = Escreva a tabela na convenção modificada.
rule-base-free = O referencial 0 pode ficar em qualquer lugar da base.
rule-base-axis = O eixo z do referencial 0 está sobre o eixo da junta 1, em qualquer dos sentidos.
rule-base-origin = A origem do referencial 0 é o ponto marcado O0; as direções são à sua escolha.
rule-base-frame = O referencial 0 é prescrito; a figura mostra-o.
rule-tool-free = O último referencial pode ficar em qualquer lugar do último elo.
rule-tool-point = A origem do último referencial está no ponto marcado { $points }.
rule-tool-axis = O eixo z do último referencial está sobre o eixo da última junta, em qualquer dos sentidos; a sua origem pode ficar em qualquer ponto dele.
rule-tool-frame = O último referencial é prescrito; a figura mostra-o.
rule-zero-free = Cabe-lhe escolher onde cada variável das juntas é zero.
rule-zero-figure = Na configuração da figura, todas as variáveis das juntas são zero.
rule-direction-free = Cabe-lhe escolher o sentido de cada eixo.
rule-direction-figure = As variáveis das juntas são positivas no sentido das setas da figura.

## O que se pede

task-schematic = Descreva a estrutura: o tipo de cada junta e como o eixo de cada junta está em relação ao eixo da seguinte.
task-table = Escolha os referenciais e escreva a tabela DH. As células podem conter { $names }, números e as variáveis das juntas q1 a q{ $n }.
task-link-matrices = Para cada linha da sua tabela, escreva a matriz do elo, isto é, a pose do referencial i no referencial i−1. Pode abreviar cos(q1) como c1 e sin(q1 + q2) como s12.
task-transform = Escreva ⁰T, a pose do último referencial no referencial 0, em forma fechada.
task-pose = Calcule a sua ⁰T para { $joints } e para as dimensões dadas aqui, com os comprimentos em { unit-word }.
task-workspace-axis = Até que distância mínima e até que distância máxima do eixo da junta 1 se pode levar { $point }? { $limits ->
    [none] Cada junta pode tomar qualquer valor.
   *[some] As juntas respeitam os seus limites: { $ranges }; na figura, { $drawn }.
} Dê os dois raios em { unit-word }.
task-workspace-point = Quais são a menor e a maior distância entre { $point } e { $origin }? { $limits ->
    [none] Cada junta pode tomar qualquer valor.
   *[some] As juntas respeitam os seus limites: { $ranges }; na figura, { $drawn }.
} Dê os dois raios em { unit-word }.

## Comentários sobre as partes

feedback-part_wrong = Esta parte ainda não está certa.
feedback-schematic_right = A estrutura está certa.
feedback-schematic_joint_count = Indicou { $given ->
    [one] uma junta
   *[other] { $given } juntas
}; conte de novo quantas se podem mover.
feedback-schematic_joint_type = O tipo da junta { $joint } não está certo.
feedback-schematic_relation = A posição relativa dos eixos { $first } e { $second } não está certa.
feedback-schematic_angle_right = Eixos { $first } e { $second }: o ângulo entre eles está certo, mas não o facto de se intersetarem ou não.
feedback-schematic_meeting_right = Os eixos { $first } e { $second } intersetam-se de facto, mas não sob esse ângulo.
feedback-matrices_right = As matrizes dos elos estão certas.
feedback-matrices_follow_table = As matrizes dos elos decorrem da sua tabela e recebem os seus pontos, embora a tabela não esteja certa.
feedback-matrices_right_not_from_table = As matrizes dos elos estão certas para o robô, embora não decorram da sua tabela.
feedback-matrices_product_wrong = Multiplicadas, as suas matrizes dos elos não descrevem este robô.
feedback-matrix_missing = Falta a matriz { $matrix }.
feedback-matrix_wrong = A matriz { $matrix } não corresponde à linha { $matrix } da sua tabela.
feedback-matrix_cells_wrong = A matriz { $matrix } difere da linha { $matrix } da sua tabela nestas células (linha,coluna): { $cells }.
feedback-matrix_inverse = A matriz { $matrix } está invertida: é a pose do referencial i−1 no referencial i.
feedback-matrix_rotation_transposed = A rotação na matriz { $matrix } está transposta.
feedback-matrix_other_convention = A matriz { $matrix } foi formada pela regra da outra convenção.
feedback-matrix_without_variable = A matriz { $matrix } foi escrita para a variável da junta igual a zero; mantenha a variável.
feedback-matrix_of_other_row = A matriz { $matrix } é a da linha { $other }.
feedback-matrix_not_rigid = A matriz { $matrix } não é um movimento rígido: as colunas não são vetores unitários perpendiculares, ou formam um triedro esquerdo (determinante −1), ou a última linha não é 0 0 0 1.
feedback-transform_right = ⁰T está certa.
feedback-transform_follows_table = ⁰T decorre da sua tabela e recebe os seus pontos, embora a tabela não esteja certa.
feedback-transform_right_not_from_table = ⁰T está certa para o robô, embora não decorra da sua tabela.
feedback-table_says_little = A sua tabela tem menos de metade dos comprimentos e dos ângulos α necessários para descrever este robô; o que dela decorre recebe só uma parte dos pontos, e de uma tabela de zeros, nenhum.
feedback-transform_wrong = Esta ⁰T não descreve o robô.
feedback-transform_rotation_right = A rotação em ⁰T está certa.
feedback-transform_position_right = A posição em ⁰T está certa.
feedback-transform_cells_wrong = ⁰T difere da sua tabela nestas células (linha,coluna): { $cells }.
feedback-transform_not_rigid = ⁰T não é um movimento rígido: as colunas não são vetores unitários perpendiculares, ou formam um triedro esquerdo (determinante −1), ou a última linha não é 0 0 0 1.
feedback-transform_inverse = Esta é a inversa de ⁰T: a pose do referencial 0 no último referencial.
feedback-transform_rotation_transposed = A rotação em ⁰T está transposta.
feedback-transform_order_reversed = As matrizes dos elos foram multiplicadas em ordem inversa.
feedback-transform_links_missing = Este é o produto só até ao referencial { $last }; continue até ao último referencial.
feedback-pose_right = A pose está certa.
feedback-pose_follows_table = A pose decorre da sua tabela e recebe os seus pontos, embora a tabela não esteja certa.
feedback-pose_wrong = Esta pose não é a que a sua tabela dá para esses valores das juntas.
feedback-pose_last_row = A última linha de uma pose é 0 0 0 1; com outra, a matriz não é uma pose e não recebe pontos.
feedback-pose_rotation_right = A rotação está certa.
feedback-pose_position_right = A posição está certa.
feedback-pose_inverse = Esta é a inversa da pose.
feedback-pose_rotation_transposed = A rotação está transposta.
feedback-pose_degrees_as_radians = Os senos e cossenos foram calculados com graus tomados como radianos.
feedback-workspace_right = Os dois raios estão certos.
feedback-workspace_inner_wrong = O raio interior não está certo.
feedback-workspace_outer_wrong = O raio exterior não está certo.
feedback-workspace_swapped = O raio interior e o exterior estão trocados.
feedback-workspace_diameters = Estes são diâmetros; pedem-se os raios.
feedback-workspace_other_length_unit = Os raios estão certos noutra unidade; pedem-se em { unit-word }.

## Por que uma resposta não pode ser avaliada

problem-note-ungraded = Esta resposta não foi avaliada e não gasta nenhuma tentativa.
error-answer_empty = Nada foi entregue. O exercício pede { $known }.
error-part_not_asked = O exercício não pede { $part }; pede { $known }.
error-link_matrices_count = A tabela tem { $expected ->
    [one] uma linha
   *[other] { $expected } linhas
}, mas { $given ->
    [one] foi dada uma matriz
   *[other] foram dadas { $given } matrizes
}. Dê uma para cada linha; null omite uma.
error-link_matrices_need_table = Sem a tabela, as matrizes dos elos são julgadas pelo seu produto. Dê-as todas.
error-pose_needs_table = A pose é a da sua própria tabela. Entregue também a tabela.
error-matrix_not_4x4 = Uma matriz tem quatro linhas de quatro células.
error-joint_variable_unknown = Não existe { $name }; o robô tem { $joints ->
    [one] uma junta
   *[other] { $joints } juntas
}.{ $summed ->
    [0] {""}
   *[other] {" "}Uma soma escreve-se por extenso: { $sum }.
}
error-short_form_unknown = { $name } é lido como cosseno ou seno, mas nem todos os seus índices são juntas rotativas; o robô tem { $joints ->
    [one] uma junta
   *[other] { $joints } juntas
}.
error-radius_negative = Um raio não pode ser negativo.
error-schematic_fixed_joint = A estrutura enumera as juntas que se movem: rotativas ou prismáticas.
error-schematic_relations_count = { $joints ->
    [one] Uma junta tem
   *[other] { $joints } juntas têm
} { $expected ->
    [one] um par
   *[other] { $expected } pares
} de eixos vizinhos. Dê uma relação para cada par.
error-seed_invalid = Uma semente é um texto ou um número inteiro.
error-seed_too_long = Uma semente tem no máximo { $limit } caracteres.
error-exercise_unknown = Não há exercício { $id }. Disponíveis: { $known }.
error-language_unknown = A língua { $language } não está disponível aqui. Disponíveis: { $known }.

## Por que uma definição não pode ser lida

error-exercise_file_missing = Falta o ficheiro exercise.toml.
error-exercise_file_not_toml = Isto não é TOML: { $reason }
error-exercise_key_missing = Falta { $key }.
error-exercise_key_unknown = { $key } não é uma chave conhecida. As chaves conhecidas são { $known }.
error-exercise_value_type = { $key } deve ser { expected-value }.
error-exercise_value_unknown = { $key } deve ser um destes valores: { $known }.
error-exercise_robot_unknown = O catálogo não contém o robô { $robot }. Contém { $known }.
error-exercise_limits_reversed = Os limites da junta { $joint } são dados como [mínimo, máximo].
error-exercise_limits_unknown = O catálogo não conhece os limites deste robô.
error-folder_missing = Não há pasta { $folder }.
error-exercise_id_invalid = { $id } não é identificador de exercício; um identificador tem letras, algarismos e hífens simples.
error-exercise_exists = O exercício { $id } já existe.
error-source_unreadable = O ficheiro não pode ser lido: { $reason }
error-robot_and_reference = Dê robot ou [reference], não os dois.
error-statement_missing = Falta o enunciado na língua { $language }.
error-statement_name_unknown = { $name } não é dimensão do robô nem ponto ou cota da figura.
error-misconception_unknown = { $name } não é um erro da lista. Disponíveis: { $known }.
error-nothing_asked = Um exercício tem de pedir alguma coisa: acrescente uma parte.
error-part_twice = { $kind } é pedido duas vezes.
error-points_not_positive = Uma parte vale mais que zero pontos.
error-draw_empty = Não há valor a sortear: “from” não pode ser maior que “to”, e “step” deve ser positivo.
error-draw_too_large = Um sorteio tem no máximo { $limit } valores.
error-variants_too_many = Há no máximo { $limit } variantes.
error-tolerance_out_of_range = { $name } fica entre 0 e 0,1.
error-name_invalid = { $name } não é nome de dimensão; um nome é como L1.
error-width_out_of_range = A largura fica entre 320 e 960.
error-unknown_point = Não há ponto { $name }. Disponíveis: { $known }.
error-unknown_frame = Esse referencial não existe: são numerados de 0 a { $last }.
error-unknown_joint = A junta { $joint } não existe: são numeradas de 1 a { $last }.
error-point_without_form = Um ponto é dado por frame e at; por between e ratio; por from e by; ou por from, joint e distance.
error-joint_off_axis = O ponto { $point } não está sobre o eixo da junta { $joint }.
error-dimension_disagrees = Os pontos de { $name } distam { $length }, mas { $name } é { $value }.
error-dimension_too_short = { $name } é { $length }, demasiado curta para ser mostrada na figura: é menos de um milionésimo do tamanho do robô. Dê-lhe outro valor ou escreva 0 no seu lugar.
error-posture_not_zero = Com zero = figure diz-se aos estudantes que na configuração da figura todas as variáveis das juntas são zero: desenhe o robô nessa configuração (posture 0 para cada junta) ou deixe os zeros livres.
error-tool_point_unmarked = Com tool = point a última origem deve ficar num ponto marcado, mas nenhum dos pontos marcados é a última origem da solução de referência. Marque a origem do referencial { $last }.
error-gripper_without_direction = A garra e o ponto do qual ela se afasta são o mesmo.
error-jaws_along_gripper = Os dedos ficam um ao lado do outro, perpendiculares à garra.

error-name_unknown = { $name } não é nenhuma das dimensões deste exercício.{ $unit ->
    [0] {""}
   *[one] {" "}As unidades não se escrevem nas células: se { $name } é uma delas, omita-a.
}{ $found ->
    [0] {""}
   *[one] {" "}Queria dizer { $close }?
} Conhecem-se { $known }.
error-need_unmet = Com estas regras nenhuma resposta precisa de { $name }: podem escolher-se referenciais em que não aparece. { $rules ->
    [none] Nenhuma regra o muda: retire-o de needs.
   *[other] Qualquer uma destas regras basta para que seja necessário: { $rules }.
}
error-need_unknown = { $name } não é nenhuma dimensão da tabela. As suas dimensões: { $known }.
error-alias_taken = { $name } já tem um significado.
error-title_missing = É preciso um título pelo menos numa língua: [title] com en = "…".
exercise-other-language = Este exercício ainda não está escrito na sua língua. Língua do texto: { $language }.
rule-dimension-free = { $names } não tem de aparecer na sua tabela: com referenciais escolhidos de certo modo desaparece.
error-context_invalid = Esta ligação não foi criada aqui ou foi alterada.
error-context_expired = Esta ligação expirou.
error-switched_off = { $path } está desativado para este exercício.
error-attempts_used_up = { $limit ->
    [one] A única tentativa que este exercício permite já foi feita.
   *[other] Já foram feitas as { $limit } tentativas que este exercício permite.
}
error-ladder_falls = A cada tentativa pode dizer-se tanto como à anterior ou mais, nunca menos.
task-frames = Coloque os referenciais 0 a { $n } no robô tal como a figura o mostra: de cada um, a origem, em { unit-word } e nas coordenadas da figura, e as direções de x e z. { figure-place }
error-frames_count = Há referenciais de 0 a N: são precisos { $expected } e foram dados { $given }.
error-convention_not_asked = O exercício pede a convenção { $asked ->
    [modified] modificada
   *[standard] standard
}.
error-weight_out_of_range = O peso de { $name } é um número de 0 a { $most }.
