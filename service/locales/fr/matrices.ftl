field-cell_row = Ligne d’un élément faux
field-cell_column = Colonne d’un élément faux
field-mistake = Ce qui est faux
field-mended_matrix = La matrice telle qu’elle devrait être
option-entry_sign = un élément de la rotation a le mauvais signe
option-sine_for_cosine = dans un élément de la rotation, sinus et cosinus sont échangés
option-position_sign = un élément de la position a le mauvais signe
option-position_missing = un élément de la position manque
option-position_sine_for_cosine = dans un élément de la position, sinus et cosinus sont échangés
option-rotation_transposed = la rotation est transposée
option-matrix_other_convention = elle a été formée dans l’autre convention
option-link_missing = un segment a été oublié dans le produit
given-matrix-with-mistake =
    { $matrix ->
        [link] La matrice de la ligne { $row }, avec une erreur
       *[transform] ⁰T_N, avec une erreur
    }

task-matrix-mistake =
    { $matrix ->
        [link] Le tableau est juste. Quelqu’un a écrit la matrice de sa ligne { $row }, du repère { $row } au précédent, et a fait une erreur.
       *[transform] Le tableau est juste. Quelqu’un a écrit ⁰T_N, le produit de toutes ses matrices, et a fait une erreur.
    } Donnez un élément faux, dites ce qui ne va pas et écrivez la matrice entière telle qu’elle devrait être.

feedback-matrix_mistake_place_wrong = Cet élément est juste ; l’erreur est ailleurs.
feedback-matrix_mistake_name_wrong = L’erreur est d’un autre genre.
feedback-matrix_not_mended = Ce n’est pas encore la matrice du tableau.
feedback-matrix_mistake_missing =
    { $what ->
        [cell_row] Donnez la ligne et la colonne d’un élément faux.
        [mistake] Dites ce qui est faux.
       *[mended_matrix] Écrivez la matrice telle qu’elle devrait être.
    }
