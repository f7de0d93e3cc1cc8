### Genres de question : ce qui est demandé, ce qui est dit des réponses.

field-matrix = Matrice
field-component_order = Ordre des composantes du quaternion
field-quaternion = Quaternion
field-axis = Axe de rotation
field-angle = Angle de rotation
field-angles = Triplets d’angles
field-middle = En cas de blocage de cardan : l’angle du milieu
field-combination = En cas de blocage de cardan : quelle combinaison du premier et du dernier angle est fixée
field-value = Sa valeur
field-matrix_claim = Cette matrice
field-pose_claim = Cette pose
field-position_claim = Cette position
field-pose = Pose
option-wxyz = w, x, y, z : le scalaire d’abord
option-xyzw = x, y, z, w : le scalaire à la fin
option-sum = la somme : premier + dernier
option-difference = la différence : premier − dernier
option-rotation = est une rotation
option-unit_columns = n’est pas une rotation : une colonne n’est pas de longueur 1
option-perpendicular_columns = n’est pas une rotation : deux colonnes ne sont pas perpendiculaires
option-right_handed = n’est pas une rotation : ses colonnes forment un trièdre indirect (déterminant −1)
given-rotation = L’orientation, sous forme de matrice de rotation
given-quaternion = L’orientation, sous forme de quaternion unitaire
given-axis_angle = L’orientation, par son axe et son angle
given-angles = L’orientation, par des angles
given-matrix = La matrice
given-frame-pose = Pose du repère { $end } dans le repère { $start }

task-orientation =
    { $given ->
        [angles] Un repère est tourné de trois angles autour des axes { $turning ->
            [fixed] fixes
           *[current] courants
        } { $axes }, dans cet ordre.
       *[other] L’orientation d’un repère est donnée.
    } Écrivez-la dans les notations ci-dessous.{ $ask ->
        [every] {" "}Pour les angles autour des axes { $asked_turning ->
            [fixed] fixes
           *[current] courants
        } { $asked_axes }, tous les triplets sont demandés : les deux ou, en cas de blocage de cardan, l’angle du milieu et ce qui est fixé des deux autres.
        [one] {" "}Pour les angles autour des axes { $asked_turning ->
            [fixed] fixes
           *[current] courants
        } { $asked_axes }, un triplet suffit.
       *[none] {""}
    }
task-rotation-check = Cette matrice est-elle une rotation ? Sinon, dites quelle propriété des rotations n’est pas satisfaite.
task-frame-chain = Les poses ci-dessous sont connues. Écrivez la pose du repère { $end } dans le repère { $start } sous forme de matrice 4×4, longueurs en { unit-word }.
feedback-orientation_right = Toutes les notations décrivent l’orientation donnée.
feedback-orientation_wrong =
    { $notation ->
        [matrix] La matrice n’est pas celle de cette orientation.
        [quaternion] Le quaternion n’est pas celui de cette orientation.
        [axis_angle] L’axe et l’angle ne sont pas ceux de cette orientation.
        [angles] Les angles ne sont pas ceux de cette orientation.
       *[other] Les angles ne sont pas tous justes, ou il en manque.
    }
feedback-orientation_missing =
    { $notation ->
        [matrix] Il manque la matrice.
        [quaternion] Il manque le quaternion.
        [axis_angle] Il manque l’axe et l’angle.
       *[other] Il manque les angles.
    }

