field-conditions = Conditions de singularité
field-lost = Un mouvement perdu

task-singularities =
    Le tableau du robot est donné. Dans quelles configurations le bras perd-il un mouvement : { $motion ->
        [translation] où le rang de la jacobienne de la vitesse de la dernière origine est-il inférieur à son rang ordinaire ?
       *[twist] où le rang de la jacobienne est-il inférieur à son rang ordinaire ?
    } Écrivez une condition par ligne : une fonction qui s’y annule (sin(q3)) ou une équation (q3 = 0, π). Seul compte l’ensemble des configurations, quelle que soit l’écriture.{ $lost ->
        [yes] {" "}Pour la configuration donnée, écrivez un vecteur λ ≠ 0 dans les axes du repère 0 tel que λ · J q̇ = 0 quoi que fassent les articulations, à la dernière origine, longueurs en { unit-word } : le mouvement perdu.
       *[no] {""}
    }

feedback-singularities_right = Les conditions sont vérifiées exactement là où le bras est singulier, et rien ne manque.
feedback-singularities_missing = Familles de singularités trouvées : { $found } sur { $count }.
feedback-singularity_missing_at = Aucune de vos conditions n’est vérifiée dans cette configuration singulière : { $at }.
feedback-singularity_invented = La condition { $condition } est aussi vérifiée là où le bras n’est pas singulier.
feedback-singularity_invented_at = La condition { $condition } est vérifiée en { $at }, où le bras n’est pas singulier.
feedback-singularity_rounded = La condition { $condition } approche d’une singularité, mais pas assez : calculez avec plus de décimales.
feedback-singularity_sine_for_cosine = La condition { $condition } est celle d’une singularité à un quart de tour près : sinus et cosinus ont été échangés.
feedback-singularity_half = Une partie seulement d’une famille est trouvée : pensez aussi à l’autre solution de son équation (q = π outre q = 0, le bras replié outre le bras tendu).
feedback-singularity_everywhere = La condition { $condition } est toujours vérifiée.
feedback-singularity_nowhere = La condition { $condition } n’est jamais vérifiée et ne dit rien.
feedback-conditions_missing = Les conditions manquent.
feedback-lost_motion_missing = Le mouvement perdu manque.
feedback-lost_motion_wrong = Le vecteur n’est pas un mouvement perdu ici.
feedback-lost_motion_is_kept = Avec ce vecteur le bras bouge encore : λᵀJ n’est pas nul.
feedback-lost_motion_zero = λ = 0 conviendrait partout : donnez un vecteur non nul.
feedback-lost_motion_never = Le bras ne bouge ainsi dans aucune configuration : ce n’est pas ici que ce mouvement se perd.
error-conditions_empty = Donnez des conditions ou un mouvement perdu.
error-condition_not_equation = { $text } n’est pas une condition : écrivez une fonction qui s’annule ou une équation avec un seul signe =.
error-condition_angle_nonlinear = Un angle articulaire hors d’un sinus, d’un cosinus ou d’une tangente ne peut figurer que dans une équation comme q2 + q3 = π/2.
error-conditions_too_many = Cette cellule contient plus de { $limit } conditions.
error-condition_period = Ce qui s’ajoute k fois doit être un tour divisé par un nombre entier : 2π, π, π/2, …
error-singularities_no_families = Aucune condition ne peut dire où ce bras est singulier : il ne l’est jamais, ou seulement dans des familles de dimension moindre. Choisissez l’autre mouvement ou un autre robot.
error-not_singular = Le bras n’est pas singulier dans cette configuration.
