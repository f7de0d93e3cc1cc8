### Exercices : ce qui est demandé, ce qui est dit des réponses, ce qu'une définition ne peut pas contenir.

## La figure en mots

figure-title = { $title } : articulations, axes et cotes
figure-coordinates = { $joints ->
    [1] Un robot à une articulation.
   *[other] Un robot à { $joints } articulations, l’une après l’autre, comptées depuis la base.
} Les positions sont données en { unit-word } sous la forme (X ; Y ; Z). { figure-place }
figure-place = X pointe { $x ->
    [back] vers l’arrière, Y vers la gauche
    [left] vers la gauche, Y vers l’avant
    [front] vers l’avant, Y vers la droite
   *[right] vers la droite, Y vers l’arrière
}, Z vers le haut ; { $fixed ->
    [ground] le robot est fixé
   *[joint] le corps de l’articulation 1 se trouve
} en { $at }.
figure-joint-revolute = L’articulation { $joint } est rotoïde. Son corps se trouve en { $place } ; son axe { $course ->
    [vertical] est vertical
    [sideways] va de gauche à droite
    [depthways] va d’avant en arrière
   *[oblique] a pour direction { $direction }
}.
figure-joint-revolute-signed = L’articulation { $joint } est rotoïde. Son corps se trouve en { $place } ; son axe { $course ->
    [vertical] est vertical
    [sideways] va de gauche à droite
    [depthways] va d’avant en arrière
   *[oblique] est oblique
}. Selon la règle de la main droite, la variable articulaire est positive autour de { $direction }.
figure-joint-prismatic = L’articulation { $joint } est prismatique. Son corps se trouve en { $place } ; sa direction { $course ->
    [vertical] est verticale
    [sideways] va de gauche à droite
    [depthways] va d’avant en arrière
   *[oblique] est { $direction }
}.
figure-joint-prismatic-signed = L’articulation { $joint } est prismatique. Son corps se trouve en { $place } ; sa direction { $course ->
    [vertical] est verticale
    [sideways] va de gauche à droite
    [depthways] va d’avant en arrière
   *[oblique] est oblique
}. La variable articulaire est positive le long de { $direction }.
figure-dimension = { $name } vaut { $length } { $unit }, mesurée { $course ->
    [vertical] à la verticale
    [sideways] de gauche à droite
    [depthways] d’avant en arrière
   *[oblique] en oblique
}, entre { $start } et { $end }.
figure-point = Le point { $name } se trouve en { $place }.
figure-frame = L’origine du repère { $number } se trouve en { $place } ; son axe x est dirigé selon { $x }, son axe z selon { $z }.
figure-not-to-scale = Le dessin n’est pas à l’échelle : { $names } { $count ->
    [1] n’y a pas la longueur donnée
   *[other] n’y ont pas les longueurs données
} ici.
figure-note = sans échelle

## Ce qui est libre et ce qui est imposé

rule-convention-any = La convention standard et la convention modifiée sont toutes deux acceptées.
rule-convention-standard = Écrivez le tableau dans la convention standard.
rule-convention-modified = Écrivez le tableau dans la convention modifiée.
rule-base-free = Le repère 0 peut être placé n’importe où sur la base.
rule-base-axis = L’axe z du repère 0 est porté par l’axe de l’articulation 1, dans un sens ou dans l’autre.
rule-base-origin = L’origine du repère 0 est le point marqué O0 ; vous choisissez ses directions.
rule-base-frame = Le repère 0 est imposé ; la figure le montre.
rule-tool-free = Le dernier repère peut être placé n’importe où sur le dernier segment.
rule-tool-point = L’origine du dernier repère se trouve au point marqué { $points }.
rule-tool-axis = L’axe z du dernier repère est porté par l’axe de la dernière articulation, dans un sens ou dans l’autre ; son origine peut être n’importe où sur cet axe.
rule-tool-frame = Le dernier repère est imposé ; la figure le montre.
rule-zero-free = Vous choisissez où chaque variable articulaire est nulle.
rule-zero-figure = Dans la configuration de la figure, toutes les variables articulaires sont nulles.
rule-direction-free = Vous choisissez le sens de chaque axe.
rule-direction-figure = Les variables articulaires sont positives dans le sens des flèches de la figure.

## Ce qui est demandé

