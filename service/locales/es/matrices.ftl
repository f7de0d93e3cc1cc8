field-cell_row = Fila de un elemento incorrecto
field-cell_column = Columna de un elemento incorrecto
field-mistake = Qué está mal
field-mended_matrix = La matriz como debería ser
option-entry_sign = un elemento de la rotación tiene el signo equivocado
option-sine_for_cosine = en un elemento de la rotación se han confundido seno y coseno
option-position_sign = un elemento de la posición tiene el signo equivocado
option-position_missing = falta un elemento de la posición
option-position_sine_for_cosine = en un elemento de la posición se han confundido seno y coseno
option-rotation_transposed = la rotación está traspuesta
option-matrix_other_convention = se formó en la otra convención
option-link_missing = se omitió un eslabón en el producto
given-matrix-with-mistake =
    { $matrix ->
        [link] La matriz de la fila { $row }, con un error
       *[transform] ⁰T_N, con un error
    }

task-matrix-mistake =
    { $matrix ->
        [link] La tabla es correcta. Alguien escribió la matriz de su fila { $row }, la pose del sistema { $row } en el anterior, y cometió un error.
       *[transform] La tabla es correcta. Alguien escribió ⁰T_N, el producto de todas sus matrices, y cometió un error.
    } Dé un elemento que esté mal, diga qué falló y escriba la matriz entera como debería ser.

feedback-matrix_mistake_place_wrong = Este elemento es correcto; el error está en otra parte.
feedback-matrix_mistake_name_wrong = El error es de otro tipo.
feedback-matrix_not_mended = Esta aún no es la matriz de la tabla.
feedback-matrix_mistake_missing =
    { $what ->
        [cell_row] Dé la fila y la columna de un elemento incorrecto.
        [mistake] Diga qué está mal.
       *[mended_matrix] Escriba la matriz como debería ser.
    }

field-wrong_frame = Sistema con el error
field-mended_origin = Su origen como debería ser
field-mended_x = Su eje x como debería ser
field-mended_y = Su eje y como debería ser
field-mended_z = Su eje z como debería ser
option-z_not_along_axis = z no sigue el eje de su articulación
option-origin_not_on_axis = el origen no está en el eje de su articulación
option-origin_not_on_common_normal = el origen no está en la normal común
option-origin_not_at_intersection = el origen no está donde se cortan los dos ejes
option-x_not_across_z = x no es perpendicular a z
option-x_not_along_common_normal = x no sigue la normal común
option-x_not_across_both_axes = x no es perpendicular a los dos ejes
option-first_x_misses_axis = x del primer sistema no corta el eje 1 en ángulo recto
option-last_x_misses_axis = x del último sistema no corta el último eje en ángulo recto
option-y_left_handed = el sistema es levógiro: y no es z × x
given-drawn-frames = Los sistemas tal como están dibujados

task-frame-mistake =
    { $convention ->
        [standard] Los sistemas de la figura deberían seguir la convención estándar, con z del sistema i a lo largo de la articulación i+1
       *[modified] Los sistemas de la figura deberían seguir la convención modificada, con z del sistema i a lo largo de la articulación i
    }, pero uno de ellos tiene un error. ¿Qué sistema está mal, qué tiene mal y cómo debería estar? Los puntos y las direcciones se dan en las coordenadas de la figura; la longitud de una dirección no importa. { figure-place }

feedback-frame_mistake_place_wrong = Este sistema está bien; el error está en otro.
feedback-frame_mistake_name_wrong = El error es de otro tipo.
feedback-frame_not_mended = Con este sistema el dibujo sigue sin cumplir alguna regla.
feedback-frame_mistake_missing =
    { $what ->
        [wrong_frame] Diga qué sistema está mal.
        [mistake] Diga qué está mal.
       *[mended_origin] Indique el origen, x, y y z como deberían ser.
    }
