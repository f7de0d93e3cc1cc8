# Rechazos del servicio HTTP.

problem-title-400 = La petición no se puede leer
problem-title-404 = No encontrado
problem-title-405 = Este método no está disponible aquí
problem-title-406 = Ningún formato de respuesta aceptable
problem-title-408 = La petición tardó demasiado en llegar
problem-title-413 = La petición es demasiado grande
problem-title-415 = Este tipo de cuerpo no se admite
problem-title-422 = La petición no se puede ejecutar tal como está
problem-title-500 = El servicio ha fallado
problem-title-503 = El servicio está ocupado

error-body_missing = La petición no tiene cuerpo. Envíe un objeto JSON.
error-body_invalid = El cuerpo no se puede leer. Envíe un objeto JSON en UTF-8.
error-json_not_utf8 = El cuerpo no está en UTF-8, como exige JSON.
error-json_too_deep = El documento JSON tiene demasiados niveles de anidamiento.
error-json_not_finite = Línea { $line }, columna { $column }: un número debe ser finito. JSON no tiene NaN ni infinito.
error-json_invalid = El cuerpo no es JSON: línea { $line }, columna { $column }. El analizador dice: { $reason }.
error-json_duplicate_key = La clave «{ $key }» aparece dos veces en un mismo objeto. Deje solo una.
error-json_too_many_values = El cuerpo contiene demasiado: se leen como máximo { $limit } valores, campos, listas u objetos.
error-json_too_many_fields = Un objeto del cuerpo tiene { $given } campos; ninguna llamada tiene más de { $limit }.
error-body_timed_out = El cuerpo no llegó en { $seconds } s. Envíelo más deprisa o en partes más pequeñas.
error-content_encoding_unsupported = Los cuerpos comprimidos no se leen. Envíe el cuerpo sin Content-Encoding.
error-charset_unsupported = El cuerpo se anuncia como { $charset }. JSON se lee solo en UTF-8.
error-media_type_unsupported =
    { $given ->
        [none] La petición no dice qué es su cuerpo.
       *[other] El cuerpo se anuncia como { $given }.
    } Esta llamada lee { $offers }: indíquelo en la cabecera Content-Type.
error-not_acceptable = Esta llamada responde en { $offers }; la cabecera Accept lo excluye todo.
error-body_too_large =
    El cuerpo tiene más de { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }, lo máximo que lee esta llamada.
error-method_not_allowed = Esta dirección admite { $allowed }, pero no { $method }.
error-address_unknown = No hay nada en { $path }. El documento /api/v1/openapi.json enumera todas las llamadas.
error-problem_unknown = Ningún rechazo tiene el código { $code }.
error-internal_error = El servicio ha fallado en esta petición. Comuníquelo con el identificador { $id }.
error-busy = El servidor está ocupado. Inténtelo de nuevo dentro de { $seconds } s.

error-field_missing = Falta el campo «{ $field }».
error-field_unknown = Aquí no existe el campo «{ $field }». Los campos son: { $allowed }.
error-target_or_position = Indique exactamente uno de «target», «targets» y «position»; con una posición, a lo sumo uno de «quaternion» y «axis».
error-table_or_robot = Indique «table» o «robot»: exactamente uno de los dos.
error-number_expected = «{ $field }» debe ser un número.
error-number_not_finite = «{ $field }» debe ser un número finito.
error-number_too_small =
    { $bound ->
        [excluded] El número debe ser mayor que { $limit }.
       *[included] El número debe ser al menos { $limit }.
    }
error-number_too_large =
    { $bound ->
        [excluded] El número debe ser menor que { $limit }.
       *[included] El número debe ser como máximo { $limit }.
    }
error-integer_expected = «{ $field }» debe ser un número entero.
error-boolean_expected = «{ $field }» debe ser true o false.
error-string_expected = «{ $field }» debe ser texto.
error-string_too_long =
    El texto es demasiado largo: { $limit ->
        [one] se lee como máximo un carácter
       *[other] se leen como máximo { $limit } caracteres
    }.
error-string_too_short =
    El texto es demasiado corto: { $limit ->
        [one] hace falta al menos un carácter
       *[other] hacen falta al menos { $limit } caracteres
    }.
error-string_pattern = El texto no tiene la forma esperada, { $pattern }.
error-list_expected = «{ $field }» debe ser una lista.
error-list_too_long =
    La lista es demasiado larga: puede tener como máximo { $limit ->
        [one] un elemento
       *[other] { $limit } elementos
    }.
error-list_too_short =
    La lista es demasiado corta: necesita al menos { $limit ->
        [one] un elemento
       *[other] { $limit } elementos
    }.
error-object_expected = «{ $field }» debe ser un objeto con campos con nombre.
error-body_not_object = El cuerpo debe ser un objeto JSON con campos con nombre.
error-null_expected = «{ $field }» debe ser null o faltar.
error-value_not_allowed = El valor debe ser uno de estos: { $expected }.
error-value_invalid = Este valor no se puede usar: { $reason }.

error-joints_wrong_dimensions = Una matriz de variables articulares tiene una o dos dimensiones, no { $dimensions }: (articulaciones) o (configuraciones, articulaciones).
error-batch_too_large = El lote tiene { $given } configuraciones; en una petición se calculan como máximo { $limit }.
error-query_missing = Las articulaciones llegaron como npy; el resto de la petición va, como JSON, en el parámetro de consulta «request».
error-npy_header_invalid =
    El cuerpo no es un archivo npy como lo escribe numpy.save: { $rule ->
        [magic] debe empezar por \x93NUMPY, una versión y la longitud de la cabecera
        [version] su versión debe ser 1.0, 2.0 o 3.0
        [header] su cabecera debe estar completa, tener como máximo 4096 bytes y nombrar descr, fortran_order y shape
       *[shape] shape debe ser una tupla de dimensiones que pueda tener un array
    }.
error-npy_length_mismatch =
    La cabecera npy promete { $promised ->
        [one] { $promised } byte
       *[other] { $promised } bytes
    } de datos; le siguen { $present }.
error-npy_object_refused = El archivo npy contiene objetos de Python, que nunca se deserializan. Envíe una matriz de números.
error-npy_type_unsupported = El archivo npy contiene { $type }. Envíe números reales, como float64 (<f8).
error-npy_one_part = Un archivo npy contiene una sola matriz. Nombre una parte: { $allowed }.
error-one_source = Describa el robot de una sola manera: { $allowed }.

error-api_key_missing = La petición no indica ninguna clave. Envíela como Authorization: Bearer fwk_….
error-api_key_invalid = Esta clave no se conoce aquí, ha caducado o fue revocada.
error-api_key_scope = Esta clave sirve para { $scopes }; la llamada necesita { $needed }.
error-idempotency_key_length = Una Idempotency-Key tiene de 1 a { $limit } caracteres.
error-idempotency_key_in_use = Todavía se está respondiendo a una petición con esta Idempotency-Key. Inténtelo de nuevo dentro de un segundo.
error-idempotency_key_reused = Esta Idempotency-Key ya se usó para otra petición. Use una clave nueva para una petición nueva.
error-rate_exceeded = Se ha superado el límite de { $limit } unidades de coste por minuto. Inténtelo de nuevo dentro de { $seconds } s.
error-setting_missing = Falta el ajuste { $name }.
problem-title-429 = Demasiadas peticiones
error-quaternion_or_axis = Indique a lo sumo uno de «quaternion» y «axis».

language-name = Español
