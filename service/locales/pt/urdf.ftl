# URDF e o espaço de trabalho.

error-urdf_not_xml = O texto não é XML bem formado: linha { $line }, coluna { $column }.
error-urdf_unsafe = Um URDF não tem tipo de documento nem entidades e não se refere a outros ficheiros. Retire <!DOCTYPE …>.
error-urdf_too_long = A descrição tem mais de { $limit } caracteres.
error-urdf_too_complex = A descrição tem mais de { $depth } níveis ou mais de { $elements } elementos.
error-urdf_no_robot = O elemento raiz é <{ $found }>; um URDF começa com <robot>.
error-urdf_is_xacro = Isto é xacro, uma linguagem de macros. Expanda-o primeiro: xacro robot.xacro > robot.urdf
error-urdf_no_links = A descrição não tem elos (link).
error-urdf_name_missing = Um elemento <{ $element }> não tem nome.
error-urdf_name_twice = Dois elementos <{ $element }> chamam-se “{ $name }”.
error-urdf_name_invalid = Um nome é uma linha de caracteres visíveis.
error-urdf_joint_incomplete = Falta <{ $element } link="…"/> à junta “{ $joint }”.
error-urdf_link_missing = A junta “{ $joint }” nomeia o elo “{ $link }”, que a descrição não tem.
error-urdf_link_unknown = A descrição não tem o elo “{ $link }”; tem { $known }.
error-urdf_links_alike = O primeiro elo e o último precisam de nomes diferentes; ambos eram “{ $link }”.
error-urdf_two_parents = O elo “{ $link }” é filho de duas juntas, “{ $first }” e “{ $second }”. Cada elo tem um só pai.
error-urdf_ring = Os elos formam um ciclo que passa por “{ $link }”. Uma descrição é uma árvore.
error-urdf_base_needed = Elos sem pai: { $count }. Indique um como base_link: { $links }.
error-urdf_tip_needed = A descrição ramifica-se; extremidades: { $count }. Indique uma como tip_link: { $links }.
error-urdf_no_path = Nenhuma sequência de juntas leva do elo “{ $base }” ao elo “{ $tip }”.
error-urdf_nothing_moves = Nada se move entre o elo “{ $base }” e o elo “{ $tip }”.
error-urdf_too_many_joints = A cadeia tem { $count } juntas móveis; uma tabela admite no máximo { $limit }.
error-urdf_several_freedoms = A junta “{ $joint }” é do tipo { $kind }: tem vários graus de liberdade, e uma linha da tabela DH só um.
error-urdf_type_unknown = A junta “{ $joint }” é do tipo “{ $kind }”; os tipos conhecidos são { $known }.
error-urdf_mimic = A junta “{ $joint }” move-se com “{ $other }” e ambas estão na cadeia; numa tabela DH cada junta tem a sua própria variável.
error-urdf_mimic_unknown = A junta “{ $joint }” imita “{ $other }”, que não é uma junta da descrição.
error-urdf_mimic_circle = A junta “{ $joint }” não tem movimento que seguir: o que imita leva a um círculo ({ $circle }).
error-urdf_attribute_unknown = Junta “{ $joint }”: <{ $element }> não tem o atributo “{ $attribute }”; recebe { $known }.
error-urdf_element_twice = A junta “{ $joint }” tem vários elementos <{ $element }> diferentes. Deixe apenas um.
error-urdf_two_orientations = A junta “{ $joint }” dá a sua orientação duas vezes, como rpy e como quat_xyzw. Deixe apenas uma.
error-urdf_quaternion_zero = O quaternião da junta “{ $joint }” é 0 0 0 0, que não é uma orientação.
error-urdf_joint_names =
    Um robô com { $expected ->
        [one] { $expected } junta
       *[other] { $expected } juntas
    } recebe outros tantos nomes, todos diferentes e nenhum igual a fixed_base, fixed_tool ou fixed_row_…; nomes dados: { $given }.
error-urdf_link_names =
    Um robô com { $expected ->
        [one] { $expected } junta
       *[other] { $expected } juntas
    } recebe outros tantos nomes de elos, um para o que cada junta carrega, todos diferentes; nomes dados: { $given }.
error-urdf_axis_zero = O eixo da junta “{ $joint }” é 0 0 0 e não tem direção.
error-urdf_limits_reversed = O limite inferior da junta “{ $joint }” é maior do que o superior.
error-urdf_numbers_malformed = Junta “{ $joint }”: { $attribute } em <{ $element }> recebe { $count ->
        [one] um número finito
       *[other] { $count } números finitos separados por espaços
    }, nenhum maior que { $limit }.
error-urdf_limit_malformed = Junta “{ $joint }”: { $attribute } em <limit> recebe um número. Escreva inf se a junta não tem limite.
error-urdf_limit_overflow = Um limite num URDF não pode exceder { $limit } (rad ou m) em valor absoluto. Indique null onde não houver limite.
error-urdf_length_overflow = Os comprimentos de um URDF não podem exceder { $limit_in_metres } m.
error-option_idle = Omita { $found }: esta conversão não o usa.

error-workspace_without_joints = Nada se move: um espaço de trabalho precisa de uma linha rotativa ou prismática.
error-slide_without_limits = A junta { $joint } desliza: sem um valor mínimo e um máximo, o espaço de trabalho é ilimitado.
