# Placement des repères : règles et refus.

rule-z_not_along_axis = z doit être porté par l’axe { $axis }, car l’articulation { $axis } tourne autour de ce z ou glisse le long de lui.
rule-origin_not_on_axis = L’origine doit se trouver sur l’axe { $axis }, car z de ce repère est porté par lui.
rule-origin_not_on_common_normal = L’origine doit être au point où la perpendiculaire commune aux axes { $first } et { $second } rencontre l’axe de ce repère, car a se mesure sur celle-ci.
rule-origin_not_at_intersection = Les axes { $first } et { $second } se coupent : l’origine se place à leur point d’intersection, car a y est nulle.
rule-x_not_across_z = x doit être perpendiculaire à z, car les axes d’un repère sont perpendiculaires.
rule-x_not_along_common_normal = x doit être porté par la perpendiculaire commune aux axes { $first } et { $second }, car a se mesure le long de x et c’est la plus courte distance entre les axes.
rule-x_not_across_both_axes = x doit être perpendiculaire aux deux axes { $first } et { $second }, car α amène l’un sur l’autre par rotation autour de x.
rule-first_x_misses_axis = x du premier repère doit couper l’axe { $axis } à angle droit, car sa ligne n’a que a et α, le long et autour de x, pour y arriver.
rule-last_x_misses_axis = x du dernier repère doit couper l’axe { $axis } à angle droit, car sa ligne n’a que a et α, le long et autour de x, pour en repartir.
rule-z_reversed = z est opposé au sens positif de l’axe { $axis }. C’est permis ; la variable articulaire entre alors avec le signe moins.
rule-x_reversed = x va de l’axe { $second } vers l’axe { $first }. C’est permis ; la longueur du segment devient alors négative.
rule-offset_could_vanish = Avec une autre origine sur cet axe, d{ $joint } serait nul.
rule-angle_could_vanish = Avec une autre direction de x, θ{ $joint } serait nul.
rule-first_not_simplest = Le repère 0 pourrait être placé de façon à annuler plus de paramètres.
rule-last_not_simplest = Le dernier repère pourrait être placé de façon à annuler plus de paramètres.

error-axes_wrong_number = Une chaîne a de 1 à { $limit } axes ; celle-ci en a { $count }.
error-axis_joint_unknown = L’articulation d’un axe est rotoïde (revolute) ou prismatique (prismatic).
error-gripper_jaws_along_approach = Les mors glissent en travers de la direction d’approche, non le long de celle-ci.
error-vector_malformed = Donnez trois nombres finis x, y, z, aucun plus grand que { $limit }.
error-direction_zero = Une direction a besoin d’une longueur : 0, 0, 0 ne pointe nulle part.
error-frames_too_many = Une chaîne de { $count ->
    [one] { $count } articulation
   *[other] { $count } articulations
} a les repères 0 à { $count }.
error-frame_y_not_z_cross_x = y découle de z et de x. Ne le donnez pas, ou donnez z × x à côté des deux.
error-parallel_tolerance_out_of_range = La tolérance pour les axes parallèles est comprise entre { $least } et { $greatest } rad.
error-near_parallel = Les axes { $previous } et { $joint } sont parallèles à { $angle } rad près et ont été pris comme parallèles. Le dernier repère peut en être tourné du double de cet angle au plus et déplacé d’au plus { $displacement }.
error-near_parallel_dummy_row = Les axes { $previous } et { $joint } sont parallèles à { $angle } rad près ; une ligne fixe entre eux garde le tableau exact.
error-base_not_frame_zero_standard = Le repère 0 d’un tableau standard a z sur l’axe 1 et son origine sur celui-ci ; ce n’est pas le cas du repère donné, qui n’est donc atteint que par la transformation de base.
error-base_not_frame_zero_modified = Le repère 0 d’un tableau modifié a un axe x qui coupe l’axe 1 à angle droit ; ce n’est pas le cas du repère donné, qui n’est donc atteint que par la transformation de base.
error-tool_not_last_frame_standard = Le dernier repère d’un tableau standard a un axe x qui coupe le dernier axe à angle droit ; ce n’est pas le cas de l’outil donné, qui n’est donc atteint que par la transformation d’outil.
error-tool_not_last_frame_modified = Le dernier repère d’un tableau modifié a z sur le dernier axe et son origine sur celui-ci ; ce n’est pas le cas de l’outil donné, qui n’est donc atteint que par la transformation d’outil.