task-schematic = Décrivez la structure : le type de chaque articulation, et comment l’axe de chacune est placé par rapport à celui de la suivante.
task-table = Choisissez les repères et écrivez le tableau DH. Les cellules peuvent contenir { $names }, des nombres et les variables articulaires q1 à q{ $n }.
task-link-matrices = Pour chaque ligne de votre tableau, écrivez la matrice de passage, c’est-à-dire la pose du repère i dans le repère i−1. Vous pouvez abréger cos(q1) en c1 et sin(q1 + q2) en s12.
task-transform = Écrivez sous forme littérale ⁰T, la pose du dernier repère dans le repère 0.
task-pose = Évaluez votre ⁰T pour { $joints } et pour les cotes données ici, les longueurs en { unit-word }.
task-workspace-axis = À quelle distance minimale et à quelle distance maximale de l’axe de l’articulation 1 peut-on amener { $point } ? { $limits ->
    [none] Chaque articulation peut prendre toute valeur.
   *[some] Les articulations respectent leurs limites : { $ranges } ; sur la figure, { $drawn }.
} Donnez les deux rayons en { unit-word }.
task-workspace-point = Quelles sont la plus petite et la plus grande distance entre { $point } et { $origin } ? { $limits ->
    [none] Chaque articulation peut prendre toute valeur.
   *[some] Les articulations respectent leurs limites : { $ranges } ; sur la figure, { $drawn }.
} Donnez les deux rayons en { unit-word }.

## Remarques sur les parties

feedback-part_wrong = Cette partie n’est pas encore juste.
feedback-schematic_right = La structure est juste.
feedback-schematic_joint_count = Vous indiquez { $given ->
    [1] une articulation
   *[other] { $given } articulations
} ; recomptez celles qui peuvent bouger.
feedback-schematic_joint_type = Le type de l’articulation { $joint } n’est pas juste.
feedback-schematic_relation = La position relative des axes { $first } et { $second } n’est pas juste.
feedback-schematic_angle_right = Axes { $first } et { $second } : l’angle entre eux est juste, mais pas le fait qu’ils se coupent ou non.
feedback-schematic_meeting_right = Les axes { $first } et { $second } se coupent bien, mais pas sous cet angle.
feedback-matrices_right = Les matrices de passage sont justes.
feedback-matrices_follow_table = Les matrices de passage découlent de votre tableau et rapportent leurs points, bien que le tableau ne soit pas juste.
feedback-matrices_right_not_from_table = Les matrices de passage sont justes pour le robot, bien qu’elles ne découlent pas de votre tableau.
feedback-matrices_product_wrong = Multipliées entre elles, vos matrices de passage ne décrivent pas ce robot.
feedback-matrix_missing = La matrice { $matrix } manque.
feedback-matrix_wrong = La matrice { $matrix } ne correspond pas à la ligne { $matrix } de votre tableau.
feedback-matrix_cells_wrong = La matrice { $matrix } diffère de la ligne { $matrix } de votre tableau dans ces cellules (ligne,colonne) : { $cells }.
feedback-matrix_inverse = La matrice { $matrix } est inversée : c’est la pose du repère i−1 dans le repère i.
feedback-matrix_rotation_transposed = La rotation dans la matrice { $matrix } est transposée.
feedback-matrix_other_convention = La matrice { $matrix } a été formée selon la règle de l’autre convention.
feedback-matrix_without_variable = La matrice { $matrix } a été écrite pour une variable articulaire nulle ; gardez la variable.
feedback-matrix_of_other_row = La matrice { $matrix } est celle de la ligne { $other }.
feedback-matrix_not_rigid = La matrice { $matrix } n’est pas un déplacement rigide : ses colonnes ne sont pas des vecteurs unitaires orthogonaux, ou elles forment un trièdre indirect (déterminant −1), ou sa dernière ligne n’est pas 0 0 0 1.
feedback-transform_right = ⁰T est juste.
feedback-transform_follows_table = ⁰T découle de votre tableau et rapporte ses points, bien que le tableau ne soit pas juste.
feedback-transform_right_not_from_table = ⁰T est juste pour le robot, bien qu’elle ne découle pas de votre tableau.
feedback-table_says_little = Votre tableau a moins de la moitié des longueurs et des angles α qu’il faut pour décrire ce robot ; ce qui en découle ne rapporte qu’une partie de ses points, et rien si tout y est nul.
feedback-transform_wrong = Cette matrice ⁰T ne décrit pas le robot.
feedback-transform_rotation_right = La rotation dans ⁰T est juste.
feedback-transform_position_right = La position dans ⁰T est juste.
feedback-transform_cells_wrong = ⁰T diffère de votre tableau dans ces cellules (ligne,colonne) : { $cells }.
feedback-transform_not_rigid = ⁰T n’est pas un déplacement rigide : ses colonnes ne sont pas des vecteurs unitaires orthogonaux, ou elles forment un trièdre indirect (déterminant −1), ou sa dernière ligne n’est pas 0 0 0 1.
feedback-transform_inverse = C’est l’inverse de ⁰T : la pose du repère 0 dans le dernier repère.
feedback-transform_rotation_transposed = La rotation dans ⁰T est transposée.
feedback-transform_order_reversed = Les matrices de passage ont été multipliées dans l’ordre inverse.
feedback-transform_links_missing = C’est le produit jusqu’au repère { $last } seulement ; continuez jusqu’au dernier repère.
feedback-pose_right = La pose est juste.
feedback-pose_follows_table = La pose découle de votre tableau et rapporte ses points, bien que le tableau ne soit pas juste.
feedback-pose_wrong = Cette pose n’est pas celle que votre tableau donne pour ces valeurs articulaires.
feedback-pose_last_row = La dernière ligne d’une pose est 0 0 0 1 ; avec une autre, la matrice n’est pas une pose et ne rapporte aucun point.
feedback-pose_rotation_right = La rotation est juste.
feedback-pose_position_right = La position est juste.
feedback-pose_inverse = C’est l’inverse de la pose.
feedback-pose_rotation_transposed = La rotation est transposée.
feedback-pose_degrees_as_radians = Les sinus et cosinus ont été calculés avec des degrés pris pour des radians.
feedback-workspace_right = Les deux rayons sont justes.
feedback-workspace_inner_wrong = Le rayon intérieur n’est pas juste.
feedback-workspace_outer_wrong = Le rayon extérieur n’est pas juste.
feedback-workspace_swapped = Le rayon intérieur et le rayon extérieur sont échangés.
feedback-workspace_diameters = Ce sont des diamètres ; on demande les rayons.
feedback-workspace_other_length_unit = Les rayons sont justes dans une autre unité ; on les demande en { unit-word }.

