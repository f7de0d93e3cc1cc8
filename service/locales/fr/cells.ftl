# Pourquoi une cellule, un tableau ou un paramètre est refusé.

error-cell_empty = Cette cellule est vide. Si la valeur est nulle, écrivez 0.
error-cell_dash = Cette cellule ne contient aucune valeur. Si la valeur est nulle, écrivez 0.
error-cell_not_a_value =
    Une cellule contient un nombre ou une expression sous forme de texte, et non { $kind ->
        [list] une liste
        [dict] un objet
       *[other] { $kind }
    }.
error-cell_too_long = Cette cellule compte { $length } caractères ; { $limit } au plus sont lus.
error-cell_too_deep = Cette cellule dépasse { $limit } niveaux d’imbrication.
error-cell_too_many_symbols = Cette cellule contient plus de { $limit } noms différents.

error-character_not_allowed = Au caractère { $column } : { $character } n’a pas de sens dans une cellule.
error-character_invisible = Au caractère { $column } : il y a un caractère invisible ou de contrôle ({ $character }). Supprimez-le.
error-character_lookalike = Au caractère { $column } : { $character } ressemble seulement à la lettre latine { $latin }. Tapez { $latin }.
error-character_full_width = Au caractère { $column } : { $character } est un caractère pleine chasse. Tapez { $latin }.
error-dollar_misplaced = Au caractère { $column } : $ ne peut qu’encadrer la cellule entière.
error-command_unknown = Au caractère { $column } : la commande \{ $command } n’est pas comprise.
error-script_misplaced = Au caractère { $column } : { $character } ne suit rien à quoi il puisse se rattacher.

error-number_malformed = Au caractère { $column } : { $text } n’est pas un nombre décimal. Écrivez des chiffres et un seul point, sans séparateurs.
error-number_too_long = Au caractère { $column } : un nombre a au plus { $limit } chiffres.
error-number_out_of_range =
    { $size ->
        [small] Au caractère { $column } : ce nombre est trop proche de 0 pour être lu. Écrivez 0.
       *[large] Au caractère { $column } : la valeur absolue d’un nombre est au plus { $largest }.
    }
error-cell_not_finite = Une cellule ne contient que des nombres finis ; NaN et l’infini sont refusés.
error-decimal_comma = Au caractère { $column } : écrivez un point décimal au lieu de la virgule : { $suggestion }.
error-minutes_in_cell = Au caractère { $column } : les minutes et secondes d’arc ne sont pas lues. En décimales, { $text } s’écrit { $suggestion }.
error-about_in_cell = Au caractère { $column } : une cellule donne la valeur elle-même, sans { $character }. Écrivez { $suggestion }.

error-names_run_together = Au caractère { $column } : { $text } est accolé à ce qui suit. Écrivez le produit avec *.
error-name_malformed = Au caractère { $column } : le tiret bas ne se place qu’entre une lettre et son indice, comme dans L_1.
error-name_too_long = Au caractère { $column } : un nom a au plus { $limit } caractères.
error-name_is_not_a_number = Au caractère { $column } : { $name } n’est pas une valeur. Une cellule ne contient que des nombres finis.
error-unit_in_cell = Au caractère { $column } : les unités ne s’écrivent pas dans les cellules. Si l’unité demandée est { $name }, écrivez { $suggestion } ; sinon, convertissez d’abord.
error-function_unknown = Au caractère { $column } : { $name } n’est pas une fonction. Les fonctions sont { $functions }. Un produit s’écrit { $name }*(…).
error-function_without_parentheses =
    Au caractère { $column } : écrivez l’argument de { $name } entre parenthèses : { $name }({ $name ->
        [atan2] y, x
        [arctan2] y, x
       *[other] x
    }).
error-function_arity =
    { $expected ->
        [1] Au caractère { $column } : { $name } prend un argument, et non { $given }.
       *[other] Au caractère { $column } : { $name } prend { $expected } arguments, et non { $given }.
    }

error-value_missing = Au caractère { $column } : il manque une valeur avant { $symbol }.
error-cell_incomplete = Au caractère { $column } : la cellule s’arrête là où une valeur devrait suivre.
error-symbol_misplaced = Au caractère { $column } : { $symbol } ne peut pas se trouver ici.
error-comma_misplaced = Au caractère { $column } : une virgule ne sépare que les deux arguments de atan2.
error-parenthesis_not_closed = Au caractère { $column } : cette parenthèse n’est jamais fermée.
error-parenthesis_not_opened = Au caractère { $column } : cette parenthèse ne ferme rien.
error-number_after_value = Au caractère { $column } : un nombre ne peut pas suivre directement une valeur. Manque-t-il un opérateur ?
error-division_ambiguous = Au caractère { $column } : on ne sait pas par quoi diviser. Écrivez a/(b*c) ou (a/b)*c.
error-exponent_ambiguous = Au caractère { $column } : { $text } peut signifier { $number } ou { $difference }. Écrivez l’un des deux.

