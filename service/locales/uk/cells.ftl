# Чому відхилено клітинку, таблицю або параметр.

error-cell_empty = Ця клітинка порожня. Якщо значення дорівнює нулю, напишіть 0.
error-cell_dash = У цій клітинці немає значення. Якщо значення дорівнює нулю, напишіть 0.
error-cell_not_a_value =
    Клітинка містить число або вираз у вигляді тексту, а не { $kind ->
        [list] список
        [dict] об’єкт
       *[other] { $kind }
    }.
error-cell_too_long =
    У цій клітинці { $length ->
        [one] { $length } символ
        [few] { $length } символи
       *[other] { $length } символів
    }; читається щонайбільше { $limit }.
error-cell_too_deep =
    Вкладеність у цій клітинці перевищує { $limit ->
        [one] { $limit } рівень
        [few] { $limit } рівні
       *[other] { $limit } рівнів
    }.
error-cell_too_many_symbols =
    У цій клітинці понад { $limit ->
        [one] { $limit } ім’я
        [few] { $limit } різні імена
       *[other] { $limit } різних імен
    }.

error-character_not_allowed = Символ { $column }: { $character } не має змісту в клітинці.
error-character_invisible = Символ { $column }: тут невидимий або керівний символ ({ $character }). Вилучіть його.
error-character_lookalike = Символ { $column }: { $character } лише схожий на латинську літеру { $latin }. Введіть латинську { $latin }.
error-character_full_width = Символ { $column }: { $character } — символ подвійної ширини. Введіть { $latin }.
error-dollar_misplaced = Символ { $column }: знаки $ можуть лише охоплювати всю клітинку.
error-command_unknown = Символ { $column }: команда \{ $command } незрозуміла.
error-script_misplaced = Символ { $column }: перед { $character } немає нічого, чого він міг би стосуватися.

error-number_malformed = Символ { $column }: { $text } не є десятковим числом. Пишіть цифри й одну крапку, без роздільників.
error-number_too_long =
    Символ { $column }: число може мати щонайбільше { $limit ->
        [one] { $limit } цифру
        [few] { $limit } цифри
       *[other] { $limit } цифр
    }.
error-number_out_of_range =
    { $size ->
        [small] Символ { $column }: це число надто близьке до 0, щоб його прочитати. Напишіть 0.
       *[large] Символ { $column }: модуль числа не перевищує { $largest }.
    }
error-cell_not_finite = Клітинка містить лише скінченні числа; NaN і нескінченність не приймаються.
error-decimal_comma = Символ { $column }: замість коми пишіть десяткову крапку: { $suggestion }.
error-minutes_in_cell = Символ { $column }: кутові мінути й секунди не читаються. Десятковим дробом { $text } — це { $suggestion }.
error-about_in_cell = Символ { $column }: клітинка містить саме значення, без { $character }. Пишіть { $suggestion }.

error-names_run_together = Символ { $column }: { $text } зливається з наступним. Пишіть добуток через *.
error-name_malformed = Символ { $column }: підкреслення стоїть лише між літерою та її індексом, як у L_1.
error-name_too_long =
    Символ { $column }: ім’я може мати щонайбільше { $limit ->
        [one] { $limit } символ
        [few] { $limit } символи
       *[other] { $limit } символів
    }.
error-name_is_not_a_number = Символ { $column }: { $name } не є значенням. Клітинка містить лише скінченні числа.
error-unit_in_cell = Символ { $column }: одиниці в клітинках не пишуть. Якщо потрібні саме ці одиниці ({ $name }), напишіть { $suggestion }; якщо ні, спершу перетворіть.
error-function_unknown = Символ { $column }: { $name } не є функцією. Є такі функції: { $functions }. Добуток пишуть { $name }*(…).
error-function_without_parentheses =
    Символ { $column }: пишіть аргумент { $name } у дужках: { $name }({ $name ->
        [atan2] y, x
        [arctan2] y, x
       *[other] x
    }).
error-function_arity = Символ { $column }: кількість аргументів { $name } має бути { $expected }, а не { $given }.

error-value_missing = Символ { $column }: перед { $symbol } бракує значення.
error-cell_incomplete = Символ { $column }: клітинка закінчується там, де мало б бути значення.
error-symbol_misplaced = Символ { $column }: { $symbol } не може тут стояти.
error-comma_misplaced = Символ { $column }: кому ставлять лише між двома аргументами atan2.
error-parenthesis_not_closed = Символ { $column }: цю дужку не закрито.
error-parenthesis_not_opened = Символ { $column }: ця дужка нічого не закриває.
error-number_after_value = Символ { $column }: число не може стояти одразу після значення. Пропущено знак дії?
error-division_ambiguous = Символ { $column }: незрозуміло, на що ділити. Пишіть a/(b*c) або (a/b)*c.
error-exponent_ambiguous = Символ { $column }: { $text } може означати { $number } або { $difference }. Напишіть одне з цих двох.

