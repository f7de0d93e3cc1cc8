### Ce que l’autovérification d’un exercice dit à son auteur.

check-counts = { $exercise } : { $passed ->
    [one] { $passed } vérification réussie
   *[other] { $passed } vérifications réussies
}, { $failed } en échec, { $warnings ->
    [one] { $warnings } avertissement
   *[other] { $warnings } avertissements
}
check-structure = La graine { $seed } change la structure du robot.
check-drawn_structure = Le tirage peut donner { $name } = { $value }, ce qui change la structure du robot. Excluez cette valeur (without) ou choisissez un autre intervalle.
check-figure = Graine { $seed } : la figure ne peut pas être dessinée ({ $reason }).
check-right = Un tableau juste est refusé : { $table }
check-certificate = Le certificat d’un tableau juste ne tient pas : { $table }
check-harmless = Un tableau faux est accepté : { $table }
check-mistake = L’erreur { $mistake } n’est pas expliquée dans { $table }
check-part = Graine { $seed } : une réponse juste à la partie { $part } est refusée.
check-follow_through = Graine { $seed } : ce qui découle d’un tableau faux ne rapporte pas de points dans la partie { $part }.
check-wrong_part = Graine { $seed } : une réponse fausse à la partie { $part } n’est pas expliquée comme { $mistake }, mais comme { $told }.
check-invalid = Un tableau mal formé est noté : { $name }.
check-sample = L’exemple « { $name } » n’est pas jugé comme prévu ; le verdict est : { $told }.
check-rounded = Un tableau juste arrondi à { $digits } chiffres est refusé avec la règle d’outil { $rule } : { $table }
check-tool_rule = Un tableau juste est refusé avec la règle d’outil { $rule } : { $table }
check-crash = Graine { $seed } : l’évaluation échoue : { $reason }
check-unneeded = Aucune réponse juste n’a besoin de { $name } : on peut choisir des repères où cette cote n’apparaît pas. { $rules ->
    [none] Aucune règle n’y change rien : retirez-la de l’énoncé.
   *[other] Si la réponse doit la contenir, chacune de ces règles suffit : { $rules }. Sinon, retirez-la de l’énoncé.
}
check-alike = Certains étudiants peuvent intervertir { $name } et { $other } dans les valeurs numériques sans que rien ne le montre : les deux diffèrent de 1 % au plus. Choisissez des valeurs, ou des intervalles de tirage, plus éloignés.
check-taken_by_slide = Dans la ligne de l’articulation { $joint }, { $name } sous d désigne la variable articulaire, non la cote. Qui choisit des repères où la cote y figure ne peut pas l’écrire. Donnez-lui un autre nom.
check-taken_by_short_form = Là où la réponse est une formule, { $name } désigne un cosinus ou un sinus, non la cote. Donnez-lui un autre nom.
check-no_joints = Le robot n’a aucune articulation : il n’y a rien à décrire. Mettez-en une dans une ligne du tableau.
check-nothing_earned = Aucun tableau faux ne rapporte de points : rien de ce qu’un tableau de zéros décrit mal de ce robot n’a de poids. Changez les poids ou fixez davantage de règles.
check-asked_as_shown = La partie { $kind } montre ce qu’elle demande. Demandez autre chose, ou montrez-le sous une autre forme.
check-gravity_not_down = Sur la figure, la pesanteur que donne la partie { $kind } n’est pas dirigée vers le bas. Tournez le repère 0 par upright, ou changez gravity.
check-frames_coincide = Sur la figure de la partie { $kind }, deux repères ont la même origine, car une articulation prismatique entre eux y est dessinée à zéro. Donnez-lui une autre valeur dans posture.
check-limits_ambiguous = La réponse à la partie { $kind } dépend du sens dans lequel croît la variable d’une articulation qui a des limites, et ce sens se choisit librement. Fixez les sens (figure), ou choisissez des limites pour lesquelles il est indifférent.
warm-counts = { $exercise } : { $values ->
    [one] { $values } jeu de valeurs vérifié et dessiné
   *[other] { $values } jeux de valeurs vérifiés et dessinés
}, { $figures ->
    [one] { $figures } figure
   *[other] { $figures } figures
}, { $forms ->
    [one] { $forms } forme littérale
   *[other] { $forms } formes littérales
}, { $failed ->
    [one] { $failed } échec
   *[other] { $failed } échecs
}, { $seconds } s
error-nothing_to_warm = Il n’y a ni exercice ni cours avec des liens nommé { $name }.
error-variants_set = Le nombre de variantes de { $name } est fixé dans l’exercice ou dans les règles des liens du cours. Omettez --variants.
