# Por qué se rechaza una celda, una tabla o un parámetro.

error-cell_empty = Esta celda está vacía. Si el valor es cero, escriba 0.
error-cell_dash = Esta celda no contiene ningún valor. Si el valor es cero, escriba 0.
error-cell_not_a_value =
    Una celda contiene un número o una expresión en texto, no { $kind ->
        [list] una lista
        [dict] un objeto
       *[other] { $kind }
    }.
error-cell_too_long = Esta celda tiene { $length } caracteres; se leen como máximo { $limit }.
error-cell_too_deep = Esta celda supera { $limit } niveles de anidamiento.
error-cell_too_many_symbols = Esta celda contiene más de { $limit } nombres distintos.

error-character_not_allowed = En el carácter { $column }: { $character } no tiene significado en una celda.
error-character_invisible = En el carácter { $column }: hay un carácter invisible o de control ({ $character }). Bórrelo.
error-character_lookalike = En el carácter { $column }: { $character } solo se parece a la letra latina { $latin }. Escriba { $latin }.
error-character_full_width = En el carácter { $column }: { $character } es un carácter de ancho completo. Escriba { $latin }.
error-dollar_misplaced = En el carácter { $column }: $ solo puede encerrar la celda entera.
error-command_unknown = En el carácter { $column }: el comando \{ $command } no se reconoce.
error-script_misplaced = En el carácter { $column }: { $character } no sigue a nada a lo que pueda pertenecer.

error-number_malformed = En el carácter { $column }: { $text } no es un número decimal. Escriba cifras y un solo punto, sin separadores.
error-number_too_long = En el carácter { $column }: un número puede tener como máximo { $limit } cifras.
error-number_out_of_range =
    { $size ->
        [small] En el carácter { $column }: este número está demasiado cerca de 0 para leerse. Escriba 0.
       *[large] En el carácter { $column }: el valor absoluto de un número es como máximo { $largest }.
    }
error-cell_not_finite = Una celda contiene solo números finitos; NaN e infinito se rechazan.
error-decimal_comma = En el carácter { $column }: escriba punto decimal en lugar de coma: { $suggestion }.
error-minutes_in_cell = En el carácter { $column }: no se leen minutos ni segundos de arco. En decimales, { $text } es { $suggestion }.
error-about_in_cell = En el carácter { $column }: una celda dice cuál es el valor, sin { $character }. Escriba { $suggestion }.

error-names_run_together = En el carácter { $column }: { $text } está pegado a lo que sigue. Escriba el producto con *.
error-name_malformed = En el carácter { $column }: el guion bajo va solo entre una letra y su índice, como en L_1.
error-name_too_long = En el carácter { $column }: un nombre puede tener como máximo { $limit } caracteres.
error-name_is_not_a_number = En el carácter { $column }: { $name } no es un valor. Una celda contiene solo números finitos.
error-unit_in_cell = En el carácter { $column }: las unidades no se escriben en las celdas. Si la unidad que se pide es { $name }, escriba { $suggestion }; si no, convierta antes.
error-function_unknown = En el carácter { $column }: { $name } no es una función. Las funciones son { $functions }. Un producto se escribe { $name }*(…).
error-function_without_parentheses =
    En el carácter { $column }: escriba el argumento de { $name } entre paréntesis: { $name }({ $name ->
        [atan2] y, x
        [arctan2] y, x
       *[other] x
    }).
error-function_arity =
    { $expected ->
        [one] En el carácter { $column }: { $name } lleva un argumento, no { $given }.
       *[other] En el carácter { $column }: { $name } lleva { $expected } argumentos, no { $given }.
    }

error-value_missing = En el carácter { $column }: falta un valor antes de { $symbol }.
error-cell_incomplete = En el carácter { $column }: la celda termina donde debería seguir un valor.
error-symbol_misplaced = En el carácter { $column }: { $symbol } no puede estar aquí.
error-comma_misplaced = En el carácter { $column }: la coma solo separa los dos argumentos de atan2.
error-parenthesis_not_closed = En el carácter { $column }: este paréntesis no se cierra.
error-parenthesis_not_opened = En el carácter { $column }: este paréntesis no cierra nada.
error-number_after_value = En el carácter { $column }: un número no puede ir justo después de un valor. ¿Falta un operador?
error-division_ambiguous = En el carácter { $column }: no está claro entre qué se divide. Escriba a/(b*c) o (a/b)*c.
error-exponent_ambiguous = En el carácter { $column }: { $text } puede significar { $number } o { $difference }. Escriba uno de los dos.

