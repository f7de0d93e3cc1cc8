# Файли каталогу роботів.

error-catalogue_not_toml = Це не TOML: { $reason }.
error-catalogue_key_missing = Бракує { $key }.
error-catalogue_key_unknown = { $key } — невідомий ключ. Відомі ключі: { $known }.
error-catalogue_value_type = Значення { $key } має бути таким: { expected-value }.
error-catalogue_limits_reversed = Зчленування { $joint }: нижня межа має бути меншою за верхню.
error-catalogue_outside_limits = Зчленування { $joint } у цій конфігурації виходить за межі.
error-robot_unknown = У каталозі немає робота { $robot }. Є такі: { $known }.
expected-value = { $expected ->
    [text] непорожній текст
    [texts] список текстів
    [number] число, модуль якого не перевищує 10^15
    [integer] ціле число
    [count] ціле число, не менше за 1
    [flag] true або false
    [table] таблиця
    [tables] список таблиць
    [cell] число або вираз
    [cells] список чисел або виразів завдовжки { $count }
    [choice] одне з таких: { $known }
    [direction] список трьох чисел, не всі з яких нулі
    [point_names] список назв точок завдовжки { $count }
    [point_chains] список списків щонайменше з двох назв точок
    [help_levels] список щонайменше з одного рівня допомоги
    [numbers] { $count ->
        [0] список скінченних чисел
       *[other] список скінченних чисел завдовжки { $count }
    }
    [rows] { $count ->
        [0] список списків по { $width } елементів
       *[other] список завдовжки { $count } зі списків по { $width } елементів
    }
   *[other] іншого типу
}
