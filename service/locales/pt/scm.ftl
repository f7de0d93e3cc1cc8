# O método SCM: cadeias de linhas [X Y Z A B C].

error-scm_chain_empty = A cadeia não tem juntas. É preciso pelo menos uma linha.
error-scm_too_many_joints = A cadeia tem { $joints } juntas; são lidas no máximo { $limit }.
error-scm_chain_too_long = Os elementos têm juntos { $length } caracteres; são lidos no máximo { $limit }.
error-scm_no_variable = A linha { $joint } não contém variável de junta. Escreva q{ $joint } no elemento que se move.
error-scm_two_variables = A linha { $joint } contém a sua variável em { $first } e em { $second }. Uma linha tem exatamente uma.
error-scm_variable_of_other_row = { $name } não é a variável da linha { $joint }; a variável é q{ $joint }.
error-scm_variable_form = A variável deve aparecer como +q{ $joint } ou −q{ $joint }, com uma constante somada no máximo.
error-scm_variable_outside_joints = { $name } é uma variável de junta; só as linhas das juntas podem conter uma.
error-scm_parameter_two_kinds = { $name } mede um comprimento num elemento e um ângulo noutro. Use dois nomes.
error-scm_prismatic_turns = A junta { $joint } é prismática: a sua linha não pode rodar o referencial. Ponha as rotações constantes na transformação final.
error-scm_prismatic_second_length = A junta { $joint } é prismática: a sua linha contém a variável e nenhum outro comprimento. Ponha este comprimento numa linha anterior ou posterior.
error-scm_revolute_offset = A junta { $joint } é rotativa: o seu ângulo não admite uma constante somada. Ponha as rotações constantes na transformação final.
error-scm_revolute_second_turn = A junta { $joint } roda em torno de um único eixo. Ponha as rotações constantes na transformação final.
error-scm_limits_reversed = Junta { $joint }: os limites são [inferior, superior], ambos finitos, e o inferior não pode exceder o superior.
error-chain_or_robot = Dê exatamente um dos dois: chain ou robot.
error-scm_six_entries = São necessárias seis entradas: a lista [X, Y, Z, A, B, C] ou um objeto com algumas de x, y, z, a, b, c; o que faltar vale 0.
error-matrix_not_rotation = A parte de rotação desta matriz não é uma rotação: as colunas devem ser vetores unitários perpendiculares, num triedro direito, para todos os valores das variáveis de junta. Só então ela tem velocidade angular.
error-variable_name_invalid = { $name } não pode ser o nome da variável de junta { $joint }: um nome é uma palavra com um índice, como a1, e cada variável tem o seu.
error-no_derivative = Uma variável de junta aparece dentro de uma função que aqui não é derivada: escreva senos e cossenos dela.
