# Por que uma célula, uma tabela ou um parâmetro é recusado.

error-cell_empty = Esta célula está vazia. Se o valor for zero, escreva 0.
error-cell_dash = Esta célula não contém nenhum valor. Se o valor for zero, escreva 0.
error-cell_not_a_value =
    Uma célula contém um número ou uma expressão em texto, não { $kind ->
        [list] uma lista
        [dict] um objeto
       *[other] { $kind }
    }.
error-cell_too_long = Esta célula tem { $length } caracteres; são lidos no máximo { $limit }.
error-cell_too_deep = Esta célula ultrapassa { $limit } níveis de aninhamento.
error-cell_too_many_symbols = Esta célula contém mais de { $limit } nomes diferentes.

error-character_not_allowed = No carácter { $column }: { $character } não tem significado numa célula.
error-character_invisible = No carácter { $column }: há um carácter invisível ou de controlo ({ $character }). Apague-o.
error-character_lookalike = No carácter { $column }: { $character } apenas se parece com a letra latina { $latin }. Escreva { $latin }.
error-character_full_width = No carácter { $column }: { $character } é um carácter de largura dupla. Escreva { $latin }.
error-dollar_misplaced = No carácter { $column }: $ só pode delimitar a célula inteira.
error-command_unknown = No carácter { $column }: o comando \{ $command } não é reconhecido.
error-script_misplaced = No carácter { $column }: { $character } não segue nada a que possa pertencer.

error-number_malformed = No carácter { $column }: { $text } não é um número decimal. Escreva algarismos e um só ponto, sem separadores.
error-number_too_long = No carácter { $column }: um número pode ter no máximo { $limit } algarismos.
error-number_out_of_range =
    { $size ->
        [small] No carácter { $column }: este número está demasiado próximo de 0 para ser lido. Escreva 0.
       *[large] No carácter { $column }: o módulo de um número é no máximo { $largest }.
    }
error-cell_not_finite = Uma célula contém apenas números finitos; NaN e infinito são recusados.
error-decimal_comma = No carácter { $column }: escreva ponto decimal em vez de vírgula: { $suggestion }.
error-minutes_in_cell = No carácter { $column }: não se leem minutos nem segundos de arco. Em decimais, { $text } é { $suggestion }.
error-about_in_cell = No carácter { $column }: uma célula diz qual é o valor, sem { $character }. Escreva { $suggestion }.

error-names_run_together = No carácter { $column }: { $text } está colado ao que vem a seguir. Escreva o produto com *.
error-name_malformed = No carácter { $column }: o sublinhado fica apenas entre a letra e o índice, como em L_1.
error-name_too_long = No carácter { $column }: um nome pode ter no máximo { $limit } caracteres.
error-name_is_not_a_number = No carácter { $column }: { $name } não é um valor. Uma célula contém apenas números finitos.
error-unit_in_cell = No carácter { $column }: unidades não se escrevem nas células. Se a unidade pedida for { $name }, escreva { $suggestion }; se não, converta primeiro.
error-function_unknown = No carácter { $column }: { $name } não é uma função. As funções são { $functions }. Um produto escreve-se { $name }*(…).
error-function_without_parentheses =
    No carácter { $column }: escreva o argumento de { $name } entre parênteses: { $name }({ $name ->
        [atan2] y, x
        [arctan2] y, x
       *[other] x
    }).
error-function_arity =
    { $expected ->
        [one] No carácter { $column }: { $name } recebe um argumento, não { $given }.
       *[other] No carácter { $column }: { $name } recebe { $expected } argumentos, não { $given }.
    }

error-value_missing = No carácter { $column }: falta um valor antes de { $symbol }.
error-cell_incomplete = No carácter { $column }: a célula termina onde deveria vir um valor.
error-symbol_misplaced = No carácter { $column }: { $symbol } não pode estar aqui.
error-comma_misplaced = No carácter { $column }: a vírgula só separa os dois argumentos de atan2.
error-parenthesis_not_closed = No carácter { $column }: este parêntese nunca é fechado.
error-parenthesis_not_opened = No carácter { $column }: este parêntese não fecha nada.
error-number_after_value = No carácter { $column }: um número não pode vir logo depois de um valor. Falta um operador?
error-division_ambiguous = No carácter { $column }: não está claro por que se divide. Escreva a/(b*c) ou (a/b)*c.
error-exponent_ambiguous = No carácter { $column }: { $text } pode significar { $number } ou { $difference }. Escreva um dos dois.

