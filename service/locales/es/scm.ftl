# El método SCM: cadenas de filas [X Y Z A B C].

error-scm_chain_empty = La cadena no tiene articulaciones. Hace falta al menos una fila.
error-scm_too_many_joints = La cadena tiene { $joints } articulaciones; se leen como máximo { $limit }.
error-scm_chain_too_long = Los elementos suman { $length } caracteres; se leen como máximo { $limit }.
error-scm_no_variable = La fila { $joint } no contiene ninguna variable articular. Escriba q{ $joint } en el elemento que se mueve.
error-scm_two_variables = La fila { $joint } contiene su variable en { $first } y en { $second }. Una fila tiene exactamente una.
error-scm_variable_of_other_row = { $name } no es la variable de la fila { $joint }; lo es q{ $joint }.
error-scm_variable_form = La variable debe aparecer como +q{ $joint } o −q{ $joint }, con una constante sumada como mucho.
error-scm_variable_outside_joints = { $name } es una variable articular; solo las filas de las articulaciones pueden contener una.
error-scm_parameter_two_kinds = { $name } mide una longitud en un elemento y un ángulo en otro. Use dos nombres.
error-scm_prismatic_turns = La articulación { $joint } es prismática: su fila no puede girar el sistema de referencia. Ponga los giros constantes en la transformación final.
error-scm_prismatic_second_length = La articulación { $joint } es prismática: su fila contiene la variable y ninguna otra longitud. Ponga esta longitud en una fila anterior o posterior.
error-scm_revolute_offset = La articulación { $joint } es de rotación: su ángulo no admite una constante sumada. Ponga los giros constantes en la transformación final.
error-scm_revolute_second_turn = La articulación { $joint } gira alrededor de un solo eje. Ponga los giros constantes en la transformación final.
error-scm_limits_reversed = Articulación { $joint }: los límites son [inferior, superior], ambos finitos y el inferior no mayor que el superior.
error-chain_or_robot = Dé exactamente uno de los dos: chain o robot.
error-scm_six_entries = Hacen falta seis entradas: la lista [X, Y, Z, A, B, C] o un objeto con algunas de x, y, z, a, b, c; lo que falte vale 0.
error-matrix_not_rotation = La parte de rotación de esta matriz no es una rotación: sus columnas deben ser vectores unitarios perpendiculares, en terna dextrógira, para todos los valores de las variables articulares. Solo entonces tiene velocidad angular.
error-variable_name_invalid = { $name } no puede ser el nombre de la variable articular { $joint }: un nombre es una palabra con un índice, como a1, y cada variable tiene el suyo.
error-no_derivative = Una variable articular aparece dentro de una función que aquí no se deriva: escriba senos y cosenos de ella.
