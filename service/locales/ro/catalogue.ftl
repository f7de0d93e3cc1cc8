# Fișierele catalogului de roboți.

error-catalogue_not_toml = Fișierul nu este TOML: { $reason }.
error-catalogue_key_missing = Lipsește { $key }.
error-catalogue_key_unknown = { $key } nu înseamnă nimic aici. Cheile cunoscute sunt { $known }.
error-catalogue_value_type = { $key } trebuie să fie { $expected }.
error-catalogue_limits_reversed = Cupla { $joint }: limita de jos trebuie să fie sub cea de sus.
error-catalogue_outside_limits = Cupla { $joint } a acestei configurații iese din limite.
error-robot_unknown = Catalogul nu conține robotul { $robot }. Conține { $known }.
