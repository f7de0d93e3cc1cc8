### Clases de pregunta: qué se pide y qué se dice de las respuestas.

field-matrix = Matriz
field-component_order = Orden de las componentes del cuaternión
field-quaternion = Cuaternión
field-axis = Eje de rotación
field-angle = Ángulo de rotación
field-angles = Ternas de ángulos
field-middle = En el bloqueo del cardán: el ángulo intermedio
field-combination = En el bloqueo del cardán: qué combinación del primer y del último ángulo queda determinada
field-value = Su valor
field-matrix_claim = Esta matriz
field-pose_claim = Esta pose
field-position_claim = Esta posición
field-pose = Pose
option-wxyz = w, x, y, z: el escalar primero
option-xyzw = x, y, z, w: el escalar al final
option-sum = la suma: primero + último
option-difference = la diferencia: primero − último
option-rotation = es una rotación
option-unit_columns = no es una rotación: una columna no tiene longitud 1
option-perpendicular_columns = no es una rotación: dos columnas no son perpendiculares
option-right_handed = no es una rotación: sus columnas forman una terna levógira (determinante −1)
given-rotation = La orientación como matriz de rotación
given-quaternion = La orientación como cuaternión unitario
given-axis_angle = La orientación como eje y ángulo
given-angles = La orientación en ángulos
given-matrix = La matriz
given-frame-pose = Pose del sistema { $end } en el sistema { $start }

task-orientation =
    { $given ->
        [angles] Un sistema de referencia se gira tres ángulos alrededor de los ejes { $turning ->
            [fixed] fijos
           *[current] móviles
        } { $axes }, en este orden.
       *[other] Se da la orientación de un sistema de referencia.
    } Escríbala en las notaciones de abajo.{ $ask ->
        [every] {" "}De los ángulos alrededor de los ejes { $asked_turning ->
            [fixed] fijos
           *[current] móviles
        } { $asked_axes } se piden todas las ternas: las dos o, en el bloqueo del cardán, el ángulo intermedio y lo que queda determinado de los otros dos.
        [one] {" "}De los ángulos alrededor de los ejes { $asked_turning ->
            [fixed] fijos
           *[current] móviles
        } { $asked_axes } basta una terna.
       *[none] {""}
    }
task-rotation-check = ¿Es esta matriz una rotación? Si no lo es, diga qué propiedad de las rotaciones falla.
task-frame-chain = Se conocen las poses siguientes. Escriba la pose del sistema { $end } en el sistema { $start } como matriz 4×4, con las longitudes en { unit-word }.
feedback-orientation_right = Todas las notaciones describen la orientación dada.
feedback-orientation_wrong =
    { $notation ->
        [matrix] La matriz no es la de esta orientación.
        [quaternion] El cuaternión no es el de esta orientación.
        [axis_angle] El eje y el ángulo no son los de esta orientación.
        [angles] Los ángulos no son los de esta orientación.
       *[other] Los ángulos no son todos correctos, o no están todos.
    }
feedback-orientation_missing =
    { $notation ->
        [matrix] Falta la matriz.
        [quaternion] Falta el cuaternión.
        [axis_angle] Faltan el eje y el ángulo.
       *[other] Faltan los ángulos.
    }