error-exponent_not_constant = Au caractère { $column } : un exposant est un nombre rationnel.
error-exponent_out_of_range = Au caractère { $column } : un exposant vaut au plus { $limit } en valeur absolue, son dénominateur aussi.
error-division_by_zero = Au caractère { $column } : division par zéro.
error-value_not_real = Cette cellule n’a pas de valeur réelle finie.
error-degree_of_angle = Au caractère { $column } : le signe degré suit un nombre ; ceci est déjà un angle.
error-degree_in_length = Au caractère { $column } : une longueur ne s’exprime pas en degrés.
error-angle_in_length = Au caractère { $column } : { $name } donne un angle en degrés, qui n’est pas une longueur.
error-angle_product = Au caractère { $column } : deux angles sont multipliés. Un angle ne se multiplie que par des nombres.
error-angle_in_denominator = Au caractère { $column } : division par un angle. On ne divise ici que par des nombres.
error-angle_power = Au caractère { $column } : un angle ne s’élève pas à une puissance.
error-parameter_two_kinds =
    Au caractère { $column } : { $name } désigne ici { $kind ->
        [angle] un angle
       *[length] une longueur
    } et ailleurs { $other ->
        [angle] un angle
       *[length] une longueur
    }. Utilisez deux noms.

error-variable_without_number = Au caractère { $column } : { $name } doit porter le numéro de son articulation, comme { $suggestion }.
error-variable_misspelled = Au caractère { $column } : { $name } n’est pas une variable articulaire. Écrivez { $suggestion } ou θ avec le numéro de l’articulation.
error-variable_called = Au caractère { $column } : { $name } est une variable articulaire ; rien ne la suit entre parenthèses. Écrivez le décalage sous forme de somme : { $name } + ….
error-variable_scaled = Au caractère { $column } : { $name } est multipliée par { $factor }. Une variable articulaire s’écrit +{ $name } ou -{ $name } ; sinon elle ne serait plus le mouvement de son articulation.
error-variable_in_product = Au caractère { $column } : { $name } est multipliée par une autre grandeur. Une variable articulaire s’écrit +{ $name } ou -{ $name }, plus un décalage.
error-variable_in_denominator = Au caractère { $column } : { $name } est au dénominateur. Une variable articulaire s’écrit +{ $name } ou -{ $name }, plus un décalage.
error-variable_in_power = Au caractère { $column } : { $name } est élevée à une puissance. Une variable articulaire s’écrit +{ $name } ou -{ $name }, plus un décalage.
error-variable_in_function = Au caractère { $column } : { $name } est à l’intérieur d’une fonction. La cellule contient la variable articulaire elle-même ; les sinus et cosinus découlent du tableau.
error-variable_in_constant_cell = Au caractère { $column } : { $name } se trouve sous { $cell }. La longueur et la torsion d’un segment ne varient jamais ; une variable articulaire se place sous θ (rotoïde) ou d (prismatique).
error-variable_in_fixed_row = Au caractère { $column } : { $name } se trouve dans une ligne déclarée fixe. Une ligne fixe n’a pas de variable articulaire.
error-variable_in_wrong_cell =
    Au caractère { $column } : { $name } se trouve sous { $cell }, mais la variable d’une articulation { $joint ->
        [prismatic] prismatique
       *[revolute] rotoïde
    } se place sous { $expected }.
error-variable_twice = Au caractère { $column } : { $name } apparaît une deuxième fois. Chaque variable articulaire figure une seule fois dans le tableau.
error-variable_of_other_row = Au caractère { $column } : { $name } n’est pas la variable de cette ligne ; c’est { $expected }. Si les entraînements de deux articulations sont couplés, comme dans { $expected } + { $name }, écrivez seulement { $expected } et donnez-lui la somme pour valeur.
error-variable_numbering_mixed = Au caractère { $column } : { $name } est numérotée par ligne, d’autres par articulation. Numérotez-les de q1 à q{ $joints } dans l’ordre des articulations.

error-table_empty = Le tableau n’a aucune ligne ; il en faut au moins une.
error-table_too_many_rows = Le tableau a { $rows } lignes ; { $limit } au plus sont lues.
error-table_too_long = Les cellules comptent ensemble { $length } caractères ; { $limit } au plus sont lus.
error-table_too_many_parameters = Le tableau contient plus de { $limit } paramètres différents.

error-parameter_missing = Le paramètre { $name } n’a pas de valeur.
error-parameter_unused = Le tableau ne contient pas de paramètre { $name }.
error-parameter_not_finite = La valeur de { $name } doit être un nombre fini.
error-parameter_name_invalid = { $name } n’est pas un nom de paramètre. Un nom est un mot avec un indice, comme L1.
error-parameter_given_twice = { $name } et { $other } sont le même paramètre. Donnez sa valeur une seule fois.
