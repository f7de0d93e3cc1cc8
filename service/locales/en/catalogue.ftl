# Files of the robot catalogue.

error-catalogue_not_toml = This is not TOML: { $reason }.
error-catalogue_key_missing = { $key } is missing.
error-catalogue_key_unknown = { $key } means nothing here. Known keys are { $known }.
error-catalogue_value_type = { $key } must be { $expected }.
error-catalogue_limits_reversed = Joint { $joint }: the lower limit must be below the upper one.
error-catalogue_outside_limits = Joint { $joint } of this configuration is outside its limits.
error-robot_unknown = The catalogue holds no robot { $robot }. It holds { $known }.
