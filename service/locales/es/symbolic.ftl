# Formas cerradas.

error-form_too_large = La forma desarrollada requiere más de { $limit } productos de términos. Pida menos filas.
error-closed_form_too_large = Escrita por completo, una matriz tiene más de { $limit } operaciones. Pida menos filas, o una función (python, c, matlab y otras), que calcula una sola vez lo que se repite.
error-closed_form_too_deep = Un elemento tiene demasiados niveles de anidamiento para un árbol JSON. Pida texto o LaTeX.
error-computation_out_of_time = El cálculo tarda más de { $seconds } s. Pida menos filas, partes o formatos o, en lugar de fórmulas, números para valores articulares dados.
error-computation_out_of_memory = El cálculo ocupa más de { $megabytes } MiB de memoria. Pida menos filas, partes o formatos o, en lugar de fórmulas, números para valores articulares dados.
error-computation_aborted = El cálculo se interrumpió por un problema del servidor, no de su petición. Inténtelo de nuevo dentro de un momento.