## Pourquoi une réponse ne peut pas être notée

problem-note-ungraded = Cette réponse n’a pas été notée et ne coûte aucun essai.
error-answer_empty = Rien n’a été rendu. L’exercice demande { $known }.
error-part_not_asked = L’exercice ne demande pas { $part } ; il demande { $known }.
error-link_matrices_count = Le tableau a { $expected ->
    [1] une ligne
   *[other] { $expected } lignes
}, mais { $given ->
    [1] une matrice est donnée
   *[other] { $given } matrices sont données
}. Donnez-en une par ligne ; null en saute une.
error-link_matrices_need_table = Sans le tableau, les matrices de passage sont jugées sur leur produit. Donnez-les toutes.
error-pose_needs_table = La pose est celle de votre propre tableau. Rendez aussi le tableau.
error-matrix_not_4x4 = Une matrice a quatre lignes de quatre cellules.
error-joint_variable_unknown = Il n’y a pas de { $name } ; le robot a { $joints ->
    [1] une articulation
   *[other] { $joints } articulations
}.{ $summed ->
    [0] {""}
   *[other] {" "}Une somme s’écrit en entier : { $sum }.
}
error-short_form_unknown = { $name } est lu comme un cosinus ou un sinus, mais ses indices ne sont pas tous des articulations rotoïdes ; le robot a { $joints ->
    [1] une articulation
   *[other] { $joints } articulations
}.
error-radius_negative = Un rayon ne peut pas être négatif.
error-schematic_fixed_joint = La structure énumère les articulations mobiles : rotoïdes ou prismatiques.
error-schematic_relations_count = { $joints ->
    [1] Une articulation a
   *[other] { $joints } articulations ont
} { $expected ->
    [1] une paire
   *[other] { $expected } paires
} d’axes voisins. Donnez une relation par paire.
error-seed_invalid = Une graine est un texte ou un nombre entier.
error-seed_too_long = Une graine a au plus { $limit } caractères.
error-exercise_unknown = Il n’y a pas d’exercice { $id }. Disponibles : { $known }.
error-language_unknown = La langue { $language } n’est pas proposée ici. Disponibles : { $known }.

## Pourquoi une définition ne peut pas être lue

