# URDF et espace de travail.

error-urdf_not_xml = Le texte n’est pas du XML bien formé : ligne { $line }, colonne { $column }.
error-urdf_unsafe = Un URDF n’a ni type de document ni entités et ne renvoie à aucun autre fichier. Retirez <!DOCTYPE …>.
error-urdf_too_long = La description compte plus de { $limit } caractères.
error-urdf_too_complex = La description a plus de { $depth } niveaux ou plus de { $elements } éléments.
error-urdf_no_robot = L’élément racine est <{ $found }> ; un URDF commence par <robot>.
error-urdf_is_xacro = Ceci est du xacro, un langage de macros. Développez-le d’abord : xacro robot.xacro > robot.urdf
error-urdf_no_links = La description n’a pas de segments (link).
error-urdf_name_missing = Un élément <{ $element }> n’a pas de nom.
error-urdf_name_twice = Deux éléments <{ $element }> s’appellent « { $name } ».
error-urdf_name_invalid = Un nom est une ligne de caractères visibles.
error-urdf_joint_incomplete = Il manque <{ $element } link="…"/> à l’articulation « { $joint } ».
error-urdf_link_missing = L’articulation « { $joint } » nomme le segment « { $link } », que la description n’a pas.
error-urdf_link_unknown = La description n’a pas de segment « { $link } » ; elle a { $known }.
error-urdf_links_alike = Le premier segment et le dernier doivent porter des noms différents ; tous deux étaient « { $link } ».
error-urdf_two_parents = Le segment « { $link } » est l’enfant de deux articulations, « { $first } » et « { $second } ». Chaque segment a un seul parent.
error-urdf_ring = Les segments forment une boucle passant par « { $link } ». Une description est un arbre.
error-urdf_base_needed = Segments sans parent : { $count }. Indiquez-en un comme base_link : { $links }.
error-urdf_tip_needed = La description se ramifie ; extrémités : { $count }. Indiquez-en une comme tip_link : { $links }.
error-urdf_no_path = Aucune suite d’articulations ne mène du segment « { $base } » au segment « { $tip } ».
error-urdf_nothing_moves = Rien ne bouge entre le segment « { $base } » et le segment « { $tip } ».
error-urdf_too_many_joints = La chaîne a { $count } articulations mobiles ; un tableau en prend au plus { $limit }.
error-urdf_several_freedoms = L’articulation « { $joint } » est de type { $kind } : elle a plusieurs degrés de liberté, une ligne du tableau DH n’en a qu’un.
error-urdf_type_unknown = L’articulation « { $joint } » est du type « { $kind } » ; les types connus sont { $known }.
error-urdf_mimic = L’articulation « { $joint } » bouge avec « { $other } » et toutes deux sont dans la chaîne ; dans un tableau DH, chaque articulation a sa propre variable.
error-urdf_mimic_unknown = L’articulation « { $joint } » imite « { $other } », qui n’est pas une articulation de la description.
error-urdf_mimic_circle = L’articulation « { $joint } » ne suit aucun mouvement : ce qu’elle imite mène à un cercle ({ $circle }).
error-urdf_attribute_unknown = Articulation « { $joint } » : <{ $element }> n’a pas d’attribut « { $attribute } » ; il prend { $known }.
error-urdf_element_twice = L’articulation « { $joint } » a plusieurs éléments <{ $element }> différents. N’en gardez qu’un.
error-urdf_two_orientations = L’articulation « { $joint } » donne deux fois son orientation, par rpy et par quat_xyzw. N’en gardez qu’une.
error-urdf_quaternion_zero = Le quaternion de l’articulation « { $joint } » est 0 0 0 0, ce qui n’est pas une orientation.
error-urdf_joint_names = Un robot à { $expected ->
    [one] { $expected } articulation
   *[other] { $expected } articulations
} prend autant de noms, tous différents et aucun n’étant fixed_base, fixed_tool ou fixed_row_… ; noms donnés : { $given }.
error-urdf_link_names = Un robot à { $expected ->
    [one] { $expected } articulation
   *[other] { $expected } articulations
} prend autant de noms de segments, un pour ce que porte chaque articulation, tous différents ; noms donnés : { $given }.
error-urdf_axis_zero = L’axe de l’articulation « { $joint } » est 0 0 0 et n’a pas de direction.
error-urdf_limits_reversed = La limite inférieure de l’articulation « { $joint } » est plus grande que la limite supérieure.
error-urdf_numbers_malformed = Articulation « { $joint } » : { $attribute } dans <{ $element }> prend { $count ->
        [1] un nombre fini
       *[other] { $count } nombres finis séparés par des espaces
    }, aucun plus grand que { $limit }.
error-urdf_limit_malformed = Articulation « { $joint } » : { $attribute } dans <limit> prend un nombre. Écrivez inf si l’articulation n’a pas de limite.
error-urdf_limit_overflow = Une limite dans un URDF ne dépasse pas { $limit } (rad ou m) en valeur absolue. Indiquez null s’il n’y en a pas.
error-urdf_length_overflow = Les longueurs d’un URDF ne doivent pas dépasser { $limit_in_metres } m.
error-option_idle = Omettez { $found } : cette conversion ne s’en sert pas.

error-workspace_without_joints = Rien ne bouge : un espace de travail demande une ligne rotoïde ou prismatique.
error-slide_without_limits = L’articulation { $joint } coulisse : sans valeur minimale et maximale, l’espace de travail est illimité.
