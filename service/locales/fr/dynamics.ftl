# Comment les forces meuvent un robot.

error-links_count = La liste des segments a une entrée par ligne du tableau : { $expected }, et non { $given }.
error-mass_negative = Une masse ne peut pas être négative : { $mass } kg.
error-inertia_not_symmetric = Un tenseur d’inertie est symétrique : l’élément xy est égal à yx.
error-inertia_negative = Un moment d’inertie par rapport à un axe n’est jamais négatif. Ce tenseur en a un négatif par rapport à un certain axe.
error-dynamics_without_joints = Rien ne bouge : les équations du mouvement demandent une ligne rotoïde ou prismatique.
error-mass_matrix_singular = Une articulation ne déplace rien qui ait une masse : aucune force ne détermine son accélération. Donnez une masse et une inertie aux segments.
error-links_missing = Indiquez la masse des segments : links, une entrée par ligne du tableau.
error-name_of_rate = { $name } est le nom de la vitesse d’une articulation dans les formes littérales. Donnez un autre nom au paramètre.
error-body_varies = La masse d’un segment et sa place dans celui-ci ne dépendent pas des variables articulaires : celles-ci ne figurent que dans le tableau.
error-dynamics_not_finite = Les masses, longueurs ou vitesses sont si grandes que le résultat n’est pas un nombre.

task-equations-of-motion =
    Le tableau du robot est donné, ainsi que le corps qui se meut avec chaque repère i. Écrivez les termes demandés de M q̈ + C q̇ + g = τ en fonction de q1, q2, …, de leurs vitesses dq1, dq2, … et des symboles donnés ; longueurs en { unit-word }, par radian. { $skew ->
        [yes] Toute C donnant le bon C q̇ est juste ; de plus, Ṁ − 2C doit être antisymétrique.
       *[no] Toute C donnant le bon C q̇ est juste.
    }
given-link-weights = Les segments : masse, centre dans le repère i, moments d’inertie en ce centre [kg { $unit }²]
given-gravity-vector = Accélération de la pesanteur dans le repère 0 [{ $unit }/s²]
given-weights = Valeurs des symboles
field-mass = Matrice d’inertie M
field-coriolis = Matrice C
field-velocity = Termes de Coriolis et centrifuges C q̇
field-gravity = Termes de pesanteur g
feedback-motion_right = Ce sont bien les équations du mouvement.
feedback-motion_mass_wrong = Les éléments de M ne sont pas tous justes.
feedback-motion_coriolis_wrong = Les lignes de C q̇ ne sont pas toutes justes.
feedback-motion_velocity_wrong = Les termes de Coriolis et centrifuges ne sont pas tous justes.
feedback-motion_skew_wrong = Avec cette C, Ṁ − 2C n’est pas antisymétrique. Les symboles de Christoffel donnent une C pour laquelle elle l’est.
feedback-motion_gravity_wrong = Les éléments de g ne sont pas tous justes.
feedback-motion_missing =
    { $what ->
        [mass] Il manque la matrice d’inertie.
        [coriolis] Il manque la matrice C.
        [skew] Sans la matrice C, il n’y a pas de Ṁ − 2C.
        [velocity] Il manque les termes de Coriolis et centrifuges.
       *[gravity] Il manque les termes de pesanteur.
    }
feedback-motion_asymmetric = Une matrice d’inertie est symétrique ; celle-ci ne l’est pas.
feedback-motion_point_masses = C’est la M de masses ponctuelles : il manque les moments d’inertie propres des segments.
feedback-motion_gravity_sign = Ce g est de signe opposé : g est ce que les articulations doivent fournir contre la pesanteur, le gradient de l’énergie potentielle.
feedback-motion_velocity_sign = Ce C q̇ est de signe opposé.
feedback-motion_coupling_once = Chaque produit q̇j q̇k de deux articulations différentes figure deux fois dans C q̇, comme jk et comme kj ; ici il ne compte qu’une fois.
feedback-motion_mass_rate = C’est Ṁ q̇. Il faut en retrancher le gradient de l’énergie cinétique, ½ ∂(q̇ᵀM q̇)/∂q.
error-motion_row_count = La matrice a une ligne par articulation : { $expected }, et non { $given }.
error-motion_empty = Écrivez au moins une des matrices ou lignes demandées.
error-motion_cell = Écrivez ici un nombre ou une expression ; pour une position ou des moments d’inertie, trois.
