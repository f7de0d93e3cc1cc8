# Ce que le correcteur dit d’un tableau : juste, faux, et ce qui le corrigerait.

## Une réponse juste, et la position de ses repères par rapport à la solution de référence

feedback-same_frames = Vos repères sont ceux de la solution de référence.
feedback-other_convention = Votre tableau est écrit dans la convention { $convention ->
    [modified] modifiée, la solution de référence dans la convention standard
   *[standard] standard, la solution de référence dans la convention modifiée
} ; tous deux décrivent le même robot.
feedback-axis_reversed = Votre z{ $frame }, l’axe de l’articulation { $joint }, est orienté à l’opposé de celui de la solution de référence. Les deux sens sont justes, et les signes de votre tableau s’accordent avec le vôtre.
feedback-end_axis_reversed = Votre z{ $frame } est orienté à l’opposé de celui de la solution de référence. Les deux sens sont justes.
feedback-x_turned = Votre x{ $frame } est tourné de { $degrees }° autour de z{ $frame } par rapport à la solution de référence. Votre tableau en tient compte.
feedback-origin_slid = L’origine de votre repère { $frame } est à un autre endroit de z{ $frame } que dans la solution de référence. Ici, tout endroit convient.
feedback-axis_moved = Votre z{ $frame } est porté par une autre droite, parallèle à celle de la solution de référence. Ici, seule sa direction compte.
feedback-frame_elsewhere = Votre repère { $frame } est placé autrement que dans la solution de référence. Vous pouviez le choisir librement.
feedback-variable_reversed = Votre q{ $joint } est comptée dans le sens opposé à celui de la solution de référence. Les deux sens sont justes.
feedback-variable_offset = Là où q{ $joint } de la solution de référence est nulle, la vôtre vaut { $offset }. Le zéro d’une variable articulaire se choisit librement.
feedback-rounded = Vos valeurs s’accordent avec la solution de référence à la tolérance près, mais pas exactement ; elles ont peut-être été arrondies.

## Une réponse fausse : l’ensemble

feedback-not_equivalent = Votre tableau ne décrit pas ce robot, quel que soit le choix des repères.
feedback-right_robot = Votre tableau décrit le bon robot, mais ne respecte pas tout ce que l’exercice demande.
feedback-not_accepted = Votre tableau ne respecte pas tout ce que l’exercice demande.
feedback-convention_not_asked = L’exercice demande la convention { $asked ->
    [modified] modifiée
   *[standard] standard
} ; votre tableau est dans la convention { $given ->
    [modified] modifiée
   *[standard] standard
}.
feedback-joint_count_wrong = { $given ->
    [0] Votre tableau n’a aucune articulation
    [1] Votre tableau a une articulation
   *[other] Votre tableau a { $given } articulations
} ; le robot en a { $asked }.
feedback-mirrored = Votre tableau décrit l’image du robot dans un miroir : toutes les longueurs et tous les angles conviennent, mais l’un d’eux est compté à l’envers. Vérifiez les signes par la règle de la main droite.
feedback-entries_imprecise = Aucune longueur ni aucun angle de votre tableau ne s’écarte de plus que ce qu’explique l’arrondi, mais les arrondis dépassent ensemble ce que l’exercice tolère. Écrivez les angles exactement, comme pi/2 ou 90°, et les longueurs avec plus de chiffres.
feedback-lengths_rounded = Plusieurs longueurs de votre tableau ont la bonne valeur, mais avec trop peu de chiffres. Écrivez-les avec plus de chiffres ; les autres points signalés ici sont d’autres erreurs.
feedback-base_axis_missed = Votre z0 n’est pas porté par l’axe de l’articulation 1.
feedback-base_origin_missed = L’origine de votre repère 0 n’est pas là où l’exercice la demande.
feedback-base_frame_missed = Votre repère 0 n’est pas celui que l’exercice impose.
feedback-tool_point_missed = L’origine de votre dernier repère n’est pas au point marqué.
feedback-tool_axis_missed = L’axe z de votre dernier repère n’est pas porté par l’axe de la dernière articulation.
feedback-tool_frame_missed = Votre dernier repère n’est pas celui que l’exercice impose.
feedback-zero_missed = Dans la configuration de la figure, toutes les variables articulaires devraient être nulles ; les vôtres ne le sont pas.
feedback-direction_missed = Les variables articulaires devraient croître dans le sens des flèches de la figure ; ce n’est pas le cas de toutes les vôtres.
feedback-whole_table = Une même erreur traverse tout votre tableau.
feedback-columns_throughout = Les colonnes a et α ne vont pas avec la convention que votre tableau déclare.
feedback-columns_in_disorder = Les colonnes de votre tableau sont dans un autre ordre.
feedback-angles_throughout = Les angles de votre tableau ne sont pas dans l’unité qu’il déclare.
feedback-lengths_throughout = Les longueurs de votre tableau ne sont pas dans l’unité qu’il déclare.
feedback-turns_throughout = Les angles articulaires de votre tableau sont partout comptés à l’envers.
feedback-twists_throughout = Les angles α de votre tableau ont partout le mauvais signe.
feedback-twists_out_of_place = Les angles α de votre tableau ne sont pas dans les lignes auxquelles ils appartiennent.
feedback-names_throughout = Une cote porte un mauvais nom dans votre tableau.
feedback-parameter_unknown = Le robot n’a pas de cote nommée { $name }. Ses cotes sont : { $known }.
feedback-names_asked = Les cotes du robot n’ont pas de valeur ici. Écrivez leurs noms : { $known }.

