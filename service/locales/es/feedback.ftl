# Lo que el corrector dice de una tabla: de una correcta, de una incorrecta, y qué la enmendaría.

## Una respuesta correcta, y cómo quedan sus sistemas respecto a la solución de referencia

feedback-same_frames = Sus sistemas de referencia son los de la solución de referencia.
feedback-other_convention = Su tabla está escrita en la convención { $convention ->
    [modified] modificada y la solución de referencia en la estándar
   *[standard] estándar y la solución de referencia en la modificada
}; ambas describen el mismo robot.
feedback-axis_reversed = Su z{ $frame }, el eje de la articulación { $joint }, apunta en sentido opuesto al de la solución de referencia. Ambos sentidos son correctos, y los signos de su tabla concuerdan con el suyo.
feedback-end_axis_reversed = Su z{ $frame } apunta en sentido opuesto al de la solución de referencia. Ambos sentidos son correctos.
feedback-x_turned = Su x{ $frame } está girado { $degrees }° alrededor de z{ $frame } respecto a la solución de referencia. Su tabla lo tiene en cuenta.
feedback-origin_slid = El origen de su sistema { $frame } no está en el mismo punto de z{ $frame } que el de la solución de referencia. Aquí cualquier punto es correcto.
feedback-axis_moved = Su z{ $frame } está sobre otra recta, paralela a la de la solución de referencia. Aquí solo importa su dirección.
feedback-frame_elsewhere = Su sistema { $frame } está colocado de otro modo que en la solución de referencia. Podía elegirlo libremente.
feedback-variable_reversed = Su q{ $joint } crece en sentido opuesto al de la solución de referencia. Ambos sentidos son correctos.
feedback-variable_offset = Cuando la q{ $joint } de la solución de referencia vale cero, la suya vale { $offset }. El cero de una variable articular se elige libremente.
feedback-rounded = Sus valores concuerdan con la solución de referencia dentro de la tolerancia, no exactamente; puede que estén redondeados.

## Una respuesta incorrecta: el conjunto

feedback-not_equivalent = Su tabla no describe este robot, se elijan como se elijan los sistemas de referencia.
feedback-right_robot = Su tabla describe el robot correcto, pero no cumple todo lo que pide el ejercicio.
feedback-not_accepted = Su tabla no cumple todo lo que pide el ejercicio.
feedback-convention_not_asked = El ejercicio pide la convención { $asked ->
    [modified] modificada
   *[standard] estándar
}; su tabla está en la { $given ->
    [modified] modificada
   *[standard] estándar
}.
feedback-joint_count_wrong = { $given ->
    [0] Su tabla no tiene articulaciones
    [1] Su tabla tiene una articulación
   *[other] Su tabla tiene { $given } articulaciones
}; el robot tiene { $asked }.
feedback-mirrored = Su tabla describe la imagen especular del robot: todas las longitudes y los ángulos concuerdan, pero alguno se mide al revés. Revise los signos con la regla de la mano derecha.
feedback-entries_imprecise = Ninguna longitud ni ningún ángulo de su tabla difiere más de lo que explica el redondeo, pero todos los redondeos juntos superan lo que admite el ejercicio. Escriba los ángulos de forma exacta, como pi/2 o 90°, y las longitudes con más cifras.
feedback-lengths_rounded = Varias longitudes de su tabla tienen el valor correcto, pero con demasiado pocas cifras. Escríbalas con más cifras; lo demás que se indica aquí son otros errores.
feedback-base_axis_missed = Su z0 no está sobre el eje de la articulación 1.
feedback-base_origin_missed = El origen de su sistema 0 no está donde lo pide el ejercicio.
feedback-base_frame_missed = Su sistema 0 no es el que prescribe el ejercicio.
feedback-tool_point_missed = El origen de su último sistema no está en el punto marcado.
feedback-tool_axis_missed = El eje z de su último sistema no está sobre el eje de la última articulación.
feedback-tool_frame_missed = Su último sistema no es el que prescribe el ejercicio.
feedback-zero_missed = En la configuración de la figura todas las variables articulares deberían ser cero; las suyas no lo son.
feedback-direction_missed = Las variables articulares deberían crecer en el sentido de las flechas de la figura; no todas las suyas lo hacen.
feedback-whole_table = Un mismo error recorre toda la tabla.
feedback-columns_throughout = Las columnas a y α no corresponden a la convención que declara su tabla.
feedback-columns_in_disorder = Las columnas de su tabla están en otro orden.
feedback-angles_throughout = Los ángulos de su tabla no están en la unidad que declara.
feedback-lengths_throughout = Las longitudes de su tabla no están en la unidad que declara.
feedback-turns_throughout = Todos los ángulos articulares de su tabla crecen en el sentido equivocado.
feedback-twists_throughout = Todos los ángulos α de su tabla tienen el signo equivocado.
feedback-twists_out_of_place = Los ángulos α de su tabla no están en las filas a las que pertenecen.
feedback-names_throughout = Una dimensión lleva un nombre equivocado en su tabla.
feedback-parameter_unknown = El robot no tiene ninguna dimensión llamada { $name }. Sus dimensiones son: { $known }.
feedback-names_asked = Las dimensiones del robot no tienen valores aquí. Escriba sus nombres: { $known }.

