# Fichiers du catalogue de robots.

error-catalogue_not_toml = Ce n’est pas du TOML : { $reason }.
error-catalogue_key_missing = { $key } manque.
error-catalogue_key_unknown = { $key } ne signifie rien ici. Les clés connues sont { $known }.
error-catalogue_value_type = { $key } doit être { $expected }.
error-catalogue_limits_reversed = Articulation { $joint } : la limite inférieure doit être en dessous de la limite supérieure.
error-catalogue_outside_limits = L’articulation { $joint } de cette configuration sort de ses limites.
error-robot_unknown = Le catalogue ne contient pas de robot { $robot }. Il contient { $known }.