## Une réponse fausse : ses lignes

feedback-one_of_these = Une seule des remarques suivantes désigne l’erreur ; le tableau à lui seul ne montre pas laquelle.
feedback-row_wrong = La ligne { $row } n’est pas juste.
feedback-twist_wrong = Ligne { $row } : l’angle de torsion α, de z{ $before } à z{ $row }, n’est pas juste.
feedback-length_wrong = Ligne { $row } : la longueur a, distance de z{ $before } à z{ $row }, n’est pas juste.
feedback-offset_wrong = Ligne { $row } : le décalage d, distance de x{ $before } à x{ $row } le long de z, n’est pas juste.
feedback-angle_wrong = Ligne { $row } : l’angle θ, de x{ $before } à x{ $row } autour de z, n’est pas juste.
feedback-sign_wrong = Ligne { $row } : un signe est à l’envers. À vérifier : { $cells }.
feedback-joint_type_wrong = Ligne { $row } : le type de l’articulation n’est pas juste.
feedback-variable_zero_wrong = Ligne { $row } : dans la configuration de la figure, la variable articulaire n’est pas nulle.
feedback-variable_direction_wrong = Ligne { $row } : la variable articulaire croît dans le sens contraire de la flèche de la figure.
feedback-row_missing = Il manque une ligne { $after ->
    [0] avant la ligne 1
   *[other] après la ligne { $after }
}.
feedback-row_not_needed = La ligne { $row } est de trop.
feedback-rows_out_of_order = Les lignes { $row } et { $other } sont dans le mauvais ordre.

## Ce qui la rendrait juste