error-exponent_not_constant = En el carácter { $column }: un exponente es un número racional.
error-exponent_out_of_range = En el carácter { $column }: un exponente vale como máximo { $limit } en valor absoluto, y su denominador también.
error-division_by_zero = En el carácter { $column }: aquí se divide entre cero.
error-value_not_real = Esta celda no tiene un valor real finito.
error-degree_of_angle = En el carácter { $column }: el signo de grado sigue a un número; esto ya es un ángulo.
error-degree_in_length = En el carácter { $column }: una longitud no se expresa en grados.
error-angle_in_length = En el carácter { $column }: { $name } da un ángulo en grados, que no es una longitud.
error-angle_product = En el carácter { $column }: se multiplican dos ángulos. Un ángulo solo se multiplica por números.
error-angle_in_denominator = En el carácter { $column }: se divide entre un ángulo. Aquí solo se divide entre números.
error-angle_power = En el carácter { $column }: un ángulo no se eleva a una potencia.
error-parameter_two_kinds =
    En el carácter { $column }: { $name } representa aquí { $kind ->
        [angle] un ángulo
       *[length] una longitud
    } y en otro lugar { $other ->
        [angle] un ángulo
       *[length] una longitud
    }. Use dos nombres.

error-variable_without_number = En el carácter { $column }: { $name } necesita el número de su articulación, como en { $suggestion }.
error-variable_misspelled = En el carácter { $column }: { $name } no es una variable articular. Escriba { $suggestion } o θ con el número de la articulación.
error-variable_called = En el carácter { $column }: { $name } es una variable articular y no lleva nada entre paréntesis. Escriba la constante como sumando: { $name } + ….
error-variable_scaled = En el carácter { $column }: { $name } está multiplicada por { $factor }. Una variable articular entra como +{ $name } o -{ $name }; si no, no sería el movimiento de su articulación.
error-variable_in_product = En el carácter { $column }: { $name } está multiplicada por otra magnitud. Una variable articular entra como +{ $name } o -{ $name } más una constante.
error-variable_in_denominator = En el carácter { $column }: { $name } está en un denominador. Una variable articular entra como +{ $name } o -{ $name } más una constante.
error-variable_in_power = En el carácter { $column }: { $name } está elevada a una potencia. Una variable articular entra como +{ $name } o -{ $name } más una constante.
error-variable_in_function = En el carácter { $column }: { $name } está dentro de una función. La celda contiene la propia variable articular; los senos y cosenos resultan de la tabla.
error-variable_in_constant_cell = En el carácter { $column }: { $name } está en { $cell }. La longitud y la torsión de un eslabón nunca varían; una variable articular va en θ (de rotación) o en d (prismática).
error-variable_in_fixed_row = En el carácter { $column }: { $name } está en una fila declarada fija. Una fila fija no tiene variable articular.
error-variable_in_wrong_cell =
    En el carácter { $column }: { $name } está en { $cell }, pero la variable de una articulación { $joint ->
        [prismatic] prismática
       *[revolute] de rotación
    } va en { $expected }.
error-variable_twice = En el carácter { $column }: { $name } aparece por segunda vez. Cada variable articular figura en la tabla una sola vez.
error-variable_of_other_row = En el carácter { $column }: la variable de esta fila no es { $name }, sino { $expected }. Si los accionamientos de dos articulaciones están acoplados, como en { $expected } + { $name }, escriba solo { $expected } y dele como valor la suma.
error-variable_numbering_mixed = En el carácter { $column }: { $name } está numerada por fila y otras por articulación. Numérelas de q1 a q{ $joints } en el orden de las articulaciones.

error-table_empty = La tabla no tiene filas; hace falta al menos una.
error-table_too_many_rows = La tabla tiene { $rows } filas; se leen como máximo { $limit }.
error-table_too_long = Las celdas suman { $length } caracteres; se leen como máximo { $limit }.
error-table_too_many_parameters = La tabla contiene más de { $limit } parámetros distintos.

error-parameter_missing = El parámetro { $name } no tiene valor.
error-parameter_unused = La tabla no contiene el parámetro { $name }.
error-parameter_not_finite = El valor de { $name } debe ser un número finito.
error-parameter_name_invalid = { $name } no es un nombre de parámetro. Un nombre es una palabra con índice, como L1.
error-parameter_given_twice = { $name } y { $other } son el mismo parámetro. Dé su valor una sola vez.