## Una respuesta incorrecta: sus filas

feedback-one_of_these = Solo uno de los siguientes puntos es el error; la tabla por sí sola no muestra cuál.
feedback-row_wrong = La fila { $row } no es correcta.
feedback-twist_wrong = Fila { $row }: la torsión α, el ángulo de z{ $before } a z{ $row }, no es correcta.
feedback-length_wrong = Fila { $row }: la longitud a, la distancia de z{ $before } a z{ $row }, no es correcta.
feedback-offset_wrong = Fila { $row }: el desplazamiento d, la distancia de x{ $before } a x{ $row } a lo largo de z, no es correcto.
feedback-angle_wrong = Fila { $row }: el ángulo θ, de x{ $before } a x{ $row } alrededor de z, no es correcto.
feedback-sign_wrong = Fila { $row }: hay un signo al revés. Revise: { $cells }.
feedback-joint_type_wrong = Fila { $row }: el tipo de la articulación no es correcto.
feedback-variable_zero_wrong = Fila { $row }: en la configuración de la figura, la variable articular no vale cero.
feedback-variable_direction_wrong = Fila { $row }: la variable articular crece en sentido contrario al de la flecha de la figura.
feedback-row_missing = Falta una fila { $after ->
    [0] antes de la fila 1
   *[other] después de la fila { $after }
}.
feedback-row_not_needed = La fila { $row } está de más.
feedback-rows_out_of_order = Las filas { $row } y { $other } están en el orden equivocado.

## Lo que la haría correcta

repair-convention = Leída en la convención { $meant ->
    [modified] modificada
   *[standard] estándar
}, su tabla sería correcta; usted declaró la { $declared ->
    [modified] modificada
   *[standard] estándar
}.
repair-angles_in_degrees = Los ángulos están en grados, pero la tabla declara radianes.
repair-angles_in_radians = Los ángulos están en radianes, pero la tabla declara grados.
repair-length_unit = Las longitudes están en una unidad distinta de la declarada: milímetros en vez de metros, por ejemplo.
repair-columns_late = Las columnas a y α están una fila más abajo, como en la otra convención. ¿A qué eslabón pertenece cada fila?
repair-columns_early = Las columnas a y α están una fila más arriba, como en la otra convención. ¿A qué eslabón pertenece cada fila?
repair-twists_late = La columna α está una fila más abajo; a está en su lugar. En una fila, a y α pertenecen al mismo eslabón.
repair-twists_early = La columna α está una fila más arriba; a está en su lugar. En una fila, a y α pertenecen al mismo eslabón.
repair-columns_exchanged = Las columnas { $one } y { $other } están intercambiadas. Compare el orden de las columnas con el de sus apuntes.
repair-columns_reordered = Lo que está bajo α corresponde a { $alpha }, lo que está bajo a corresponde a { $a } y lo que está bajo d corresponde a { $d }. Compare el orden de las columnas con el de sus apuntes.
repair-parameter_misnamed = { $name } no es una dimensión de este robot. ¿A cuál de la figura se refiere?
repair-parameters_swapped = { $name } y { $other } están intercambiadas. Compárelas con la figura.
repair-alpha_sign = Fila { $row }: α tiene el signo equivocado. Gire z{ $before } hasta z{ $row } alrededor de x, según la regla de la mano derecha.
repair-alpha_value = Fila { $row }: α tiene un valor erróneo. Vuelva a mirar cómo están z{ $before } y z{ $row } uno respecto al otro.
repair-turns_all_reversed = Todos los ángulos articulares crecen en el sentido equivocado. Gire alrededor de z con la mano derecha, no con la izquierda.
repair-twists_all_reversed = Todos los α tienen el signo equivocado. Gire un eje z hasta el siguiente alrededor de x con la mano derecha, no con la izquierda.
repair-a_sign = Fila { $row }: a tiene el signo equivocado. Se mide en el sentido de x.
repair-d_sign = Fila { $row }: d tiene el signo equivocado. Se mide en el sentido de z.
repair-twists_swapped = Filas { $row } y { $other }: los valores de α se han intercambiado.
repair-a_d_swapped = Fila { $row }: a y d se han intercambiado. a se mide a lo largo de x, d a lo largo de z.
repair-a_value = Fila { $row }: a tiene un valor erróneo. Mida sobre la normal común de z{ $before } y z{ $row }.
repair-a_missing = Fila { $row }: a no debería ser cero, pues z{ $before } y z{ $row } no se cortan.
repair-a_not_zero = Fila { $row }: a debería ser cero, pues z{ $before } y z{ $row } se cortan o coinciden.
repair-d_value = Fila { $row }: d tiene un valor erróneo. Mida a lo largo de z, de x{ $before } a x{ $row }.
repair-d_missing = Fila { $row }: se ha omitido el desplazamiento d a lo largo de z, de x{ $before } a x{ $row }.
repair-d_not_zero = Fila { $row }: d debería ser cero, pues x{ $before } y x{ $row } cortan a z en el mismo punto.
repair-cell_length_unit = Fila { $row }: una longitud está en una unidad distinta de las demás.
repair-cell_parameter = Fila { $row }: aquí corresponde otra dimensión de la figura.
repair-cell_in_degrees = Fila { $row }: un ángulo está en grados, pero la tabla declara radianes.
repair-cell_in_radians = Fila { $row }: un ángulo está en radianes, pero la tabla declara grados.
repair-theta_value = Fila { $row }: el ángulo constante θ tiene un valor erróneo. Gire x{ $before } hasta x{ $row } alrededor de z.
repair-theta_offset = Fila { $row }: en θ hay que sumar a la variable otra constante, para que la variable sea cero en la configuración de la figura.
repair-d_offset = Fila { $row }: en d hay que sumar a la variable otra constante, para que la variable sea cero en la configuración de la figura.
repair-variable_sign = Fila { $row }: la variable articular crece en el sentido equivocado. Póngale el signo opuesto.
repair-joint_type = Fila { $row }: esta articulación { $joint_type ->
    [prismatic] se desliza; su variable va en d
   *[revolute] gira; su variable va en θ
}.
repair-joint_fixed = Fila { $row }: esta articulación se mueve; falta su variable.
repair-joint_moving = Fila { $row }: aquí no se mueve nada; la fila solo tiene constantes.
repair-rows_swapped = Las filas { $row } y { $other } se han intercambiado.
repair-fixed_row_missing = Falta una última fila sin variable: la que lleva de la última articulación al punto marcado o al último sistema prescrito.
repair-row_missing = Falta una fila { $after ->
    [0] antes de la fila 1
   *[other] después de la fila { $after }
}.
repair-row_extra = La fila { $row } está de más.