error-exercise_file_missing = Le fichier exercise.toml manque.
error-exercise_file_not_toml = Ce n’est pas du TOML : { $reason }
error-exercise_key_missing = { $key } manque.
error-exercise_key_unknown = { $key } n’est pas une clé connue. Les clés connues sont { $known }.
error-exercise_value_type = { $key } doit être { expected-value }.
error-exercise_value_unknown = { $key } doit être l’une de ces valeurs : { $known }.
error-exercise_robot_unknown = Le catalogue ne contient aucun robot { $robot }. Il contient { $known }.
error-exercise_limits_reversed = Les limites de l’articulation { $joint } se donnent sous la forme [minimum, maximum].
error-exercise_limits_unknown = Le catalogue ne connaît pas les limites de ce robot.
error-folder_missing = Il n’y a pas de dossier { $folder }.
error-exercise_id_invalid = { $id } n’est pas un identifiant d’exercice ; un identifiant a des lettres, des chiffres et des traits d’union simples.
error-exercise_exists = L’exercice { $id } existe déjà.
error-source_unreadable = Le fichier ne peut pas être lu : { $reason }
error-robot_and_reference = Donnez robot ou [reference], pas les deux.
error-statement_missing = L’énoncé dans la langue { $language } manque.
error-statement_name_unknown = { $name } n’est ni une cote du robot, ni un point ou une cote de la figure.
error-misconception_unknown = { $name } n’est pas une erreur de la liste. Disponibles : { $known }.
error-nothing_asked = Un exercice doit demander quelque chose : ajoutez une partie.
error-part_twice = { $kind } est demandé deux fois.
error-points_not_positive = Une partie vaut plus de zéro point.
error-draw_empty = Il n’y a aucune valeur à tirer : « from » ne peut dépasser « to », et « step » doit être positif.
error-draw_too_large = Un tirage a au plus { $limit } valeurs.
error-variants_too_many = Il y a au plus { $limit } variantes.
error-tolerance_out_of_range = { $name } est compris entre 0 et 0,1.
error-name_invalid = { $name } n’est pas un nom de cote ; un nom ressemble à L1.
error-width_out_of_range = La largeur est comprise entre 320 et 960.
error-unknown_point = Il n’y a pas de point { $name }. Disponibles : { $known }.
error-unknown_frame = Ce repère n’existe pas : ils sont numérotés de 0 à { $last }.
error-unknown_joint = L’articulation { $joint } n’existe pas : elles sont numérotées de 1 à { $last }.
error-point_without_form = Un point se donne par frame et at ; par between et ratio ; par from et by ; ou par from, joint et distance.
error-joint_off_axis = Le point { $point } n’est pas sur l’axe de l’articulation { $joint }.
error-dimension_disagrees = Les points de { $name } sont distants de { $length }, mais { $name } vaut { $value }.
error-dimension_too_short = { $name } vaut { $length }, trop peu pour être montrée dans la figure : c’est moins d’un millionième de la taille du robot. Donnez-lui une autre valeur, ou écrivez 0 à sa place.
error-posture_not_zero = Avec zero = figure, on dit aux étudiants que toutes les variables articulaires sont nulles dans la configuration de la figure : dessinez-y le robot (posture 0 pour chaque articulation) ou laissez les zéros libres.
error-tool_point_unmarked = Avec tool = point, la dernière origine doit se trouver en un point marqué, mais aucun des points marqués n’est la dernière origine de la solution de référence. Marquez l’origine du repère { $last }.
error-gripper_without_direction = La pince et le point dont elle s’éloigne sont confondus.
error-jaws_along_gripper = Les mors sont placés côte à côte, perpendiculairement à la pince.

error-name_unknown = { $name } n’est aucune des cotes de cet exercice.{ $unit ->
    [0] {""}
   *[one] {" "}Les unités ne s’écrivent pas dans les cellules : si { $name } en est une, omettez-la.
}{ $found ->
    [0] {""}
   *[one] {" "}Vouliez-vous dire { $close } ?
} Cotes connues : { $known }.
error-need_unmet = Avec ces règles, aucune réponse n’a besoin de { $name } : on peut choisir des repères où cette cote n’apparaît pas. { $rules ->
    [none] Aucune règle n’y change rien : retirez-la de needs.
   *[other] Chacune de ces règles suffit à la rendre nécessaire : { $rules }.
}
error-need_unknown = { $name } n’est pas une cote du tableau. Ses cotes : { $known }.
error-alias_taken = { $name } a déjà un sens.
error-title_missing = Il faut un titre dans une langue au moins : [title] avec en = "…".
exercise-other-language = Cet exercice n’est pas encore écrit dans votre langue. Langue du texte : { $language }.
rule-dimension-free = Avec des repères bien choisis, votre tableau peut se passer de { $names }.
error-context_invalid = Ce lien n’a pas été créé ici, ou il a été modifié.
error-context_expired = Ce lien a expiré.
error-switched_off = { $path } est désactivé pour cet exercice.
error-attempts_used_up = { $limit ->
    [1] Le seul essai que permet cet exercice a été fait.
   *[other] Les { $limit } essais que permet cet exercice ont tous été faits.
}
error-ladder_falls = À chaque essai, on peut en dire autant qu’à l’essai précédent ou plus, jamais moins.
task-frames = Placez les repères 0 à { $n } sur le robot tel que le montre la figure : pour chacun son origine, en { unit-word } et dans les coordonnées de la figure, et les directions de x et de z. { figure-place }
error-frames_count = Il y a les repères 0 à N : il en faut { $expected }, { $given } ont été donnés.
error-convention_not_asked = L’exercice demande la convention { $asked ->
    [modified] modifiée
   *[standard] standard
}.
error-weight_out_of_range = Le poids de { $name } est un nombre de 0 à { $most }.