error-exponent_not_constant = Символ { $column }: показник степеня має бути раціональним числом.
error-exponent_out_of_range = Символ { $column }: показник степеня за модулем щонайбільше { $limit }, його знаменник теж.
error-division_by_zero = Символ { $column }: тут ділення на нуль.
error-value_not_real = Ця клітинка не має скінченного дійсного значення.
error-degree_of_angle = Символ { $column }: знак градуса ставлять після числа; тут уже кут.
error-degree_in_length = Символ { $column }: довжину не вимірюють у градусах.
error-angle_in_length = Символ { $column }: { $name } дає кут у градусах, а це не довжина.
error-angle_product = Символ { $column }: перемножено два кути. Кут можна множити лише на числа.
error-angle_in_denominator = Символ { $column }: тут ділення на кут. Ділити можна лише на числа.
error-angle_power = Символ { $column }: кут не підносять до степеня.
error-parameter_two_kinds =
    Символ { $column }: { $name } тут означає { $kind ->
        [angle] кут
       *[length] довжину
    }, а в іншому місці — { $other ->
        [angle] кут
       *[length] довжину
    }. Візьміть два імені.

error-variable_without_number = Символ { $column }: для { $name } потрібен номер зчленування, як у { $suggestion }.
error-variable_misspelled = Символ { $column }: { $name } не є змінною зчленування. Напишіть { $suggestion } або θ з номером зчленування.
error-variable_called = Символ { $column }: { $name } — змінна зчленування, після неї в дужках нічого не пишуть. Сталу пишіть як доданок: { $name } + ….
error-variable_scaled = Символ { $column }: { $name } помножено на { $factor }. Змінна зчленування входить як +{ $name } або -{ $name }, інакше вона не була б рухом свого зчленування.
error-variable_in_product = Символ { $column }: { $name } помножено на іншу величину. Змінна зчленування входить як +{ $name } або -{ $name } плюс стала.
error-variable_in_denominator = Символ { $column }: { $name } стоїть у знаменнику. Змінна зчленування входить як +{ $name } або -{ $name } плюс стала.
error-variable_in_power = Символ { $column }: { $name } піднесено до степеня. Змінна зчленування входить як +{ $name } або -{ $name } плюс стала.
error-variable_in_function = Символ { $column }: { $name } стоїть усередині функції. Клітинка містить саму змінну зчленування; синуси й косинуси випливають із таблиці.
error-variable_in_constant_cell = Символ { $column }: { $name } стоїть у стовпці { $cell }. Довжина й скручення ланки сталі; змінна зчленування стоїть у стовпці θ (обертальне) або d (поступальне).
error-variable_in_fixed_row = Символ { $column }: { $name } стоїть у рядку, оголошеному нерухомим. Нерухомий рядок не має змінної.
error-variable_in_wrong_cell =
    Символ { $column }: { $name } стоїть у стовпці { $cell }, але змінна { $joint ->
        [prismatic] поступального
       *[revolute] обертального
    } зчленування стоїть у стовпці { $expected }.
error-variable_twice = Символ { $column }: { $name } трапляється вдруге. Кожна змінна стоїть у таблиці один раз.
error-variable_of_other_row = Символ { $column }: { $name } не є змінною цього рядка; його змінна — { $expected }. Якщо приводи двох зчленувань пов’язані, як у { $expected } + { $name }, пишіть лише { $expected }, а значенням цієї змінної беріть суму.
error-variable_numbering_mixed = Символ { $column }: { $name } пронумеровано за рядком, а інші — за зчленуванням. Нумеруйте їх від q1 до q{ $joints } у порядку зчленувань.

error-table_empty = У таблиці немає рядків; потрібен щонайменше один.
error-table_too_many_rows =
    У таблиці { $rows ->
        [one] { $rows } рядок
        [few] { $rows } рядки
       *[other] { $rows } рядків
    }; читається щонайбільше { $limit }.
error-table_too_long =
    Усі клітинки разом мають { $length ->
        [one] { $length } символ
        [few] { $length } символи
       *[other] { $length } символів
    }; читається щонайбільше { $limit }.
error-table_too_many_parameters =
    У таблиці понад { $limit ->
        [one] { $limit } параметр
        [few] { $limit } різні параметри
       *[other] { $limit } різних параметрів
    }.

error-parameter_missing = Параметр { $name } не має значення.
error-parameter_unused = У таблиці немає параметра { $name }.
error-parameter_not_finite = Значення { $name } має бути скінченним числом.
error-parameter_name_invalid = { $name } не є іменем параметра. Ім’я — це слово з індексом, наприклад L1.
error-parameter_given_twice = { $name } і { $other } — той самий параметр. Задайте його значення один раз.
