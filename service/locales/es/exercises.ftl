### Ejercicios: qué se pide, qué se dice de las respuestas, qué no puede contener una definición.

## La figura en palabras

figure-title = { $title }: articulaciones, ejes y cotas
figure-coordinates = { $joints ->
    [one] Un robot con una articulación.
   *[other] Un robot con { $joints } articulaciones, una tras otra, contadas desde la base.
} Las posiciones se dan en { unit-word } como (X; Y; Z). { figure-place }
figure-place = X apunta { $x ->
    [back] hacia atrás, Y hacia la izquierda
    [left] hacia la izquierda, Y hacia delante
    [front] hacia delante, Y hacia la derecha
   *[right] hacia la derecha, Y hacia atrás
}, Z hacia arriba; { $fixed ->
    [ground] el robot está fijado
   *[joint] el cuerpo de la articulación 1 está
} en { $at }.
figure-joint-revolute = La articulación { $joint } es de rotación. Su cuerpo está en { $place }; su eje { $course ->
    [vertical] es vertical
    [sideways] va de izquierda a derecha
    [depthways] va de delante hacia atrás
   *[oblique] tiene la dirección { $direction }
}.
figure-joint-revolute-signed = La articulación { $joint } es de rotación. Su cuerpo está en { $place }; su eje { $course ->
    [vertical] es vertical
    [sideways] va de izquierda a derecha
    [depthways] va de delante hacia atrás
   *[oblique] es oblicuo
}. Según la regla de la mano derecha, la variable articular es positiva alrededor de { $direction }.
figure-joint-prismatic = La articulación { $joint } es prismática. Su cuerpo está en { $place }; su dirección { $course ->
    [vertical] es vertical
    [sideways] va de izquierda a derecha
    [depthways] va de delante hacia atrás
   *[oblique] es { $direction }
}.
figure-joint-prismatic-signed = La articulación { $joint } es prismática. Su cuerpo está en { $place }; su dirección { $course ->
    [vertical] es vertical
    [sideways] va de izquierda a derecha
    [depthways] va de delante hacia atrás
   *[oblique] es oblicua
}. La variable articular es positiva a lo largo de { $direction }.
figure-dimension = { $name } mide { $length } { $unit }, { $course ->
    [vertical] en vertical
    [sideways] de izquierda a derecha
    [depthways] de delante hacia atrás
   *[oblique] en oblicuo
}, entre { $start } y { $end }.
figure-point = El punto { $name } está en { $place }.
figure-frame = El origen del sistema { $number } está en { $place }; su eje x apunta según { $x } y su eje z según { $z }.
figure-not-to-scale = El dibujo no está a escala: en él, { $names } { $count ->
    [one] no tiene la longitud que se da
   *[other] no tienen las longitudes que se dan
} aquí.
figure-note = no está a escala

## Qué es libre y qué está fijado

rule-convention-any = Se aceptan la convención estándar y la modificada.
rule-convention-standard = Escriba la tabla en la convención estándar.
rule-convention-modified = Escriba la tabla en la convención modificada.
rule-base-free = El sistema 0 puede estar en cualquier lugar de la base.
rule-base-axis = El eje z del sistema 0 está sobre el eje de la articulación 1, en cualquiera de los dos sentidos.
rule-base-origin = El origen del sistema 0 es el punto marcado O0; sus direcciones las elige usted.
rule-base-frame = El sistema 0 está prescrito; la figura lo muestra.
rule-tool-free = El último sistema puede estar en cualquier lugar del último eslabón.
rule-tool-point = El origen del último sistema está en el punto marcado { $points }.
rule-tool-axis = El eje z del último sistema está sobre el eje de la última articulación, en cualquiera de los dos sentidos; su origen puede estar en cualquier punto de él.
rule-tool-frame = El último sistema está prescrito; la figura lo muestra.
rule-zero-free = Usted elige dónde es cero cada variable articular.
rule-zero-figure = En la configuración de la figura, todas las variables articulares son cero.
rule-direction-free = Usted elige hacia dónde apunta cada eje.
rule-direction-figure = Las variables articulares son positivas en el sentido de las flechas de la figura.

## Qué se pide