feedback-rotation_transposed = Esta es la rotación inversa: se han intercambiado filas y columnas, o el sentido de giro.
feedback-rotation_order_reversed = Las rotaciones se multiplicaron en orden inverso: se confundieron los ejes fijos con los móviles.
feedback-rotation_degrees = Un ángulo en grados se tomó por radianes, o al revés.
feedback-rotation_handedness = Todo gira al revés: se ha aplicado la regla de la mano izquierda.
feedback-rotation_half_angle = Este cuaternión gira el doble: necesita el seno y el coseno de la mitad del ángulo.
feedback-rotation_component_order = Con el otro orden de las componentes este cuaternión sería correcto.
feedback-rotation_not_unit = El cuaternión no tiene longitud 1.
feedback-rotation_no_axis = El eje tiene longitud cero.
feedback-rotation_solution_missing = Hay una segunda terna con la misma orientación.
feedback-rotation_solution_twice = Sus ternas se diferencian solo en vueltas completas: son la misma. Hay otra.
feedback-rotation_family_missing = Hay bloqueo del cardán: existen infinitas ternas. Diga qué combinación del primer y del último ángulo queda determinada.
feedback-rotation_combination = La combinación determinada es la otra: la diferencia en lugar de la suma, o la suma en lugar de la diferencia.
feedback-rotation_not_locked = No hay bloqueo del cardán: exactamente dos ternas tienen esta orientación.
feedback-rotation_quadrant = Un ángulo está en el cuadrante equivocado, a media vuelta: use atan2 en lugar de atan.
feedback-rotation_angle_sign = Un ángulo, o una combinación de ángulos, tiene el signo equivocado.
feedback-rotation_rounded = Los elementos están demasiado redondeados: calcule con más decimales.
feedback-rotation_unit_columns = Esto no es una rotación: una columna no tiene longitud 1.
feedback-rotation_perpendicular_columns = Esto no es una rotación: dos columnas no son perpendiculares.
feedback-rotation_right_handed = Esto no es una rotación sino una reflexión: su determinante es −1.
feedback-claim_right = Así es con esta matriz.
feedback-claim_not_rotation = No es una rotación: compruebe las longitudes de las columnas, los ángulos entre ellas y el determinante.
feedback-claim_rotation = Sí es una rotación: columnas de longitud 1, perpendiculares, determinante +1.
feedback-claim_other_property = No es una rotación, pero esta propiedad se cumple; falla otra.
feedback-chain_right = La pose es la que se obtiene de la cadena de sistemas.
feedback-chain_wrong = Esta no es la pose que se obtiene de las conocidas.
feedback-chain_rotation_right = Su rotación es correcta.
feedback-chain_position_right = Su posición es correcta.
feedback-chain_inverted = Esta es la inversa: la pose del primer sistema en el último.
feedback-chain_not_inverted = Se usó tal cual una pose conocida que antes hay que invertir.
feedback-chain_inverse_without_transpose = La inversa de una pose se formó con R; hace falta Rᵀ: (Rᵀ, −Rᵀp).
feedback-chain_inverse_position = La posición de una inversa es −Rᵀp, no −p.
feedback-chain_order_reversed = Los factores se multiplicaron en orden inverso.
feedback-chain_transposed = La rotación está traspuesta.
feedback-chain_not_rigid = Esto no es un movimiento rígido: sus columnas no son vectores unitarios perpendiculares, o forman una terna levógira (determinante −1), o su última fila no es 0 0 0 1.
error-euler_axes_unknown = { $axes } no es una secuencia de ejes: tres de X, Y, Z, con vecinos distintos.
error-component_order_missing = Diga dónde está el escalar del cuaternión: wxyz o xyzw.
error-axis_and_angle = Un eje necesita un ángulo, y un ángulo un eje.
error-family_incomplete = Una familia de ternas necesita las tres cosas: el ángulo intermedio, suma o diferencia, y su valor.
error-orientation_empty = Escriba la orientación en una de las notaciones que se piden.
error-mistake_empty = Diga dónde está el error, cuál es o cómo se corrige.
error-frames_not_connected = Las poses conocidas no llevan del sistema { $start } al sistema { $end }.
error-pose_without_table = Una pose es la de la tabla del propio estudiante o la de ⁰T: pida también una de ellas, o deje que las reglas fijen el cero, el sentido, el sistema 0 y el último sistema.

error-one_notation = Dé la orientación en una sola notación: { $known }.
error-name_without_value = El nombre { $name } no tiene valor aquí.{ $found ->
    [0] {""}
   *[one] {" "}¿Quería decir { $close }?
} Los nombres son { $known }.
error-rate_in_marks = { $text } no es un nombre aquí. ¿Quería decir la velocidad articular { $suggestion }?
error-expected_not_rotation =
    La matriz esperada no es una rotación: { $property ->
        [unit_columns] una columna no tiene longitud 1.
        [perpendicular_columns] dos columnas no son perpendiculares.
       *[right_handed] es una reflexión, con determinante −1.
    }

