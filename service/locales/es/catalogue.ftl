# Archivos del catálogo de robots.

error-catalogue_not_toml = Esto no es TOML: { $reason }.
error-catalogue_key_missing = Falta { $key }.
error-catalogue_key_unknown = { $key } no es una clave conocida. Las claves conocidas son { $known }.
error-catalogue_value_type = { $key } debe ser { expected-value }.
error-catalogue_limits_reversed = Articulación { $joint }: el límite inferior debe ser menor que el superior.
error-catalogue_outside_limits = La articulación { $joint } de esta configuración está fuera de sus límites.
error-robot_unknown = El catálogo no contiene el robot { $robot }. Contiene { $known }.
expected-value = { $expected ->
    [text] un texto no vacío
    [texts] una lista de textos
    [number] un número cuyo valor absoluto es como máximo 10^15
    [integer] un número entero
    [count] un número entero no menor que 1
    [flag] true o false
    [table] una tabla
    [tables] una lista de tablas
    [cell] un número o una expresión
    [cells] una lista de { $count } números o expresiones
    [choice] uno de estos valores: { $known }
    [direction] una lista de tres números no todos nulos
    [point_names] una lista de { $count } nombres de puntos
    [point_chains] una lista de listas de al menos dos nombres de puntos
    [help_levels] una lista con al menos un nivel de ayuda
    [numbers] { $count ->
        [0] una lista de números finitos
       *[other] una lista de { $count } números finitos
    }
    [rows] { $count ->
        [0] una lista de listas de { $width } elementos
       *[other] una lista de { $count } listas de { $width } elementos
    }
   *[other] de otro tipo
}
