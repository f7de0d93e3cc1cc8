# Ficheros de estudiantes, correctores de otros sistemas, paquetes SCORM, comprobantes.

error-file_too_large =
    { $file } ocupa más de { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }; una tabla ocupa unos pocos kilobytes.
error-file_missing = No existe ningún archivo ni carpeta { $file }.
error-grade_path_needed = Hace falta un archivo, una carpeta o un archivo zip: la entrada estándar (-, o ningún argumento) solo se lee con --for.
error-options_without_effect = { $options } no tendría ningún efecto { $host ->
    [yes] con --for
   *[no] sin --for
}.
error-marks_are_text = { $file } no contendría una hoja de cálculo: las calificaciones se escriben como texto que leen las hojas de cálculo. Dé al archivo un nombre terminado en .csv.
error-file_unreadable = No se puede leer { $file }: { $reason ->
    [empty] está vacío
    [binary] no es un archivo de texto
    [columns] sus filas no se pueden dividir en columnas; guárdelo como CSV
    [UTF-16] empieza como UTF-16, pero no lo es del todo; guárdelo como UTF-8
   *[other] { $reason }
}.
error-file_unusable = No se puede leer o escribir { $file }: { $reason }.
error-file_type_unknown = { $file } es de un tipo que aquí no se lee. Se leen { $known }.
error-file_without_table = { $file } no contiene ninguna tabla DH. Una tabla tiene las columnas theta, d, a y alpha.
error-files_too_many = { $file } contiene más de { $limit } archivos.
error-rows_too_many = { $file } tiene más de { $limit } filas. Divídalo en varios archivos.
error-columns_unknown = Ninguna fila de { $file } nombra las columnas { $known }. Escríbalas encima de la tabla.
error-columns_repeated = Los títulos { $titles } de { $file } designan la misma columna. Escriba cada columna una sola vez; el desplazamiento de una articulación va en su celda: q1 + 90.
error-units_differ = Los títulos de { $file } nombran dos unidades para la misma magnitud: { $units }. Escriba todos los ángulos en una misma unidad, y todas las longitudes en una misma unidad.
error-columns_differ_in_length = Las columnas de { $file } tienen longitudes distintas; cada una necesita una entrada por fila.
error-exercise_not_named = No se dice a qué ejercicio responde. Indíquelo, por ejemplo puma560.
error-artefact_unknown = Aquí no se evalúan artefactos de tipo { $type }; sí { $known }.
error-function_command_unknown = Este comando no se conoce. Comandos conocidos: { $known }.
error-function_call_invalid = El cuerpo de una llamada tiene `response`, `answer` y `params` (un objeto). No es así en: { $places }.
error-callback_not_allowed = El operador de este servicio no permite enviar comentarios a esa dirección.
error-version_not_supported = Aquí no se admite esa versión de la API de evaluación; sí { $supported }.

error-api_key_unknown = No hay ninguna clave { $id }.
error-key_file_unreadable = { $file } no es un archivo de claves utilizable: { $reason }.
error-receipt_kid_unknown = { $file } no contiene ninguna clave { $id }.
error-receipt_malformed = Esto no es un comprobante, o no está entero. Cópielo desde el primer carácter hasta el último.
error-receipt_key_unknown = El comprobante se firmó con una clave que este servicio no tiene. Pregunte al servicio que lo emitió.
error-receipt_altered = El comprobante se modificó después de emitirse.

evaluation-right = Correcto
evaluation-wrong = Todavía no es correcto
evaluation-readable = La respuesta se puede calificar.
evaluation-unreadable = La respuesta no se puede calificar tal como está; esto no cuenta como intento.

scorm-no-script = Este ejercicio necesita JavaScript.
scorm-no-lms = No se ha encontrado ninguna plataforma de aprendizaje alrededor de esta página. Puede practicar, pero no se registrará ninguna calificación.

grade-summary = Respuestas correctas: { $right }, incorrectas: { $wrong }, imposibles de calificar: { $ungraded }.
grade-left-out = Archivos omitidos por su tipo: { $count } ({ $files }).
