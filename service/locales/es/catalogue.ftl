# Archivos del catálogo de robots.

error-catalogue_not_toml = Esto no es TOML: { $reason }.
error-catalogue_key_missing = Falta { $key }.
error-catalogue_key_unknown = { $key } no significa nada aquí. Las claves conocidas son { $known }.
error-catalogue_value_type = { $key } debe ser { $expected }.
error-catalogue_limits_reversed = Articulación { $joint }: el límite inferior debe estar por debajo del superior.
error-catalogue_outside_limits = La articulación { $joint } de esta configuración está fuera de sus límites.
error-robot_unknown = El catálogo no contiene el robot { $robot }. Contiene { $known }.