## Rechazado

error-tables_without_value = No se encontraron valores de los parámetros para los que todas las celdas de ambas tablas tengan valor. Revise las raíces, los cocientes y las funciones inversas.

feedback-frame_wrong = El sistema { $frame } incumple una regla.
feedback-frame_missing = El sistema { $frame } no se ha colocado.
feedback-frame_z_not_along_axis = Sistema { $frame }: { rule-z_not_along_axis }
feedback-frame_origin_not_on_axis = Sistema { $frame }: { rule-origin_not_on_axis }
feedback-frame_origin_not_on_common_normal = Sistema { $frame }: { rule-origin_not_on_common_normal }
feedback-frame_origin_not_at_intersection = Sistema { $frame }: { rule-origin_not_at_intersection }
feedback-frame_x_not_across_z = Sistema { $frame }: { rule-x_not_across_z }
feedback-frame_x_not_along_common_normal = Sistema { $frame }: { rule-x_not_along_common_normal }
feedback-frame_x_not_across_both_axes = Sistema { $frame }: { rule-x_not_across_both_axes }
feedback-frame_first_x_misses_axis = Sistema { $frame }: { rule-first_x_misses_axis }
feedback-frame_last_x_misses_axis = Sistema { $frame }: { rule-last_x_misses_axis }
feedback-frames_other_convention = Estos sistemas cumplen las reglas de la otra convención.
feedback-frames_not_as_asked = Los sistemas cumplen las reglas, pero no están colocados como pide el ejercicio.
feedback-frames_right = Los sistemas son correctos.
feedback-repairs_one_cell = Hay varios cambios posibles, y cada uno por sí solo corregiría la tabla; todos están en la celda { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
} de la fila { $row }.
feedback-repairs_one_row = Hay varios cambios posibles, y cada uno por sí solo corregiría la tabla; todos están en la fila { $row }.
feedback-repairs_one_column = Hay varios cambios posibles, y cada uno por sí solo corregiría la tabla; todos están en la columna { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
}.
feedback-repairs_one_kind = Hay { $count } cambios posibles, y cada uno por sí solo corregiría la tabla; todos son del mismo tipo.
