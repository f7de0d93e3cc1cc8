# Atribuição de referenciais: regras e recusas.

rule-z_not_along_axis = z deve estar ao longo do eixo { $axis }, porque a junta { $axis } roda em torno deste z ou desliza ao longo dele.
rule-origin_not_on_axis = A origem deve estar sobre o eixo { $axis }, porque z deste referencial está ao longo dele.
rule-origin_not_on_common_normal = A origem deve estar onde a normal comum dos eixos { $first } e { $second } encontra o eixo deste referencial, porque a se mede sobre essa normal.
rule-origin_not_at_intersection = Os eixos { $first } e { $second } intersetam-se: a origem fica no ponto de interseção, porque aí a é zero.
rule-x_not_across_z = x deve ser perpendicular a z, porque os eixos de um referencial são perpendiculares.
rule-x_not_along_common_normal = x deve estar ao longo da normal comum dos eixos { $first } e { $second }, porque a se mede ao longo de x e é a menor distância entre os eixos.
rule-x_not_across_both_axes = x deve ser perpendicular a ambos os eixos { $first } e { $second }, porque α roda um até ao outro em torno de x.
rule-first_x_misses_axis = x do primeiro referencial deve intersetar o eixo { $axis } em ângulo reto, porque a sua linha só tem a e α, ao longo e em torno de x, para lá chegar.
rule-last_x_misses_axis = x do último referencial deve intersetar o eixo { $axis } em ângulo reto, porque a sua linha só tem a e α, ao longo e em torno de x, para de lá vir.
rule-z_reversed = z aponta contra o sentido positivo do eixo { $axis }. É permitido; a variável da junta entra então com sinal negativo.
rule-x_reversed = x aponta do eixo { $second } para o eixo { $first }. É permitido; o comprimento do elo fica então negativo.
rule-offset_could_vanish = Com outra origem neste eixo, d{ $joint } seria zero.
rule-angle_could_vanish = Com outra direção de x, θ{ $joint } seria zero.
rule-first_not_simplest = O referencial 0 pode ser colocado de modo que mais parâmetros se anulem.
rule-last_not_simplest = O último referencial pode ser colocado de modo que mais parâmetros se anulem.

error-axes_wrong_number = Uma cadeia tem de 1 a { $limit } eixos; esta tem { $count }.
error-axis_joint_unknown = A junta de um eixo é rotativa (revolute) ou prismática (prismatic).
error-gripper_jaws_along_approach = Os dedos deslizam transversalmente à direção de aproximação, não ao longo dela.
error-vector_malformed = Dê três números finitos x, y, z, nenhum maior que { $limit }.
error-direction_zero = Uma direção precisa de comprimento: 0, 0, 0 não aponta para lado nenhum.
error-frames_too_many =
    Uma cadeia de { $count ->
        [one] { $count } junta
       *[other] { $count } juntas
    } tem os referenciais de 0 a { $count }.
error-frame_y_not_z_cross_x = y resulta de z e x. Deixe-o de fora ou dê z × x junto com ambos.
error-parallel_tolerance_out_of_range = A tolerância para eixos paralelos está entre { $least } e { $greatest } rad.
error-near_parallel = Os eixos { $previous } e { $joint } são paralelos a menos de { $angle } rad e foram tomados como paralelos. Com isso o último referencial pode ficar rodado de até ao dobro desse ângulo e deslocado de até { $displacement }.
error-near_parallel_dummy_row = Os eixos { $previous } e { $joint } são paralelos a menos de { $angle } rad; uma linha fixa entre eles mantém a tabela exata.
error-base_not_frame_zero_standard = O referencial 0 de uma tabela standard tem z ao longo do eixo 1 e a origem sobre ele; o referencial dado não, por isso só se chega a ele pela transformação da base.
error-base_not_frame_zero_modified = O referencial 0 de uma tabela modificada tem um eixo x que interseta o eixo 1 em ângulo reto; o referencial dado não, por isso só se chega a ele pela transformação da base.
error-tool_not_last_frame_standard = O último referencial de uma tabela standard tem um eixo x que interseta o último eixo em ângulo reto; a ferramenta dada não, por isso só se chega a ela pela transformação da ferramenta.
error-tool_not_last_frame_modified = O último referencial de uma tabela modificada tem z ao longo do último eixo e a origem sobre ele; a ferramenta dada não, por isso só se chega a ela pela transformação da ferramenta.
