# Formes littérales.

error-form_too_large = La forme développée demande plus de { $limit } produits de termes. Demandez moins de lignes.
error-closed_form_too_large = Écrite en entier, une matrice compte plus de { $limit } opérations. Demandez moins de lignes, ou une fonction (python, c, matlab et d’autres), qui ne calcule qu’une fois ce qui se répète.
error-closed_form_too_deep = Un élément a trop de niveaux d’imbrication pour un arbre JSON. Demandez du texte ou du LaTeX.
error-computation_out_of_time = Le calcul dure plus de { $seconds } s. Demandez moins de lignes, de parties ou de formats ou, au lieu de formules, des nombres pour des valeurs articulaires données.
error-computation_out_of_memory = Le calcul occupe plus de { $megabytes } Mio de mémoire. Demandez moins de lignes, de parties ou de formats ou, au lieu de formules, des nombres pour des valeurs articulaires données.
error-computation_aborted = Le calcul a été interrompu par un problème du serveur, et non de votre requête. Réessayez dans un instant.