field-solutions = Valores articulares
field-combinations = Si son infinitas: la combinación que permanece constante (coeficientes)
option-finite = se alcanza con estos valores articulares
option-infinite = se alcanza con infinitos valores; estos son algunos
option-out_of_reach = está fuera del espacio de trabajo
option-joint_limits = no se alcanza dentro de los límites articulares
given-target = La pose
given-target-position = La posición del último origen
given-table = La tabla DH, convención { $convention ->
    [modified] modificada
   *[standard] estándar
}

task-inverse-kinematics =
    { $variables ->
        [own] ¿Qué valores de sus propias variables articulares llevan el último sistema a este lugar en el sistema 0?
       *[given] Se da la tabla del robot. ¿Qué valores articulares llevan su último sistema a este lugar en el sistema 0?
    } { $solutions ->
        [one] Basta una solución.
       *[all] Dé todas; las vueltas completas no cuentan.
    } { $reach ->
        [position] Solo importa la posición del último origen, en { unit-word }.
       *[pose] Importan la posición, en { unit-word }, y la orientación.
    }

feedback-joints_right = La respuesta es correcta: contiene todo lo que se pide.
feedback-joints_searched = Para esta pose las soluciones se hallaron por búsqueda; puede haber más.
feedback-joints_need_table = Los valores articulares son los de sus propias variables: entregue también una tabla correcta.
feedback-claim_wrong = No es así: vuelva a contar cuántas soluciones tiene esta pose, si hay alguna.
feedback-joints_wrong = La fila { $row } no alcanza la pose.
feedback-joints_twice = Las filas { $other } y { $row } se diferencian solo en vueltas completas: son una misma solución.
feedback-joints_missing =
    { $count ->
        [one] Falta una solución.
       *[other] Faltan { $count } soluciones.
    }
feedback-branch_shoulder =
    { $count ->
        [one] El brazo también puede alcanzar la pose por detrás, con la otra configuración del hombro.
       *[other] El brazo también puede alcanzar la pose por detrás, con la otra configuración del hombro: faltan { $count } soluciones de este tipo.
    }
feedback-branch_elbow =
    { $count ->
        [one] El codo también puede doblarse hacia el otro lado.
       *[other] El codo también puede doblarse hacia el otro lado: faltan { $count } soluciones de este tipo.
    }
feedback-branch_wrist =
    { $count ->
        [one] La muñeca también puede estar volteada.
       *[other] La muñeca también puede estar volteada: faltan { $count } soluciones de este tipo.
    }
feedback-branch_other =
    { $count ->
        [one] Hay otra rama de soluciones.
       *[other] Hay otras { $count } ramas de soluciones.
    }
feedback-joints_quadrant = Fila { $row }: q{ $joint } está en el cuadrante equivocado, a media vuelta. Use atan2 en lugar de atan.
feedback-joints_sign = Fila { $row }: q{ $joint } tiene el signo equivocado.
feedback-joints_degrees = Fila { $row }: se tomaron grados por radianes, o al revés.
feedback-joints_swapped = Fila { $row }: q{ $joint } vale 90° menos el valor correcto; se intercambiaron los argumentos de atan2.
feedback-joints_half_branch = La fila { $row } es la fila { $other } en la que solo cambió q{ $joint }: en otra rama cambian con ella otras articulaciones.
feedback-joints_position_only = La fila { $row } alcanza la posición, pero no la orientación.
feedback-joints_orientation_only = La fila { $row } alcanza la orientación, pero no la posición.
feedback-joints_limits = La fila { $row } alcanza la pose con la articulación { $joint } fuera de su límite.
feedback-joints_rounded = La fila { $row } se acerca a una solución, pero no lo suficiente: calcule con más decimales.
feedback-joints_family_missing = La pose es singular: diga qué combinación de variables articulares permanece igual en las soluciones.
feedback-joints_taken_off = Lo incorrecto se descuenta de lo correcto, para que adivinar no dé puntos: aquí no queda nada de las filas correctas.
feedback-joints_combination_wrong = La combinación { $row } no permanece igual en las soluciones.
feedback-joints_combination_zero = La combinación { $row } vale 0 hagan lo que hagan las articulaciones, y no dice nada.
feedback-joints_combination_loose = La combinación { $row } permanece igual en las soluciones, pero eso no basta: otros valores articulares con la misma combinación no alcanzan la pose.
error-pose_frames_free = La pose se da en el sistema 0 y para el último: las reglas deben fijar ambos, base = "frame" y tool = "frame".
error-pose_within_reach = Este brazo alcanza poses por lejanas que estén, pues aquí las articulaciones prismáticas no tienen límites: quite out_of_reach de cases.
error-joint_row_length = Una fila contiene un valor por articulación: se necesitan { $expected } y se dieron { $given }.
error-joint_rows_empty = Dé los valores articulares que alcanzan la pose.