task-schematic = Describa la estructura: el tipo de cada articulación y cómo está el eje de cada una respecto al de la siguiente.
task-table = Elija los sistemas de referencia y escriba la tabla DH. Las celdas pueden contener { $names }, números y las variables articulares q1 a q{ $n }.
task-link-matrices = Para cada fila de su tabla, escriba la matriz del eslabón: la pose del sistema i en el sistema i−1. Puede abreviar cos(q1) como c1 y sin(q1 + q2) como s12.
task-transform = Escriba en forma cerrada ⁰T, la pose del último sistema en el sistema 0.
task-pose = Evalúe su ⁰T para { $joints } y para las dimensiones dadas aquí, con las longitudes en { unit-word }.
task-workspace-axis = ¿A qué distancia mínima y a qué distancia máxima del eje de la articulación 1 se puede llevar { $point }? { $limits ->
    [none] Cada articulación puede tomar cualquier valor.
   *[some] Las articulaciones respetan sus límites: { $ranges }; en la figura, { $drawn }.
} Dé los dos radios en { unit-word }.
task-workspace-point = ¿Cuáles son la menor y la mayor distancia entre { $point } y { $origin }? { $limits ->
    [none] Cada articulación puede tomar cualquier valor.
   *[some] Las articulaciones respetan sus límites: { $ranges }; en la figura, { $drawn }.
} Dé los dos radios en { unit-word }.

## Comentarios sobre las partes

feedback-part_wrong = Esta parte aún no es correcta.
feedback-schematic_right = La estructura es correcta.
feedback-schematic_joint_count = Ha indicado { $given ->
    [one] una articulación
   *[other] { $given } articulaciones
}; vuelva a contar cuántas pueden moverse.
feedback-schematic_joint_type = El tipo de la articulación { $joint } no es correcto.
feedback-schematic_relation = La posición relativa de los ejes { $first } y { $second } no es correcta.
feedback-schematic_angle_right = Ejes { $first } y { $second }: el ángulo entre ellos es correcto, pero no si se cortan.
feedback-schematic_meeting_right = Los ejes { $first } y { $second } sí se cortan, pero no con ese ángulo.
feedback-matrices_right = Las matrices de los eslabones son correctas.
feedback-matrices_follow_table = Las matrices de los eslabones se siguen de su tabla y reciben sus puntos, aunque la tabla no es correcta.
feedback-matrices_right_not_from_table = Las matrices de los eslabones son correctas para el robot, aunque no se siguen de su tabla.
feedback-matrices_product_wrong = Multiplicadas entre sí, sus matrices no describen este robot.
feedback-matrix_missing = Falta la matriz { $matrix }.
feedback-matrix_wrong = La matriz { $matrix } no corresponde a la fila { $matrix } de su tabla.
feedback-matrix_cells_wrong = La matriz { $matrix } difiere de la fila { $matrix } de su tabla en estas celdas (fila,columna): { $cells }.
feedback-matrix_inverse = La matriz { $matrix } está invertida: es la pose del sistema i−1 en el sistema i.
feedback-matrix_rotation_transposed = La rotación de la matriz { $matrix } está traspuesta.
feedback-matrix_other_convention = La matriz { $matrix } se formó con la regla de la otra convención.
feedback-matrix_without_variable = La matriz { $matrix } se escribió para la variable articular igual a cero; conserve la variable.
feedback-matrix_of_other_row = La matriz { $matrix } es la de la fila { $other }.
feedback-matrix_not_rigid = La matriz { $matrix } no es un movimiento rígido: sus columnas no son vectores unitarios perpendiculares, o forman una terna levógira (determinante −1), o su última fila no es 0 0 0 1.
feedback-transform_right = ⁰T es correcta.
feedback-transform_follows_table = ⁰T se sigue de su tabla y recibe sus puntos, aunque la tabla no es correcta.
feedback-transform_right_not_from_table = ⁰T es correcta para el robot, aunque no se sigue de su tabla.
feedback-table_says_little = Su tabla tiene menos de la mitad de las longitudes y los ángulos α que hacen falta para describir este robot; lo que se sigue de ella recibe solo una parte de sus puntos, y de una tabla de ceros, ninguno.
feedback-transform_wrong = Esta ⁰T no describe el robot.
feedback-transform_rotation_right = La rotación de ⁰T es correcta.
feedback-transform_position_right = La posición de ⁰T es correcta.
feedback-transform_cells_wrong = ⁰T difiere de su tabla en estas celdas (fila,columna): { $cells }.
feedback-transform_not_rigid = ⁰T no es un movimiento rígido: sus columnas no son vectores unitarios perpendiculares, o forman una terna levógira (determinante −1), o su última fila no es 0 0 0 1.
feedback-transform_inverse = Esta es la inversa de ⁰T: la pose del sistema 0 en el último sistema.
feedback-transform_rotation_transposed = La rotación de ⁰T está traspuesta.
feedback-transform_order_reversed = Las matrices de los eslabones se multiplicaron en orden inverso.
feedback-transform_links_missing = Este es el producto solo hasta el sistema { $last }; continúe hasta el último sistema.
feedback-pose_right = La pose es correcta.
feedback-pose_follows_table = La pose se sigue de su tabla y recibe sus puntos, aunque la tabla no es correcta.
feedback-pose_wrong = Esta pose no es la que su tabla da para estos valores articulares.
feedback-pose_last_row = La última fila de una pose es 0 0 0 1; con otra, la matriz no es una pose y no recibe puntos.
feedback-pose_rotation_right = La rotación es correcta.
feedback-pose_position_right = La posición es correcta.
feedback-pose_inverse = Esta es la inversa de la pose.
feedback-pose_rotation_transposed = La rotación está traspuesta.
feedback-pose_degrees_as_radians = Los senos y cosenos se calcularon tomando los grados por radianes.
feedback-workspace_right = Los dos radios son correctos.
feedback-workspace_inner_wrong = El radio interior no es correcto.
feedback-workspace_outer_wrong = El radio exterior no es correcto.
feedback-workspace_swapped = El radio interior y el exterior están intercambiados.
feedback-workspace_diameters = Estos son diámetros; se piden los radios.
feedback-workspace_other_length_unit = Los radios son correctos en otra unidad; se piden en { unit-word }.

