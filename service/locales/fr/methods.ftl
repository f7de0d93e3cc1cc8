# Modèle géométrique inverse.

error-inverse_form_unknown = Les axes de ce bras ne se suivent pas d’une façon dont le modèle géométrique inverse soit connu sous forme littérale : ils doivent être perpendiculaires ou parallèles, avec deux ou trois articulations qui se déplacent dans un plan et un poignet à axes concourants. La résolution numérique reste possible.
error-inverse_form_idle_joint = L’articulation { $joint } ne sert à rien là où la forme littérale en a besoin : le point qu’elle devrait déplacer est sur son axe, ou une autre articulation le déplace de la même façon, car une longueur entre axes vaut 0 ou deux articulations prismatiques sont parallèles. La résolution numérique reste possible.
error-inverse_joint_count = Le modèle géométrique inverse accepte de 1 à { $limit } articulations ; ce tableau en a { $count }.
error-limits_wrong_length = Le bras a { $expected ->
    [one] { $expected } articulation
   *[other] { $expected } articulations
}, mais { $given ->
    [one] { $given } limite a été donnée
   *[other] { $given } limites ont été données
} ; donnez-en une par articulation, null là où il n’y en a pas.
error-limits_reversed = Donnez pour limites de l’articulation { $joint } sa valeur minimale puis sa valeur maximale, dans cet ordre.
error-limits_too_far = Les limites de l’articulation { $joint } sont toutes deux à plus de { $limit } rad de 0. Retranchez des tours complets de l’une et de l’autre.
error-pose_tolerance_out_of_range = La tolérance est un nombre positif, { $limit } au plus.
error-targets_wrong_shape = Donnez plusieurs poses à atteindre sous forme d’une liste de matrices 4×4.
error-workspace_condition_unmet = Aucune configuration remplissant cette condition n’a été trouvée dans les limites.
