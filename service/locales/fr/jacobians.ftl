task-jacobian-analytic =
    { $variables ->
        [own] Prenez votre propre tableau et vos propres variables articulaires à ces valeurs.
       *[given] Le tableau du robot et une configuration sont donnés.
    } Écrivez la jacobienne analytique : la vitesse de la dernière origine dans le repère 0, puis les dérivées temporelles des trois angles autour des axes { $turning ->
            [fixed] fixes
           *[current] courants
        } { $axes }, dans leur ordre. Donnez des nombres, longueurs en { unit-word }, par radian.

task-jacobian-form =
    { $variables ->
        [own] Prenez votre propre tableau et vos propres variables articulaires.
       *[given] Le tableau du robot est donné.
    } { $ask ->
        [jacobian] Écrivez la jacobienne géométrique de la dernière origine sous forme littérale : ses éléments sont des fonctions des variables articulaires, par radian.
        [forces] Écrivez les couples et forces articulaires qui correspondent à la force et au moment à la dernière origine, τ = Jᵀ(f, m), en fonction des variables articulaires.
       *[both] Écrivez la jacobienne géométrique de la dernière origine sous forme littérale, par radian, et les couples et forces articulaires τ = Jᵀ(f, m) qui correspondent à la force et au moment à la dernière origine.
    } { $frame ->
        [end] Tous les vecteurs sont dans les axes du dernier repère.
       *[base] Tous les vecteurs sont dans les axes du repère 0.
    }

task-jacobian-form-analytic =
    { $variables ->
        [own] Prenez votre propre tableau et vos propres variables articulaires.
       *[given] Le tableau du robot est donné.
    } Écrivez la jacobienne analytique : la vitesse de la dernière origine dans le repère 0, puis les dérivées temporelles des trois angles autour des axes { $turning ->
            [fixed] fixes
           *[current] courants
        } { $axes }, dans leur ordre. Les éléments sont des fonctions des variables articulaires.

feedback-jacobian_geometric = Les trois dernières lignes sont celles de la vitesse angulaire ; ce sont les dérivées des angles qui sont demandées.
feedback-jacobian_other_point = Ce sont les vitesses d’un autre point ; il faut celle de l’origine du dernier repère.
feedback-jacobian_reversed =
    { $count ->
        [1] La colonne { $joint } est de signe opposé : voyez dans quel sens pointe z.
       *[other] Les colonnes { $joints } sont de signe opposé : voyez dans quel sens pointe z.
    }
feedback-jacobian_per_degree = Les colonnes des articulations rotoïdes sont par degré ; elles sont demandées par radian.
feedback-jacobian_other_unit = Les longueurs sont dans une autre unité que celle demandée.
feedback-jacobian_angles_locked = Dans cette configuration, le premier et le dernier angle tournent autour de la même droite : les angles n’ont pas de dérivées et il n’y a pas de jacobienne analytique.
error-angles_locked = Le premier et le dernier des angles { $axes } tournent ici autour de la même droite : il n’y a pas de jacobienne analytique. Choisissez d’autres angles.
