# Fichiers du catalogue de robots.

error-catalogue_not_toml = Ce n’est pas du TOML : { $reason }.
error-catalogue_key_missing = Il manque { $key }.
error-catalogue_key_unknown = { $key } n’est pas une clé connue. Les clés connues sont { $known }.
error-catalogue_value_type = { $key } doit être { expected-value }.
error-catalogue_limits_reversed = Articulation { $joint } : la limite inférieure doit être plus petite que la limite supérieure.
error-catalogue_outside_limits = L’articulation { $joint } de cette configuration sort de ses limites.
error-robot_unknown = Le catalogue ne contient pas de robot { $robot }. Il contient { $known }.
expected-value = { $expected ->
    [text] un texte non vide
    [texts] une liste de textes
    [number] un nombre dont la valeur absolue est au plus 10^15
    [integer] un nombre entier
    [count] un nombre entier d’au moins 1
    [flag] true ou false
    [table] une table
    [tables] une liste de tables
    [cell] un nombre ou une expression
    [cells] une liste de { $count } nombres ou expressions
    [choice] l’une de ces valeurs : { $known }
    [direction] une liste de trois nombres non tous nuls
    [point_names] une liste de { $count } noms de points
    [point_chains] une liste de listes d’au moins deux noms de points
    [help_levels] une liste d’au moins un niveau d’aide
    [numbers] { $count ->
        [0] une liste de nombres finis
       *[other] une liste de { $count } nombres finis
    }
    [rows] { $count ->
        [0] une liste de listes de { $width } éléments
       *[other] une liste de { $count } listes de { $width } éléments
    }
   *[other] d’un autre type
}