feedback-rotation_transposed = C’est la rotation inverse : lignes et colonnes, ou le sens de rotation, ont été échangés.
feedback-rotation_order_reversed = Les rotations ont été multipliées dans l’ordre inverse : axes fixes et axes courants ont été confondus.
feedback-rotation_degrees = Un angle en degrés a été pris pour des radians, ou l’inverse.
feedback-rotation_handedness = Tout tourne dans l’autre sens : c’est la règle de la main gauche qui a été suivie.
feedback-rotation_half_angle = Ce quaternion tourne deux fois trop : il faut le sinus et le cosinus du demi-angle.
feedback-rotation_component_order = Dans l’autre ordre des composantes, ce quaternion serait juste.
feedback-rotation_not_unit = Le quaternion n’est pas de norme 1.
feedback-rotation_no_axis = L’axe est de longueur nulle.
feedback-rotation_solution_missing = Il y a un second triplet de même orientation.
feedback-rotation_solution_twice = Vos triplets ne diffèrent que de tours complets : c’est le même. Il y en a un autre.
feedback-rotation_family_missing = Il y a blocage de cardan : les triplets sont en nombre infini. Dites quelle combinaison du premier et du dernier angle est fixée.
feedback-rotation_combination = C’est l’autre combinaison qui est fixée : la différence au lieu de la somme, ou la somme au lieu de la différence.
feedback-rotation_not_locked = Il n’y a pas de blocage de cardan : deux triplets exactement ont cette orientation.
feedback-rotation_quadrant = Un angle est dans le mauvais quadrant, à un demi-tour : prenez atan2 au lieu de atan.
feedback-rotation_angle_sign = Un angle, ou une combinaison d’angles, a le mauvais signe.
feedback-rotation_rounded = Les éléments sont trop arrondis : calculez avec plus de décimales.
feedback-rotation_unit_columns = Ce n’est pas une rotation : une colonne n’est pas de longueur 1.
feedback-rotation_perpendicular_columns = Ce n’est pas une rotation : deux colonnes ne sont pas perpendiculaires.
feedback-rotation_right_handed = Ce n’est pas une rotation mais une réflexion : son déterminant est −1.
feedback-claim_right = C’est vrai de cette matrice.
feedback-claim_not_rotation = Ce n’est pas une rotation : vérifiez les longueurs des colonnes, les angles entre elles et le déterminant.
feedback-claim_rotation = C’est bien une rotation : colonnes de longueur 1, perpendiculaires, déterminant +1.
feedback-claim_other_property = Ce n’est pas une rotation, mais cette propriété est satisfaite ; c’en est une autre qui ne l’est pas.
feedback-chain_right = La pose est bien celle que donne la chaîne de repères.
feedback-chain_wrong = Ce n’est pas la pose qui découle des poses connues.
feedback-chain_rotation_right = Sa rotation est juste.
feedback-chain_position_right = Sa position est juste.
feedback-chain_inverted = C’est l’inverse : la pose du premier repère dans le dernier.
feedback-chain_not_inverted = Une pose connue a été prise telle quelle alors qu’il faut d’abord l’inverser.
feedback-chain_inverse_without_transpose = L’inverse d’une pose a été formée avec R ; il faut Rᵀ : (Rᵀ, −Rᵀp).
feedback-chain_inverse_position = La position d’une inverse est −Rᵀp, et non −p.
feedback-chain_order_reversed = Les facteurs ont été multipliés dans l’ordre inverse.
feedback-chain_transposed = La rotation est transposée.
feedback-chain_not_rigid = Ce n’est pas un déplacement rigide : ses colonnes ne sont pas unitaires et perpendiculaires, ou elles forment un trièdre indirect (déterminant −1), ou sa dernière ligne n’est pas 0 0 0 1.
error-euler_axes_unknown = { $axes } n’est pas une suite d’axes : trois parmi X, Y, Z, les voisins différents.
error-component_order_missing = Dites où se trouve le scalaire du quaternion : wxyz ou xyzw.
error-axis_and_angle = À un axe il faut un angle, et à un angle un axe.
error-family_incomplete = Une famille de triplets demande les trois : l’angle du milieu, somme ou différence, et sa valeur.
error-orientation_empty = Écrivez l’orientation dans l’une des notations demandées.
error-mistake_empty = Dites où est l’erreur, en quoi elle consiste ou comment la corriger.
error-frames_not_connected = Les poses connues ne mènent pas du repère { $start } au repère { $end }.
error-pose_without_table = Une pose est celle du tableau de l’étudiant ou de ⁰T : demandez aussi l’un d’eux, ou laissez les règles fixer le zéro, le sens, le repère 0 et le dernier repère.

error-one_notation = Donnez l’orientation dans une seule notation : { $known }.
error-name_without_value = Le nom { $name } n’a pas de valeur ici.{ $found ->
    [0] {""}
   *[one] {" "}Vouliez-vous dire { $close } ?
} Noms connus : { $known }.
error-rate_in_marks = { $text } n’est pas un nom ici. Vouliez-vous dire la vitesse articulaire { $suggestion } ?
error-expected_not_rotation =
    La matrice attendue n’est pas une rotation : { $property ->
        [unit_columns] une colonne n’est pas de longueur 1.
        [perpendicular_columns] deux colonnes ne sont pas perpendiculaires.
       *[right_handed] c’est une réflexion, de déterminant −1.
    }