repair-convention = Lu dans la convention { $meant ->
    [modified] modifiée
   *[standard] standard
}, votre tableau serait juste ; vous avez déclaré la convention { $declared ->
    [modified] modifiée
   *[standard] standard
}.
repair-angles_in_degrees = Les angles sont en degrés, mais le tableau déclare des radians.
repair-angles_in_radians = Les angles sont en radians, mais le tableau déclare des degrés.
repair-length_unit = Les longueurs sont dans une autre unité que celle déclarée : des millimètres au lieu de mètres, par exemple.
repair-columns_late = Les colonnes a et α sont une ligne trop bas, comme dans l’autre convention. À quel segment chaque ligne appartient-elle ?
repair-columns_early = Les colonnes a et α sont une ligne trop haut, comme dans l’autre convention. À quel segment chaque ligne appartient-elle ?
repair-twists_late = La colonne α est une ligne trop bas ; a est à sa place. Dans une même ligne, a et α appartiennent au même segment.
repair-twists_early = La colonne α est une ligne trop haut ; a est à sa place. Dans une même ligne, a et α appartiennent au même segment.
repair-columns_exchanged = Les colonnes { $one } et { $other } sont interverties. Comparez l’ordre des colonnes avec celui de votre cours.
repair-columns_reordered = Ce qui est sous α va sous { $alpha }, ce qui est sous a va sous { $a } et ce qui est sous d va sous { $d }. Comparez l’ordre des colonnes avec celui de votre cours.
repair-parameter_misnamed = { $name } n’est pas une cote de ce robot. De laquelle de la figure s’agit-il ?
repair-parameters_swapped = { $name } et { $other } sont interverties. Comparez-les à la figure.
repair-alpha_sign = Ligne { $row } : α a le mauvais signe. Faites tourner z{ $before } jusqu’à z{ $row } autour de x, selon la règle de la main droite.
repair-alpha_value = Ligne { $row } : α a une valeur fausse. Regardez à nouveau comment z{ $before } et z{ $row } sont placés l’un par rapport à l’autre.
repair-turns_all_reversed = Tous les angles articulaires sont comptés à l’envers. Tournez autour de z avec la main droite, non la gauche.
repair-twists_all_reversed = Tous les α ont le mauvais signe. Faites tourner un axe z jusqu’au suivant autour de x avec la main droite, non la gauche.
repair-a_sign = Ligne { $row } : a a le mauvais signe. Elle se compte dans le sens de x.
repair-d_sign = Ligne { $row } : d a le mauvais signe. Il se compte dans le sens de z.
repair-twists_swapped = Lignes { $row } et { $other } : les valeurs de α sont interverties.
repair-a_d_swapped = Ligne { $row } : a et d sont intervertis. a se mesure le long de x, d le long de z.
repair-a_value = Ligne { $row } : a a une valeur fausse. Mesurez sur la perpendiculaire commune à z{ $before } et z{ $row }.
repair-a_missing = Ligne { $row } : a ne devrait pas être nulle, car z{ $before } et z{ $row } ne se coupent pas.
repair-a_not_zero = Ligne { $row } : a devrait être nulle, car z{ $before } et z{ $row } se coupent ou sont confondus.
repair-d_value = Ligne { $row } : d a une valeur fausse. Mesurez le long de z, de x{ $before } à x{ $row }.
repair-d_missing = Ligne { $row } : le décalage d le long de z, de x{ $before } à x{ $row }, a été oublié.
repair-d_not_zero = Ligne { $row } : d devrait être nul, car x{ $before } et x{ $row } rencontrent z au même point.
repair-cell_length_unit = Ligne { $row } : une longueur est dans une autre unité que les autres.
repair-cell_parameter = Ligne { $row } : c’est une autre cote de la figure qui a sa place ici.
repair-cell_in_degrees = Ligne { $row } : un angle est en degrés, mais le tableau déclare des radians.
repair-cell_in_radians = Ligne { $row } : un angle est en radians, mais le tableau déclare des degrés.
repair-theta_value = Ligne { $row } : l’angle constant θ a une valeur fausse. Faites tourner x{ $before } jusqu’à x{ $row } autour de z.
repair-theta_offset = Ligne { $row } : il faut ajouter à la variable une autre constante dans θ, pour que la variable soit nulle dans la configuration de la figure.
repair-d_offset = Ligne { $row } : il faut ajouter à la variable une autre constante dans d, pour que la variable soit nulle dans la configuration de la figure.
repair-variable_sign = Ligne { $row } : la variable articulaire est comptée à l’envers. Donnez-lui le signe opposé.
repair-joint_type = Ligne { $row } : cette articulation { $joint_type ->
    [prismatic] glisse ; sa variable se place sous d
   *[revolute] tourne ; sa variable se place sous θ
}.
repair-joint_fixed = Ligne { $row } : cette articulation bouge ; sa variable manque.
repair-joint_moving = Ligne { $row } : rien ne bouge ici ; la ligne ne contient que des constantes.
repair-rows_swapped = Les lignes { $row } et { $other } sont interverties.
repair-fixed_row_missing = Il manque une dernière ligne sans variable : celle qui mène de la dernière articulation au point marqué ou au dernier repère imposé.
repair-row_missing = Il manque une ligne { $after ->
    [0] avant la ligne 1
   *[other] après la ligne { $after }
}.
repair-row_extra = La ligne { $row } est de trop.

## Refusé

error-tables_without_value = Aucune valeur des paramètres n’a été trouvée pour laquelle chaque cellule des deux tableaux ait une valeur. Vérifiez les racines, les quotients et les fonctions réciproques.

feedback-frame_wrong = Le repère { $frame } enfreint une règle.
feedback-frame_missing = Le repère { $frame } n’a pas été placé.
feedback-frame_z_not_along_axis = Repère { $frame } : { rule-z_not_along_axis }
feedback-frame_origin_not_on_axis = Repère { $frame } : { rule-origin_not_on_axis }
feedback-frame_origin_not_on_common_normal = Repère { $frame } : { rule-origin_not_on_common_normal }
feedback-frame_origin_not_at_intersection = Repère { $frame } : { rule-origin_not_at_intersection }
feedback-frame_x_not_across_z = Repère { $frame } : { rule-x_not_across_z }
feedback-frame_x_not_along_common_normal = Repère { $frame } : { rule-x_not_along_common_normal }
feedback-frame_x_not_across_both_axes = Repère { $frame } : { rule-x_not_across_both_axes }
feedback-frame_first_x_misses_axis = Repère { $frame } : { rule-first_x_misses_axis }
feedback-frame_last_x_misses_axis = Repère { $frame } : { rule-last_x_misses_axis }
feedback-frames_other_convention = Ces repères suivent les règles de l’autre convention.
feedback-frames_not_as_asked = Les repères suivent les règles, mais ne sont pas placés comme l’exercice le demande.
feedback-frames_right = Les repères sont justes.
feedback-repairs_one_cell = Plusieurs modifications suffiraient chacune à rendre le tableau juste ; toutes concernent la cellule { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
} de la ligne { $row }.
feedback-repairs_one_row = Plusieurs modifications suffiraient chacune à rendre le tableau juste ; toutes concernent la ligne { $row }.
feedback-repairs_one_column = Plusieurs modifications suffiraient chacune à rendre le tableau juste ; toutes concernent la colonne { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
}.
feedback-repairs_one_kind = { $count } modifications suffiraient chacune à rendre le tableau juste ; toutes sont du même type.
