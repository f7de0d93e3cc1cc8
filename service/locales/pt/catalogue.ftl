# Ficheiros do catálogo de robôs.

error-catalogue_not_toml = Isto não é TOML: { $reason }.
error-catalogue_key_missing = Falta { $key }.
error-catalogue_key_unknown = { $key } não significa nada aqui. As chaves conhecidas são { $known }.
error-catalogue_value_type = { $key } deve ser { $expected }.
error-catalogue_limits_reversed = Junta { $joint }: o limite inferior deve ficar abaixo do superior.
error-catalogue_outside_limits = A junta { $joint } desta configuração está fora dos limites.
error-robot_unknown = O catálogo não contém o robô { $robot }. Contém { $known }.
