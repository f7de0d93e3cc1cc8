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
        [link] La tabla es correcta. Alguien escribió la matriz de su fila { $row }, del sistema { $row } al anterior, y cometió un error.
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
