# URDF y el espacio de trabajo.

error-urdf_not_xml = El texto no es XML bien formado: línea { $line }, columna { $column }.
error-urdf_unsafe = Un URDF no tiene tipo de documento ni entidades y no remite a otros archivos. Quite <!DOCTYPE …>.
error-urdf_too_long = La descripción tiene más de { $limit } caracteres.
error-urdf_too_complex = La descripción tiene más de { $depth } niveles o más de { $elements } elementos.
error-urdf_no_robot = El elemento raíz es <{ $found }>; un URDF empieza por <robot>.
error-urdf_is_xacro = Esto es xacro, un lenguaje de macros. Expándalo primero: xacro robot.xacro > robot.urdf
error-urdf_no_links = La descripción no tiene eslabones (link).
error-urdf_name_missing = Un elemento <{ $element }> no tiene nombre.
error-urdf_name_twice = Dos elementos <{ $element }> se llaman «{ $name }».
error-urdf_name_invalid = Un nombre es una línea de caracteres visibles.
error-urdf_joint_incomplete = A la articulación «{ $joint }» le falta <{ $element } link="…"/>.
error-urdf_link_missing = La articulación «{ $joint }» nombra el eslabón «{ $link }», que la descripción no tiene.
error-urdf_link_unknown = La descripción no tiene el eslabón «{ $link }»; tiene { $known }.
error-urdf_links_alike = El primer eslabón y el último necesitan nombres distintos; ambos eran «{ $link }».
error-urdf_two_parents = El eslabón «{ $link }» es hijo de dos articulaciones, «{ $first }» y «{ $second }». Cada eslabón tiene un solo padre.
error-urdf_ring = Los eslabones forman un bucle que pasa por «{ $link }». Una descripción es un árbol.
error-urdf_base_needed = Eslabones sin padre: { $count }. Indique uno como base_link: { $links }.
error-urdf_tip_needed = La descripción se ramifica; extremos: { $count }. Indique uno como tip_link: { $links }.
error-urdf_no_path = Ninguna serie de articulaciones lleva del eslabón «{ $base }» al eslabón «{ $tip }».
error-urdf_nothing_moves = Nada se mueve entre el eslabón «{ $base }» y el eslabón «{ $tip }».
error-urdf_too_many_joints = La cadena tiene { $count } articulaciones móviles; una tabla admite { $limit } como máximo.
error-urdf_several_freedoms = La articulación «{ $joint }» es de tipo { $kind }: tiene varios grados de libertad, y una fila de la tabla DH solo uno.
error-urdf_type_unknown = La articulación «{ $joint }» es del tipo «{ $kind }»; los tipos conocidos son { $known }.
error-urdf_mimic = La articulación «{ $joint }» se mueve con «{ $other }» y ambas están en la cadena; en una tabla DH cada articulación tiene su propia variable.
error-urdf_mimic_unknown = La articulación «{ $joint }» imita a «{ $other }», que no es una articulación de la descripción.
error-urdf_mimic_circle = La articulación «{ $joint }» no tiene con qué moverse: lo que imita lleva a un círculo ({ $circle }).
error-urdf_attribute_unknown = Articulación «{ $joint }»: <{ $element }> no tiene el atributo «{ $attribute }»; admite { $known }.
error-urdf_element_twice = La articulación «{ $joint }» tiene varios elementos <{ $element }> distintos. Deje solo uno.
error-urdf_two_orientations = La articulación «{ $joint }» da su orientación dos veces, como rpy y como quat_xyzw. Deje solo una.
error-urdf_quaternion_zero = El cuaternión de la articulación «{ $joint }» es 0 0 0 0, que no es una orientación.
error-urdf_joint_names = Un robot de { $expected ->
    [one] una articulación
   *[other] { $expected } articulaciones
} lleva otros tantos nombres, todos distintos y ninguno igual a fixed_base, fixed_tool o fixed_row_…; nombres dados: { $given }.
error-urdf_link_names = Un robot de { $expected ->
    [one] una articulación
   *[other] { $expected } articulaciones
} lleva otros tantos nombres de eslabones, uno para lo que mueve cada articulación, todos distintos; nombres dados: { $given }.
error-urdf_axis_zero = El eje de la articulación «{ $joint }» es 0 0 0 y no tiene dirección.
error-urdf_limits_reversed = El límite inferior de la articulación «{ $joint }» es mayor que el superior.
error-urdf_numbers_malformed = Articulación «{ $joint }»: { $attribute } en <{ $element }> admite { $count ->
        [one] un número finito
       *[other] { $count } números finitos separados por espacios
    }, ninguno mayor que { $limit }.
error-urdf_limit_malformed = Articulación «{ $joint }»: { $attribute } en <limit> admite un número. Escriba inf si la articulación no tiene límite.
error-urdf_limit_overflow = Un límite en un URDF es como máximo { $limit } (rad o m) en valor absoluto. Indique null donde no haya límite.
error-urdf_length_overflow = Las longitudes de un URDF deben ser de { $limit_in_metres } m como máximo.
error-option_idle = Omita { $found }: esta conversión no lo usa.

error-workspace_without_joints = Nada se mueve: un espacio de trabajo necesita una fila de rotación o prismática.
error-slide_without_limits = La articulación { $joint } se desliza: sin un valor mínimo y uno máximo, el espacio de trabajo es ilimitado.