field-row = Fila con el error
field-name = Qué está mal
field-mended = La fila como debería ser
field-verdict = Las dos tablas describen
field-reason = porque
option-alpha_sign = α tiene el signo equivocado
option-alpha_value = α tiene un valor erróneo
option-a_sign = a tiene el signo equivocado
option-d_sign = d tiene el signo equivocado
option-a_value = a tiene un valor erróneo
option-d_value = d tiene un valor erróneo
option-a_d_swapped = a y d están intercambiados
option-a_missing = a es cero y no debería serlo
option-a_not_zero = a no es cero y debería serlo
option-d_missing = falta un desplazamiento d
option-d_not_zero = d no es cero y debería serlo
option-angles_in_degrees = todos los ángulos en grados, aunque se declaran radianes
option-angles_in_radians = todos los ángulos en radianes, aunque se declaran grados
option-cell_in_degrees = un ángulo en grados entre radianes
option-cell_in_radians = un ángulo en radianes entre grados
option-cell_length_unit = una longitud en otra unidad
option-cell_parameter = se usa otra dimensión de la figura
option-columns_early = a y α una fila más arriba
option-columns_late = a y α una fila más abajo
option-columns_exchanged = dos columnas intercambiadas
option-columns_reordered = columnas en otro orden
option-convention = se declara la convención equivocada
option-fixed_row_missing = falta la última fila, sin variable
option-joint_fixed = una articulación sin su variable
option-joint_moving = una variable donde nada se mueve
option-joint_type = el tipo de la articulación es erróneo
option-length_unit = todas las longitudes en otra unidad
option-parameter_misnamed = un nombre que no está en la figura
option-parameters_swapped = dos dimensiones intercambiadas
option-row_extra = una fila de más
option-row_missing = falta una fila
option-rows_swapped = dos filas intercambiadas
option-theta_offset = la constante sumada a la variable θ es errónea
option-d_offset = la constante sumada a la variable d es errónea
option-theta_value = la constante θ tiene un valor erróneo
option-turns_all_reversed = todos los ángulos articulares crecen en sentido contrario
option-twists_all_reversed = todos los α tienen el signo equivocado
option-twists_early = solo α una fila más arriba
option-twists_swapped = α de dos filas intercambiados
option-twists_late = solo α una fila más abajo
option-variable_sign = una variable articular crece en sentido contrario
option-same = el mismo robot
option-different = robots distintos
option-axis_reversed = los sistemas difieren: un eje z, o una variable articular, está invertido
option-x_turned = los sistemas difieren: un eje x está girado, y la variable vale cero en otro lugar
option-origin_moved = los sistemas difieren: un origen está en otro lugar, o el primer o el último sistema está colocado de otra manera
option-other_convention = los sistemas difieren: la convención es otra
option-twist = el ángulo entre dos ejes es distinto
option-length = la distancia entre dos ejes es distinta
option-offset = un desplazamiento a lo largo de un eje, o un ángulo constante en torno a él, es distinto
given-table-with-mistake = La tabla con un error ({ $convention ->
    [modified] convención modificada
   *[standard] convención estándar
})
given-first-table = La primera tabla ({ $convention ->
    [modified] convención modificada
   *[standard] convención estándar
})
given-second-table = La segunda tabla ({ $convention ->
    [modified] convención modificada
   *[standard] convención estándar
})

task-find-mistake = Esta tabla debería describir el robot de la figura, pero una fila tiene un error. ¿Qué fila es, qué tiene mal y cómo debería ser?
task-compare-tables = ¿Describen estas dos tablas el mismo robot, se elijan como se elijan los sistemas? Diga por qué.

