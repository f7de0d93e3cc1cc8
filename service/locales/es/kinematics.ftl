# Valores articulares, poses, tornillos y tablas numéricas.

error-target_unanswered = El cálculo se detuvo a los { $seconds } s; objetivos respondidos: { $answered }. Pida este objetivo y los siguientes en otra petición.
error-joints_wrong_length =
    { $expected ->
        [one] La tabla tiene una articulación, pero se dio una configuración de { $given ->
            [one] un valor
           *[other] { $given } valores
        }.
       *[other] La tabla tiene { $expected } articulaciones, pero se dio una configuración de { $given ->
            [one] un valor
           *[other] { $given } valores
        }.
    }
error-joints_malformed = Los valores articulares son números: una configuración [q1, …, qn] o una lista de configuraciones de igual longitud.
error-joint_not_finite = El valor de la articulación { $joint } no es un número finito.
error-result_not_finite = El resultado es demasiado grande para un número de doble precisión. Las longitudes y los valores articulares deben ser menores.
error-entry_not_finite = { $cell } no es un número finito.
error-value_undefined = Con estos parámetros la expresión no tiene un valor finito.

error-pose_not_numbers = Una pose es una matriz 4×4 de números.
error-pose_wrong_shape = Una pose es una matriz 4×4 de números; esta es { $shape }.
error-pose_not_finite = Este elemento no es un número finito.
error-pose_in_one_row = Dieciséis números en una sola lista no son una pose: escriba cuatro filas de cuatro números, [[…], […], […], [0, 0, 0, 1]].
error-inertia_in_one_row = Una inercia no se escribe en una sola lista: escriba tres filas de tres, [[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]], con Ixy = −∫ x y dm.
error-pose_bottom_row = La última fila de una pose es 0, 0, 0, 1.
error-pose_not_orthonormal = La parte de rotación no es ortonormal (se desvía en { $error }): sus columnas deben ser vectores unitarios perpendiculares, con una tolerancia de { $tolerance }. Dé más decimales o, en cinemática inversa, una tolerancia (`tolerance`).
error-pose_left_handed = La parte de rotación forma una terna levógira: su determinante es −1, una reflexión. Debe ser +1.

error-notation_wrong_length =
    { $expected ->
        [one] { $what } lleva un número: { $names }.
       *[other] { $what } lleva { $expected } números: { $names }.
    }
error-notation_not_finite = { $name } de { $what } no es un número finito.
error-quaternion_length = Un cuaternión de longitud nula o demasiado grande no es una orientación. Dé un cuaternión unitario.
error-axis_length = Un eje de longitud nula o demasiado grande no tiene dirección. Dé un vector unitario.

error-screw_not_finite = Un tornillo consta de seis números finitos.
error-screw_not_unit = La parte angular del tornillo de una articulación de rotación y la parte lineal del de una prismática deben tener longitud 1.
error-screw_has_pitch = Este tornillo tiene un paso de { $pitch } por radián. Una articulación o gira o se desliza.
error-screw_of_other_type = El tornillo { $joint } no es del tipo que se indica: una articulación de rotación tiene parte angular, una prismática no.
error-tree_after_unknown = La fila { $row } sigue al sistema { $given }: debe seguir a la base (0) o a una fila anterior. No se admiten cadenas cerradas.
error-frame_unknown = No existe el sistema { $given }; el último es el { $count }.
