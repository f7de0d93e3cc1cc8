# Comment les forces meuvent un robot.

error-links_count = La liste des corps a une entrée par ligne du tableau : { $expected }, et non { $given }.
error-mass_negative = Une masse n’est pas négative : { $mass } kg.
error-inertia_not_symmetric = Une matrice d’inertie est symétrique : l’élément xy est égal à yx.
error-inertia_negative = Un moment d’inertie par rapport à un axe n’est jamais négatif. Cette matrice en a un qui l’est.
error-mass_matrix_singular = Une articulation ne déplace rien qui ait une masse : aucune force ne détermine son accélération. Donnez une masse et une inertie aux corps.