feedback-mistake_found = Ha hallado el error, lo ha nombrado y lo ha corregido.
feedback-mistake_row_wrong = El error está en otra fila.
feedback-mistake_name_wrong = El error es de otro tipo.
feedback-mistake_not_mended = Con esta fila la tabla sigue sin describir el robot.
feedback-mistake_missing =
    { $what ->
        [row] Diga en qué fila está el error.
        [name] Diga qué está mal.
       *[mended] Escriba la fila como debería ser.
    }
feedback-tables_right = Correcto, y por la razón correcta.
feedback-tables_same = Son el mismo robot: solo se eligieron otros sistemas.
feedback-tables_different = Son robots distintos: ninguna elección de sistemas convierte una tabla en la otra.
feedback-tables_reason_wrong = El veredicto es correcto, pero no por esta razón.
feedback-tables_reason_missing = El veredicto es correcto; diga también por qué.
error-row_unknown = Dé el número de una fila, de 1 a { $count }.
error-column_unknown = Dé el número de una columna, de 1 a { $count }.
error-vector_length = El vector tiene { $expected } componentes, y se dieron { $given }.
error-joint_variable_in_number = { $name } es una variable articular, y aquí se pide un número: ponga su valor.
error-no_mistake_does_harm = Ninguno de estos errores cambia este robot con sus reglas.
error-frame_mistakes_not_shown = Los sistemas de referencia de este robot no pueden mostrar ninguno de estos errores. Lo que pueden mostrar: { $known }.
error-key_given_away = Esta parte muestra una tabla; un ejercicio que pide la tabla no puede tenerla.
error-not_plantable = Ninguno de los errores pedidos cambia este robot.

field-frame = Los tornillos se escriben en
field-order = Orden de v y ω
field-screws = Tornillos, una fila por articulación
field-home = Pose inicial M
option-space = el sistema fijo (espacio)
option-body = el sistema de la herramienta en la posición cero (cuerpo)
option-linear_first = v, ω: la parte lineal primero
option-angular_first = ω, v: la parte angular primero

task-screws = Escriba el robot como producto de exponenciales: los tornillos de las articulaciones 1 a { $n } y la pose inicial M, con las longitudes en { unit-word }. Elija el sistema, la posición cero y el sentido de cada eje dentro de las reglas.

feedback-screws_right = Los tornillos y la pose inicial describen este robot.
feedback-screws_right_robot = Este producto de exponenciales describe el robot correcto, pero no cumple todo lo que pide el ejercicio.
feedback-screws_wrong = Este producto de exponenciales no describe el robot, sean cuales sean el sistema, el cero y los sentidos.
feedback-screw_not_unit = Articulación { $joint }: ω de una articulación de rotación es un vector unitario.
feedback-screw_pitch = Articulación { $joint }: v tiene una componente a lo largo de ω; una articulación de rotación no avanza por su eje.
feedback-screw_joint_type = Articulación { $joint }: una prismática tiene ω = 0 y un vector unitario v; una de rotación tiene ω de longitud 1.
feedback-screw_halves = v y ω están intercambiados: en el otro orden las filas serían correctas.
feedback-screw_moment_sign =
    { $joint ->
        [0] Todas las v tienen el signo equivocado
       *[other] Articulación { $joint }: v tiene el signo equivocado
    }: v = −ω × p, con p un punto cualquiera del eje.
feedback-screw_other_frame = Estos son los tornillos en el otro sistema: se confundieron espacio y cuerpo.
feedback-screw_home_inverted = La pose inicial está invertida.
feedback-screw_sign_or_home = O bien v tiene el signo equivocado en todas partes (v = −ω × p, con p un punto cualquiera del eje), o bien la pose inicial está invertida.
feedback-screw_home = Los tornillos son correctos; la pose inicial M no.
feedback-screw_not_rigid = La pose inicial no es un movimiento rígido: sus columnas no son vectores unitarios perpendiculares, o forman una terna levógira (determinante −1), o su última fila no es 0 0 0 1.
feedback-screw_length_unit = Las longitudes están en otra unidad que la del robot: en la suya las filas serían correctas.
feedback-screw_exchanged = Las filas de la articulación { $joint } y de la siguiente están intercambiadas.
feedback-screw_reversed = Las filas están en orden inverso: la primera es la de la articulación más cercana a la base.
feedback-screws_relation_wrong = Los ejes de las articulaciones { $joint } y { $next } no están dispuestos entre sí como en la figura.
error-screw_count = El robot tiene { $expected ->
    [one] una articulación
   *[other] { $expected } articulaciones
} y { $given ->
    [one] se dio un tornillo
   *[other] se dieron { $given } tornillos
}.