field-solutions = Valeurs articulaires
field-combinations = S’il y en a une infinité : la combinaison qui reste constante (coefficients)
option-finite = est atteinte avec ces valeurs articulaires
option-infinite = est atteinte d’une infinité de façons ; en voici quelques-unes
option-out_of_reach = est hors d’atteinte
option-joint_limits = n’est pas atteinte dans les limites des articulations
given-target = La pose
given-target-position = La position de la dernière origine
given-table = Le tableau DH, convention { $convention ->
    [modified] modifiée
   *[standard] standard
}

task-inverse-kinematics =
    { $variables ->
        [own] Quelles valeurs de vos propres variables articulaires amènent le dernier repère à cet endroit dans le repère 0 ?
       *[given] Le tableau du robot est donné. Quelles valeurs articulaires amènent son dernier repère à cet endroit dans le repère 0 ?
    } { $solutions ->
        [one] Une solution suffit.
       *[all] Donnez-les toutes ; les tours complets ne comptent pas.
    } { $reach ->
        [position] Seule compte la position de la dernière origine, en { unit-word }.
       *[pose] Comptent la position, en { unit-word }, et l’orientation.
    }

feedback-joints_right = La réponse est juste : elle contient tout ce qui est demandé.
feedback-joints_searched = Pour cette pose, les solutions ont été trouvées par recherche ; il peut y en avoir d’autres.
feedback-joints_need_table = Les valeurs articulaires sont celles de vos propres variables : rendez aussi un tableau juste.
feedback-claim_wrong = Ce n’est pas le cas : recomptez les solutions de cette pose, s’il y en a.
feedback-joints_wrong = La ligne { $row } n’atteint pas la pose.
feedback-joints_twice = Les lignes { $other } et { $row } ne diffèrent que de tours complets : c’est une seule solution.
feedback-joints_missing =
    { $count ->
        [1] Il manque une solution.
       *[other] Il manque { $count } solutions.
    }
feedback-branch_shoulder =
    { $count ->
        [1] Le bras peut aussi atteindre la pose par l’arrière, avec l’autre configuration de l’épaule.
       *[other] Le bras peut aussi atteindre la pose par l’arrière, avec l’autre configuration de l’épaule : il manque { $count } solutions de ce type.
    }
feedback-branch_elbow =
    { $count ->
        [1] Le coude peut aussi plier de l’autre côté.
       *[other] Le coude peut aussi plier de l’autre côté : il manque { $count } solutions de ce type.
    }
feedback-branch_wrist =
    { $count ->
        [1] Le poignet peut aussi être retourné.
       *[other] Le poignet peut aussi être retourné : il manque { $count } solutions de ce type.
    }
feedback-branch_other =
    { $count ->
        [1] Il y a une autre branche de solutions.
       *[other] Il y a { $count } autres branches de solutions.
    }
feedback-joints_quadrant = Ligne { $row } : q{ $joint } est dans le mauvais quadrant, à un demi-tour. Prenez atan2 au lieu de atan.
feedback-joints_sign = Ligne { $row } : q{ $joint } a le mauvais signe.
feedback-joints_degrees = Ligne { $row } : des degrés ont été pris pour des radians, ou l’inverse.
feedback-joints_swapped = Ligne { $row } : q{ $joint } vaut 90° moins la valeur juste ; les arguments de atan2 ont été échangés.
feedback-joints_half_branch = La ligne { $row } est la ligne { $other } où seule q{ $joint } a changé : dans une autre branche, d’autres articulations changent avec elle.
feedback-joints_position_only = La ligne { $row } atteint la position, mais pas l’orientation.
feedback-joints_orientation_only = La ligne { $row } atteint l’orientation, mais pas la position.
feedback-joints_limits = La ligne { $row } atteint la pose avec l’articulation { $joint } au-delà de sa limite.
feedback-joints_rounded = La ligne { $row } est proche d’une solution, mais pas assez : calculez avec plus de décimales.
feedback-joints_family_missing = La pose est singulière : dites quelle combinaison des variables articulaires reste constante le long des solutions.
feedback-joints_taken_off = Ce qui est faux est retranché de ce qui est juste, pour que deviner ne rapporte rien : ici, il ne reste rien des lignes justes.
feedback-joints_combination_wrong = La combinaison { $row } ne reste pas constante le long des solutions.
feedback-joints_combination_zero = La combinaison { $row } vaut 0 quoi que fassent les articulations : elle ne dit rien.
feedback-joints_combination_loose = La combinaison { $row } reste constante le long des solutions, mais cela ne suffit pas : d’autres valeurs articulaires de même combinaison n’atteignent pas la pose.
error-pose_frames_free = La pose est donnée dans le repère 0 et pour le dernier : les règles doivent fixer les deux, base = "frame" et tool = "frame".
error-pose_within_reach = Ce bras atteint des poses aussi éloignées que l’on veut, car les articulations prismatiques n’ont pas de limites ici : retirez out_of_reach de cases.
error-joint_row_length = Une ligne contient une valeur par articulation : il en faut { $expected }, et { $given } ont été données.
error-joint_rows_empty = Donnez les valeurs articulaires qui atteignent la pose.

