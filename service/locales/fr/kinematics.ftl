# Valeurs articulaires, poses, torseurs et tableaux numériques.

error-target_unanswered = Le calcul s’est arrêté après { $seconds } s ; cibles traitées : { $answered }. Demandez cette cible et les suivantes dans une autre requête.
error-joints_wrong_length =
    { $expected ->
        [1] Le tableau a une articulation, mais la configuration donnée compte { $given ->
            [one] { $given } valeur
           *[other] { $given } valeurs
        }.
       *[other] Le tableau a { $expected } articulations, mais la configuration donnée compte { $given ->
            [one] { $given } valeur
           *[other] { $given } valeurs
        }.
    }
error-joints_malformed = Les valeurs articulaires sont des nombres : une configuration [q1, …, qn] ou une liste de configurations de même longueur.
error-joint_not_finite = La valeur de l’articulation { $joint } n’est pas un nombre fini.
error-result_not_finite = Le résultat est trop grand pour un nombre en double précision. Les longueurs et les valeurs articulaires doivent être plus petites.
error-entry_not_finite = { $cell } n’est pas un nombre fini.
error-value_undefined = Pour ces paramètres, l’expression n’a pas de valeur finie.

error-pose_not_numbers = Une pose est une matrice 4×4 de nombres.
error-pose_wrong_shape = Une pose est une matrice 4×4 de nombres ; celle-ci est { $shape }.
error-pose_not_finite = Cet élément n’est pas un nombre fini.
error-pose_in_one_row = Seize nombres dans une seule liste ne sont pas une pose : écrivez quatre lignes de quatre nombres, [[…], […], […], [0, 0, 0, 1]].
error-inertia_in_one_row = Une inertie ne s’écrit pas en une seule liste : écrivez trois lignes de trois, [[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]], avec Ixy = −∫ x y dm.
error-pose_bottom_row = La dernière ligne d’une pose est 0, 0, 0, 1.
error-pose_not_orthonormal = La partie rotation n’est pas orthonormée (écart de { $error }) : ses colonnes doivent être des vecteurs unitaires perpendiculaires, à { $tolerance } près. Donnez plus de décimales ou, pour le modèle géométrique inverse, une tolérance (`tolerance`).
error-pose_left_handed = La partie rotation forme un trièdre indirect : son déterminant vaut −1, c’est une réflexion. Il doit valoir +1.

error-notation_wrong_length =
    { $expected ->
        [1] { $what } prend un nombre : { $names }.
       *[other] { $what } prend { $expected } nombres : { $names }.
    }
error-notation_not_finite = { $name } de { $what } n’est pas un nombre fini.
error-quaternion_length = Un quaternion de norme nulle ou trop grande n’est pas une orientation. Donnez un quaternion unitaire.
error-axis_length = Un axe de longueur nulle ou trop grande n’a pas de direction. Donnez un vecteur unitaire.

error-screw_not_finite = Un torseur cinématique est formé de six nombres finis.
error-screw_not_unit = La partie angulaire du torseur d’une articulation rotoïde et la partie linéaire de celui d’une articulation prismatique doivent être de longueur 1.
error-screw_has_pitch = Ce torseur a un pas de { $pitch } par radian. Une articulation tourne ou coulisse, pas les deux.
error-screw_of_other_type = Le torseur { $joint } n’est pas du type annoncé : une articulation rotoïde a une partie angulaire, une prismatique n’en a pas.
error-tree_after_unknown = La ligne { $row } suit le repère { $given } : elle doit suivre la base (0) ou une ligne précédente. Les boucles fermées ne sont pas prises en charge.
error-frame_unknown = Il n’y a pas de repère { $given } ; le dernier est le { $count }.
