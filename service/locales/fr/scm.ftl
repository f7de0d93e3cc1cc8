# La méthode SCM : chaînes de lignes [X Y Z A B C].

error-scm_chain_empty = La chaîne n’a aucune articulation. Il faut au moins une ligne.
error-scm_too_many_joints = La chaîne a { $joints } articulations ; { $limit } au plus sont lues.
error-scm_chain_too_long = Les éléments comptent ensemble { $length } caractères ; { $limit } au plus sont lus.
error-scm_no_variable = La ligne { $joint } ne contient aucune variable articulaire. Écrivez q{ $joint } dans l’élément qui bouge.
error-scm_two_variables = La ligne { $joint } contient sa variable dans { $first } et dans { $second }. Une ligne en a exactement une.
error-scm_variable_of_other_row = { $name } n’est pas la variable de la ligne { $joint } ; c’est q{ $joint }.
error-scm_variable_form = La variable doit apparaître sous la forme +q{ $joint } ou −q{ $joint }, avec au plus une constante ajoutée.
error-scm_variable_outside_joints = { $name } est une variable articulaire ; seules les lignes des articulations peuvent en contenir une.
error-scm_parameter_two_kinds = { $name } mesure une longueur dans un élément et un angle dans un autre. Utilisez deux noms.
error-scm_prismatic_turns = L’articulation { $joint } est prismatique : sa ligne ne doit pas faire tourner le repère. Placez les rotations constantes dans la transformation finale.
error-scm_prismatic_second_length = L’articulation { $joint } est prismatique : sa ligne contient la variable et aucune autre longueur. Placez celle-ci dans une ligne précédente ou suivante.
error-scm_revolute_offset = L’articulation { $joint } est rotoïde : son angle ne doit contenir aucun décalage. Placez les rotations constantes dans la transformation finale.
error-scm_revolute_second_turn = L’articulation { $joint } tourne autour d’un seul axe. Placez les rotations constantes dans la transformation finale.
error-scm_limits_reversed = Articulation { $joint } : les limites sont [inférieure, supérieure], toutes deux finies, l’inférieure ne dépassant pas la supérieure.
error-chain_or_robot = Donnez exactement l’un des deux : chain ou robot.
error-scm_six_entries = Il faut six entrées : la liste [X, Y, Z, A, B, C], ou un objet avec certaines des clés x, y, z, a, b, c ; ce qui manque vaut 0.
error-matrix_not_rotation = La partie rotation de cette matrice n’est pas une rotation : ses colonnes doivent être des vecteurs unitaires perpendiculaires, en trièdre direct, pour toutes les valeurs des variables articulaires. Sinon elle n’a pas de vitesse angulaire.
error-variable_name_invalid = { $name } ne peut pas nommer la variable articulaire { $joint } : un nom est un mot avec un indice, comme a1, et chaque variable a le sien.
error-no_derivative = Une variable articulaire apparaît dans une fonction qui n’est pas dérivée ici : n’en écrivez que des sinus et des cosinus.