## Por qué no se puede calificar una respuesta

problem-note-ungraded = Esta respuesta no se ha calificado y no gasta ningún intento.
error-answer_empty = No se ha entregado nada. El ejercicio pide { $known }.
error-part_not_asked = El ejercicio no pide { $part }; pide { $known }.
error-link_matrices_count = La tabla tiene { $expected ->
    [one] una fila
   *[other] { $expected } filas
}, pero { $given ->
    [one] se da una matriz
   *[other] se dan { $given } matrices
}. Dé una por cada fila; null omite una.
error-link_matrices_need_table = Sin la tabla, las matrices de los eslabones se juzgan por su producto. Inclúyalas todas.
error-pose_needs_table = La pose es la de su propia tabla. Entregue también la tabla.
error-matrix_not_4x4 = Una matriz tiene cuatro filas de cuatro celdas.
error-joint_variable_unknown = No existe { $name }; el robot tiene { $joints ->
    [one] una articulación
   *[other] { $joints } articulaciones
}.{ $summed ->
    [0] {""}
   *[other] {" "}Una suma se escribe entera: { $sum }.
}
error-short_form_unknown = { $name } se lee como un coseno o un seno, pero no todos sus índices son articulaciones de rotación; el robot tiene { $joints ->
    [one] una articulación
   *[other] { $joints } articulaciones
}.
error-radius_negative = Un radio no puede ser negativo.
error-schematic_fixed_joint = La estructura enumera las articulaciones que se mueven: de rotación o prismáticas.
error-schematic_relations_count = { $joints ->
    [one] Una articulación tiene
   *[other] { $joints } articulaciones tienen
} { $expected ->
    [one] un par
   *[other] { $expected } pares
} de ejes vecinos. Dé una relación por cada par.
error-seed_invalid = Una semilla es un texto o un número entero.
error-seed_too_long = Una semilla tiene como máximo { $limit } caracteres.
error-exercise_unknown = No hay ningún ejercicio { $id }. Disponibles: { $known }.
error-language_unknown = El idioma { $language } no está disponible aquí. Disponibles: { $known }.

## Por qué no se puede leer una definición

