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
        [link] Le tableau est juste. Quelqu’un a écrit la matrice de sa ligne { $row }, pose du repère { $row } dans le précédent, et a fait une erreur.
       *[transform] Le tableau est juste. Quelqu’un a écrit ⁰T_N, le produit de toutes ses matrices, et a fait une erreur.
    } Donnez un élément faux, dites ce qui ne va pas et écrivez la matrice entière telle qu’elle devrait être.

feedback-matrix_mistake_place_wrong = Cet élément est juste ; l’erreur est ailleurs.
feedback-matrix_mistake_name_wrong = L’erreur est d’un autre type.
feedback-matrix_not_mended = Ce n’est pas encore la matrice du tableau.
feedback-matrix_mistake_missing =
    { $what ->
        [cell_row] Donnez la ligne et la colonne d’un élément faux.
        [mistake] Dites ce qui est faux.
       *[mended_matrix] Écrivez la matrice telle qu’elle devrait être.
    }

field-wrong_frame = Repère contenant l’erreur
field-mended_origin = Son origine telle qu’elle devrait être
field-mended_x = Son axe x tel qu’il devrait être
field-mended_y = Son axe y tel qu’il devrait être
field-mended_z = Son axe z tel qu’il devrait être
option-z_not_along_axis = z ne suit pas l’axe de son articulation
option-origin_not_on_axis = l’origine n’est pas sur l’axe de son articulation
option-origin_not_on_common_normal = l’origine n’est pas sur la perpendiculaire commune
option-origin_not_at_intersection = l’origine n’est pas au point où les deux axes se coupent
option-x_not_across_z = x n’est pas perpendiculaire à z
option-x_not_along_common_normal = x ne suit pas la perpendiculaire commune
option-x_not_across_both_axes = x n’est pas perpendiculaire aux deux axes
option-first_x_misses_axis = x du premier repère ne coupe pas l’axe 1 à angle droit
option-last_x_misses_axis = x du dernier repère ne coupe pas le dernier axe à angle droit
option-y_left_handed = le repère est indirect : y n’est pas z × x
given-drawn-frames = Les repères tels qu’ils sont dessinés

task-frame-mistake =
    { $convention ->
        [standard] Les repères de la figure devraient suivre la convention standard, z du repère i le long de l’articulation i+1
       *[modified] Les repères de la figure devraient suivre la convention modifiée, z du repère i le long de l’articulation i
    }, mais l’un d’eux contient une erreur. Quel repère est faux, qu’a-t-il de faux et comment devrait-il être placé ? Points et directions sont donnés dans les coordonnées de la figure ; la longueur d’une direction est libre. { figure-place }

feedback-frame_mistake_place_wrong = Ce repère est juste ; l’erreur est dans un autre.
feedback-frame_mistake_name_wrong = L’erreur est d’un autre type.
feedback-frame_not_mended = Avec ce repère, le dessin enfreint encore une règle.
feedback-frame_mistake_missing =
    { $what ->
        [wrong_frame] Dites quel repère est faux.
        [mistake] Dites ce qui est faux.
       *[mended_origin] Donnez l’origine, x, y et z tels qu’ils devraient être.
    }