field-row = Ligne qui contient l’erreur
field-name = Ce qui est faux
field-mended = La ligne telle qu’elle devrait être
field-verdict = Les deux tableaux décrivent
field-reason = parce que
option-alpha_sign = α a le mauvais signe
option-alpha_value = α a une valeur fausse
option-a_sign = a a le mauvais signe
option-d_sign = d a le mauvais signe
option-a_value = a a une valeur fausse
option-d_value = d a une valeur fausse
option-a_d_swapped = a et d ont été échangés
option-a_missing = a est nulle, mais ne devrait pas l’être
option-a_not_zero = a n’est pas nulle, mais devrait l’être
option-d_missing = un décalage d a été oublié
option-d_not_zero = d n’est pas nul, mais devrait l’être
option-angles_in_degrees = tous les angles en degrés, alors que des radians sont déclarés
option-angles_in_radians = tous les angles en radians, alors que des degrés sont déclarés
option-cell_in_degrees = un angle en degrés parmi des radians
option-cell_in_radians = un angle en radians parmi des degrés
option-cell_length_unit = une longueur dans une autre unité
option-cell_parameter = une autre cote de la figure est utilisée
option-columns_early = a et α une ligne trop haut
option-columns_late = a et α une ligne trop bas
option-columns_exchanged = deux colonnes interverties
option-columns_reordered = colonnes dans un autre ordre
option-convention = la mauvaise convention est déclarée
option-fixed_row_missing = la dernière ligne, sans variable, manque
option-joint_fixed = une articulation sans sa variable
option-joint_moving = une variable là où rien ne bouge
option-joint_type = l’articulation est du mauvais type
option-length_unit = toutes les longueurs dans une autre unité
option-parameter_misnamed = un nom qui n’est pas sur la figure
option-parameters_swapped = deux cotes interverties
option-row_extra = une ligne de trop
option-row_missing = une ligne manque
option-rows_swapped = deux lignes interverties
option-theta_offset = la constante ajoutée à la variable θ est fausse
option-d_offset = la constante ajoutée à la variable d est fausse
option-theta_value = la constante θ a une valeur fausse
option-turns_all_reversed = tous les angles articulaires sont comptés à l’envers
option-twists_all_reversed = tous les α ont le mauvais signe
option-twists_early = α seul une ligne trop haut
option-twists_swapped = α de deux lignes intervertis
option-twists_late = α seul une ligne trop bas
option-variable_sign = une variable articulaire est comptée à l’envers
option-same = le même robot
option-different = des robots différents
option-axis_reversed = les repères diffèrent : un axe z, ou une variable articulaire, est inversé
option-x_turned = les repères diffèrent : un axe x est tourné, et le zéro de la variable est ailleurs
option-origin_moved = les repères diffèrent : une origine est ailleurs, ou le premier ou le dernier repère est placé autrement
option-other_convention = les repères diffèrent : la convention est autre
option-twist = l’angle entre deux axes diffère
option-length = la distance entre deux axes diffère
option-offset = un décalage le long d’un axe, ou un angle constant autour de lui, diffère
given-table-with-mistake = Le tableau qui contient une erreur ({ $convention ->
    [modified] convention modifiée
   *[standard] convention standard
})
given-first-table = Le premier tableau ({ $convention ->
    [modified] convention modifiée
   *[standard] convention standard
})
given-second-table = Le second tableau ({ $convention ->
    [modified] convention modifiée
   *[standard] convention standard
})

task-find-mistake = Ce tableau devrait décrire le robot de la figure, mais une ligne contient une erreur. Quelle ligne est fausse, en quoi, et que devrait-elle contenir ?
task-compare-tables = Ces deux tableaux décrivent-ils le même robot, quel que soit le choix des repères ? Dites pourquoi.

