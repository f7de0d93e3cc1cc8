# Comment les forces meuvent un robot.

error-links_count = La liste des corps a une entrée par ligne du tableau : { $expected }, et non { $given }.
error-mass_negative = Une masse n’est pas négative : { $mass } kg.
error-inertia_not_symmetric = Une matrice d’inertie est symétrique : l’élément xy est égal à yx.
error-inertia_negative = Un moment d’inertie par rapport à un axe n’est jamais négatif. Cette matrice en a un qui l’est.
error-mass_matrix_singular = Une articulation ne déplace rien qui ait une masse : aucune force ne détermine son accélération. Donnez une masse et une inertie aux corps.
error-links_missing = Indiquez la masse des corps : links, une entrée par ligne du tableau.
error-name_of_rate = { $name } est le nom de la vitesse d’une articulation dans les formes littérales. Donnez un autre nom au paramètre.
error-body_varies = La masse d’un corps et sa place ne dépendent pas des variables articulaires : elles ne figurent que dans le tableau.
error-dynamics_not_finite = Les masses, longueurs ou vitesses sont si grandes que le résultat n’est pas un nombre.