error-exponent_not_constant = No carácter { $column }: um expoente é um número racional.
error-exponent_out_of_range = No carácter { $column }: um expoente tem módulo de no máximo { $limit }, e o seu denominador também.
error-division_by_zero = No carácter { $column }: aqui divide-se por zero.
error-value_not_real = Esta célula não tem valor real finito.
error-degree_of_angle = No carácter { $column }: o sinal de grau segue um número; isto já é um ângulo.
error-degree_in_length = No carácter { $column }: um comprimento não se exprime em graus.
error-angle_in_length = No carácter { $column }: { $name } dá um ângulo em graus, que não é um comprimento.
error-angle_product = No carácter { $column }: dois ângulos são multiplicados. Um ângulo só se multiplica por números.
error-angle_in_denominator = No carácter { $column }: divide-se por um ângulo. Aqui só se divide por números.
error-angle_power = No carácter { $column }: um ângulo não se eleva a uma potência.
error-parameter_two_kinds =
    No carácter { $column }: { $name } representa aqui { $kind ->
        [angle] um ângulo
       *[length] um comprimento
    } e noutro lugar { $other ->
        [angle] um ângulo
       *[length] um comprimento
    }. Use dois nomes.

error-variable_without_number = No carácter { $column }: { $name } precisa do número da sua junta, como em { $suggestion }.
error-variable_misspelled = No carácter { $column }: { $name } não é uma variável de junta. Escreva { $suggestion } ou θ com o número da junta.
error-variable_called = No carácter { $column }: { $name } é uma variável de junta e não leva nada entre parênteses. Escreva a constante como parcela: { $name } + ….
error-variable_scaled = No carácter { $column }: { $name } está multiplicada por { $factor }. Uma variável de junta entra como +{ $name } ou -{ $name }; de outro modo não seria o movimento da sua junta.
error-variable_in_product = No carácter { $column }: { $name } está multiplicada por outra grandeza. Uma variável de junta entra como +{ $name } ou -{ $name } mais uma constante.
error-variable_in_denominator = No carácter { $column }: { $name } está num denominador. Uma variável de junta entra como +{ $name } ou -{ $name } mais uma constante.
error-variable_in_power = No carácter { $column }: { $name } está elevada a uma potência. Uma variável de junta entra como +{ $name } ou -{ $name } mais uma constante.
error-variable_in_function = No carácter { $column }: { $name } está dentro de uma função. A célula contém a própria variável de junta; senos e cossenos resultam da tabela.
error-variable_in_constant_cell = No carácter { $column }: { $name } está em { $cell }. Comprimento e torção de um elo nunca variam; uma variável de junta fica em θ (rotativa) ou em d (prismática).
error-variable_in_fixed_row = No carácter { $column }: { $name } está numa linha declarada fixa. Uma linha fixa não tem variável de junta.
error-variable_in_wrong_cell =
    No carácter { $column }: { $name } está em { $cell }, mas a variável de uma junta { $joint ->
        [prismatic] prismática
       *[revolute] rotativa
    } fica em { $expected }.
error-variable_twice = No carácter { $column }: { $name } aparece pela segunda vez. Cada variável de junta aparece na tabela uma só vez.
error-variable_of_other_row = No carácter { $column }: a variável desta linha não é { $name }, mas sim { $expected }. Se os acionamentos de duas juntas estiverem acoplados, como em { $expected } + { $name }, escreva só { $expected } e dê-lhe a soma como valor.
error-variable_numbering_mixed = No carácter { $column }: { $name } está numerada por linha e outras por junta. Numere-as de q1 a q{ $joints }, na ordem das juntas.

error-table_empty = A tabela não tem linhas; é preciso pelo menos uma.
error-table_too_many_rows = A tabela tem { $rows } linhas; são lidas no máximo { $limit }.
error-table_too_long = As células têm juntas { $length } caracteres; são lidos no máximo { $limit }.
error-table_too_many_parameters = A tabela contém mais de { $limit } parâmetros diferentes.

error-parameter_missing = O parâmetro { $name } não tem valor.
error-parameter_unused = A tabela não contém o parâmetro { $name }.
error-parameter_not_finite = O valor de { $name } deve ser um número finito.
error-parameter_name_invalid = { $name } não é nome de parâmetro. Um nome é uma palavra com índice, como L1.
error-parameter_given_twice = { $name } e { $other } são o mesmo parâmetro. Dê o seu valor uma só vez.