feedback-mistake_found = Vous avez trouvé l’erreur, vous l’avez nommée et corrigée.
feedback-mistake_row_wrong = L’erreur est dans une autre ligne.
feedback-mistake_name_wrong = L’erreur est d’un autre type.
feedback-mistake_not_mended = Avec cette ligne, le tableau ne décrit toujours pas le robot.
feedback-mistake_missing =
    { $what ->
        [row] Dites dans quelle ligne est l’erreur.
        [name] Dites ce qui est faux.
       *[mended] Écrivez la ligne telle qu’elle devrait être.
    }
feedback-tables_right = C’est juste, et pour la bonne raison.
feedback-tables_same = C’est le même robot : seuls les repères ont été choisis autrement.
feedback-tables_different = Ce sont des robots différents : aucun choix de repères ne transforme un tableau en l’autre.
feedback-tables_reason_wrong = Le verdict est juste, mais pas pour cette raison.
feedback-tables_reason_missing = Le verdict est juste ; dites aussi pourquoi.
error-row_unknown = Donnez le numéro d’une ligne, de 1 à { $count }.
error-column_unknown = Donnez le numéro d’une colonne, de 1 à { $count }.
error-vector_length = Le vecteur a { $expected } composantes, et { $given } ont été données.
error-joint_variable_in_number = { $name } est une variable articulaire, et c’est un nombre qui est demandé ici : mettez sa valeur.
error-no_mistake_does_harm = Aucune de ces erreurs ne change ce robot selon ses règles.
error-frame_mistakes_not_shown = Les repères de ce robot ne peuvent montrer aucune de ces erreurs. Ce qu’ils peuvent montrer : { $known }.
error-key_given_away = Cette partie montre un tableau ; un exercice qui demande le tableau ne peut pas l’avoir.
error-not_plantable = Aucune des erreurs demandées ne change ce robot.

field-frame = Les torseurs sont écrits dans
field-order = Ordre de v et ω
field-screws = Torseurs, une ligne par articulation
field-home = Pose initiale M
option-space = le repère fixe (espace)
option-body = le repère de l’outil à la position zéro (corps)
option-linear_first = v, ω : la partie linéaire d’abord
option-angular_first = ω, v : la partie angulaire d’abord

task-screws = Écrivez le robot comme produit d’exponentielles : les torseurs des articulations 1 à { $n } et la pose initiale M, longueurs en { unit-word }. Choisissez le repère, la position zéro et le sens de chaque axe dans le cadre des règles.

feedback-screws_right = Les torseurs et la pose initiale décrivent ce robot.
feedback-screws_right_robot = Ce produit d’exponentielles décrit le bon robot, mais ne respecte pas tout ce que l’exercice demande.
feedback-screws_wrong = Ce produit d’exponentielles ne décrit pas le robot, quels que soient le repère, le zéro et les sens choisis.
feedback-screw_not_unit = Articulation { $joint } : ω d’une articulation rotoïde est un vecteur unitaire.
feedback-screw_pitch = Articulation { $joint } : v a une composante le long de ω ; une articulation rotoïde n’avance pas le long de son axe.
feedback-screw_joint_type = Articulation { $joint } : une articulation prismatique a ω = 0 et un vecteur unitaire v ; une rotoïde a ω de longueur 1.
feedback-screw_halves = v et ω sont échangés : dans l’autre ordre, les lignes seraient justes.
feedback-screw_moment_sign =
    { $joint ->
        [0] Tous les v ont le mauvais signe
       *[other] Articulation { $joint } : v a le mauvais signe
    } : v = −ω × p, p étant un point quelconque de l’axe.
feedback-screw_other_frame = Ce sont les torseurs dans l’autre repère : espace et corps ont été confondus.
feedback-screw_home_inverted = La pose initiale est inversée.
feedback-screw_sign_or_home = Soit v a partout le mauvais signe (v = −ω × p, p étant un point quelconque de l’axe), soit la pose initiale est inversée.
feedback-screw_home = Les torseurs sont justes ; la pose initiale M ne l’est pas.
feedback-screw_not_rigid = La pose initiale n’est pas un déplacement rigide : ses colonnes ne sont pas unitaires et perpendiculaires, ou elles forment un trièdre indirect (déterminant −1), ou sa dernière ligne n’est pas 0 0 0 1.
feedback-screw_length_unit = Les longueurs sont dans une autre unité que celle du robot : dans la sienne, les lignes seraient justes.
feedback-screw_exchanged = Les lignes de l’articulation { $joint } et de la suivante sont échangées.
feedback-screw_reversed = Les lignes sont dans l’ordre inverse : la première est celle de l’articulation la plus proche de la base.
feedback-screws_relation_wrong = Les axes des articulations { $joint } et { $next } ne sont pas disposés entre eux comme sur la figure.
error-screw_count = Le robot a { $expected ->
    [one] { $expected } articulation
   *[other] { $expected } articulations
}, et { $given ->
    [one] { $given } torseur a été donné
   *[other] { $given } torseurs ont été donnés
}.