error-screw_too_large = Un número es demasiado grande para un robot; el máximo es { $limit }.

field-jacobian = Jacobiana, una columna por articulación
field-forces = Pares y fuerzas articulares
given-configuration = La configuración
given-wrench = Fuerza y momento que ejerce la herramienta

task-jacobian =
    { $variables ->
        [own] Tome su propia tabla y sus propias variables articulares con estos valores.
       *[given] Se dan la tabla del robot y una configuración.
    } { $ask ->
        [jacobian] Escriba la jacobiana geométrica del último origen, con las longitudes en { unit-word }, por radián.
        [forces] ¿Qué pares y fuerzas articulares, τ = Jᵀ(f, m), corresponden a la fuerza y al momento en el último origen, con las longitudes en { unit-word }?
       *[both] Escriba la jacobiana geométrica del último origen, con las longitudes en { unit-word }, por radián, y los pares y fuerzas articulares τ = Jᵀ(f, m).
    } { $frame ->
        [end] Todos los vectores están en los ejes del último sistema.
       *[base] Todos los vectores están en los ejes del sistema 0.
    }

feedback-jacobian_right = Todo es correcto.
feedback-jacobian_follows_table = Esto se sigue de su tabla y vale sus puntos, aunque la tabla no sea correcta.
feedback-jacobian_needs_table = La jacobiana es la de su propia tabla: entregue también la tabla, con todas las articulaciones.
feedback-jacobian_missing =
    { $what ->
        [jacobian] Falta la jacobiana.
       *[forces] Faltan los pares y fuerzas articulares.
    }
feedback-jacobian_wrong = No todas las columnas de la jacobiana son correctas.
feedback-forces_wrong = No todos los pares y fuerzas articulares son correctos.
feedback-jacobian_next_axis =
    { $count ->
        [1] La columna { $joint } usa el eje de una articulación vecina: fíjese en qué z corresponde a cada articulación en su convención.
       *[other] Las columnas { $joints } usan el eje de una articulación vecina: fíjese en qué z corresponde a cada articulación en su convención.
    }
feedback-jacobian_point_swapped =
    { $count ->
        [1] Columna { $joint }: la parte lineal es z × (pₙ − p), no z × (p − pₙ).
       *[other] Columnas { $joints }: la parte lineal es z × (pₙ − p), no z × (p − pₙ).
    }
feedback-jacobian_prismatic =
    { $count ->
        [1] Columna { $joint }: una prismática da (z, 0); una de rotación, (z × (pₙ − p), z).
       *[other] Columnas { $joints }: una prismática da (z, 0); una de rotación, (z × (pₙ − p), z).
    }
feedback-jacobian_other_frame =
    { $count ->
        [0] Esta es la jacobiana en los ejes del otro sistema.
        [1] La columna { $joint } está en los ejes del otro sistema.
       *[other] Las columnas { $joints } están en los ejes del otro sistema.
    }
feedback-jacobian_rows_exchanged = Las filas lineales y angulares están intercambiadas.
feedback-jacobian_spatial = Esta es la velocidad del punto en el origen del sistema 0; se pide el origen del último sistema.
feedback-forces_sign = Todos los signos están invertidos: se pide τ = Jᵀ(f, m), con la fuerza y el momento dados.
feedback-forces_other_frame = La fuerza y el momento se tomaron en los ejes del otro sistema.
feedback-forces_rows_exchanged = Se intercambiaron fuerza y momento.
feedback-forces_spatial = Se supuso que la fuerza actúa en el origen del sistema 0.
error-row_order_missing = Diga qué filas van primero: (v, ω) o (ω, v).
error-jacobian_empty = Dé la jacobiana o los pares y fuerzas articulares.

error-wrench_missing = Los pares y fuerzas articulares corresponden a una fuerza y un momento: dé «wrench».
