# Файли каталогу роботів.

error-catalogue_not_toml = Це не TOML: { $reason }.
error-catalogue_key_missing = Бракує { $key }.
error-catalogue_key_unknown = { $key } тут нічого не означає. Відомі ключі: { $known }.
error-catalogue_value_type = Значення { $key } має бути таким: { $expected }.
error-catalogue_limits_reversed = Зчленування { $joint }: нижня межа має бути меншою за верхню.
error-catalogue_outside_limits = Зчленування { $joint } у цій конфігурації виходить за межі.
error-robot_unknown = У каталозі немає робота { $robot }. Є такі: { $known }.