error-screw_too_large = Un nombre est trop grand pour un robot ; le plus grand est { $limit }.

field-jacobian = Jacobienne, une colonne par articulation
field-forces = Couples et forces articulaires
given-configuration = La configuration
given-wrench = Force et moment exercés par l’outil

task-jacobian =
    { $variables ->
        [own] Prenez votre propre tableau et vos propres variables articulaires à ces valeurs.
       *[given] Le tableau du robot et une configuration sont donnés.
    } { $ask ->
        [jacobian] Écrivez la jacobienne géométrique de la dernière origine, longueurs en { unit-word }, par radian.
        [forces] Quels couples et forces articulaires, τ = Jᵀ(f, m), correspondent à la force et au moment à la dernière origine, longueurs en { unit-word } ?
       *[both] Écrivez la jacobienne géométrique de la dernière origine, longueurs en { unit-word }, par radian, et les couples et forces articulaires τ = Jᵀ(f, m).
    } { $frame ->
        [end] Tous les vecteurs sont dans les axes du dernier repère.
       *[base] Tous les vecteurs sont dans les axes du repère 0.
    }

feedback-jacobian_right = Tout est juste.
feedback-jacobian_follows_table = Cela découle de votre tableau et rapporte ses points, bien que le tableau ne soit pas juste.
feedback-jacobian_needs_table = La jacobienne est celle de votre propre tableau : rendez aussi le tableau, avec toutes les articulations.
feedback-jacobian_missing =
    { $what ->
        [jacobian] Il manque la jacobienne.
       *[forces] Il manque les couples et forces articulaires.
    }
feedback-jacobian_wrong = Les colonnes de la jacobienne ne sont pas toutes justes.
feedback-forces_wrong = Les couples et forces articulaires ne sont pas tous justes.
feedback-jacobian_next_axis =
    { $count ->
        [1] La colonne { $joint } utilise l’axe d’une articulation voisine : voyez quel z appartient à quelle articulation dans votre convention.
       *[other] Les colonnes { $joints } utilisent chacune l’axe d’une articulation voisine : voyez quel z appartient à quelle articulation dans votre convention.
    }
feedback-jacobian_point_swapped =
    { $count ->
        [1] Colonne { $joint } : la partie linéaire est z × (pₙ − p), et non z × (p − pₙ).
       *[other] Colonnes { $joints } : la partie linéaire est z × (pₙ − p), et non z × (p − pₙ).
    }
feedback-jacobian_prismatic =
    { $count ->
        [1] Colonne { $joint } : une prismatique donne (z, 0), une rotoïde (z × (pₙ − p), z).
       *[other] Colonnes { $joints } : une prismatique donne (z, 0), une rotoïde (z × (pₙ − p), z).
    }
feedback-jacobian_other_frame =
    { $count ->
        [0] C’est la jacobienne dans les axes de l’autre repère.
        [1] La colonne { $joint } est dans les axes de l’autre repère.
       *[other] Les colonnes { $joints } sont dans les axes de l’autre repère.
    }
feedback-jacobian_rows_exchanged = Les lignes linéaires et angulaires ont été échangées.
feedback-jacobian_spatial = C’est la vitesse du point situé à l’origine du repère 0 ; il faut l’origine du dernier repère.
feedback-forces_sign = Tous les signes sont inversés : c’est τ = Jᵀ(f, m) qui est demandé, avec la force et le moment donnés.
feedback-forces_other_frame = Force et moment ont été pris dans les axes de l’autre repère.
feedback-forces_rows_exchanged = Force et moment ont été échangés.
feedback-forces_spatial = La force a été supposée agir à l’origine du repère 0.
error-row_order_missing = Dites quelles lignes viennent en premier : (v, ω) ou (ω, v).
error-jacobian_empty = Donnez la jacobienne ou les couples et forces articulaires.

error-wrench_missing = Aux couples et forces articulaires correspondent une force et un moment : donnez « wrench ».