error-exercise_file_missing = Falta el archivo exercise.toml.
error-exercise_file_not_toml = Esto no es TOML: { $reason }
error-exercise_key_missing = Falta { $key }.
error-exercise_key_unknown = { $key } no es una clave conocida. Las claves conocidas son { $known }.
error-exercise_value_type = { $key } debe ser { expected-value }.
error-exercise_value_unknown = { $key } debe ser uno de estos valores: { $known }.
error-exercise_robot_unknown = El catálogo no contiene el robot { $robot }. Contiene { $known }.
error-exercise_limits_reversed = Los límites de la articulación { $joint } se dan como [mínimo, máximo].
error-exercise_limits_unknown = El catálogo no conoce los límites de este robot.
error-folder_missing = No hay ninguna carpeta { $folder }.
error-exercise_id_invalid = { $id } no es un identificador de ejercicio; un identificador tiene letras, cifras y guiones sencillos.
error-exercise_exists = El ejercicio { $id } ya existe.
error-source_unreadable = El archivo no se puede leer: { $reason }
error-robot_and_reference = Dé robot o [reference], no los dos.
error-statement_missing = Falta el enunciado en el idioma { $language }.
error-statement_name_unknown = { $name } no es una dimensión del robot ni un punto o una cota de la figura.
error-misconception_unknown = { $name } no es un error de la lista. Disponibles: { $known }.
error-nothing_asked = Un ejercicio debe pedir algo: añada una parte.
error-part_twice = { $kind } se pide dos veces.
error-points_not_positive = Una parte vale más de cero puntos.
error-draw_empty = No hay ningún valor que sortear: «from» no puede ser mayor que «to» y «step» debe ser positivo.
error-draw_too_large = Un sorteo tiene como máximo { $limit } valores.
error-variants_too_many = Hay como máximo { $limit } variantes.
error-tolerance_out_of_range = { $name } está entre 0 y 0,1.
error-name_invalid = { $name } no es el nombre de una dimensión; un nombre es como L1.
error-width_out_of_range = La anchura está entre 320 y 960.
error-unknown_point = No hay ningún punto { $name }. Disponibles: { $known }.
error-unknown_frame = No existe ese sistema de referencia: van del 0 al { $last }.
error-unknown_joint = No existe la articulación { $joint }: van de la 1 a la { $last }.
error-point_without_form = Un punto se da con frame y at; con between y ratio; con from y by; o con from, joint y distance.
error-joint_off_axis = El punto { $point } no está sobre el eje de la articulación { $joint }.
error-dimension_disagrees = Los puntos de { $name } distan { $length }, pero { $name } mide { $value }.
error-dimension_too_short = { $name } mide { $length }, demasiado poco para mostrarla en la figura: es menos de una millonésima del tamaño del robot. Dele otro valor o escriba 0 en su lugar.
error-posture_not_zero = Con zero = figure se dice a los estudiantes que en la configuración de la figura todas las variables articulares son cero: dibuje el robot en esa configuración (posture 0 en cada articulación) o deje libres los ceros.
error-tool_point_unmarked = Con tool = point el último origen debe estar en un punto marcado, pero ninguno de los puntos marcados es el último origen de la solución de referencia. Marque el origen del sistema { $last }.
error-gripper_without_direction = La pinza y el punto del que se aleja son el mismo.
error-jaws_along_gripper = Los dedos están uno al lado del otro, perpendiculares a la pinza.

error-name_unknown = { $name } no es ninguna de las dimensiones de este ejercicio.{ $unit ->
    [0] {""}
   *[one] {" "}Las unidades no se escriben en las celdas: si { $name } es una, omítala.
}{ $found ->
    [0] {""}
   *[one] {" "}¿Quería decir { $close }?
} Las dimensiones son { $known }.
error-need_unmet = Con estas reglas ninguna respuesta necesita { $name }: se pueden elegir sistemas en los que no aparece. { $rules ->
    [none] Ninguna regla lo cambia: quítelo de needs.
   *[other] Cualquiera de estas reglas basta para que haga falta: { $rules }.
}
error-need_unknown = { $name } no es ninguna dimensión de la tabla. Sus dimensiones: { $known }.
error-alias_taken = { $name } ya tiene un significado.
error-title_missing = Hace falta un título al menos en un idioma: [title] con en = "…".
exercise-other-language = Este ejercicio aún no está escrito en su idioma. Idioma del texto: { $language }.
rule-dimension-free = Con sistemas bien elegidos, su tabla puede prescindir de { $names }.
error-context_invalid = Este enlace no se creó aquí o ha sido modificado.
error-context_expired = Este enlace ha caducado.
error-switched_off = { $path } está desactivado para este ejercicio.
error-attempts_used_up = { $limit ->
    [one] Ya se ha hecho el único intento que permite este ejercicio.
   *[other] Ya se han hecho los { $limit } intentos que permite este ejercicio.
}
error-ladder_falls = A cada intento se le puede decir tanto como al anterior o más, nunca menos.
task-frames = Coloque los sistemas 0 a { $n } en el robot tal como lo muestra la figura: de cada uno, su origen, en { unit-word } y en las coordenadas de la figura, y las direcciones de x y z. { figure-place }
error-frames_count = Hay sistemas de 0 a N: se necesitan { $expected } y se han dado { $given }.
error-convention_not_asked = El ejercicio pide la convención { $asked ->
    [modified] modificada
   *[standard] estándar
}.
error-weight_out_of_range = El peso de { $name } es un número de 0 a { $most }.
