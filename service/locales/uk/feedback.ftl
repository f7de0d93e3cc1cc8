# Що перевірка каже про таблицю: правильну, хибну, і що її виправило б.

## Правильна відповідь і як її системи розташовані щодо еталонного розв’язку

feedback-same_frames = Ваші системи координат — такі самі, як в еталонному розв’язку.
feedback-other_convention = Вашу таблицю записано { $convention ->
    [modified] в модифікованій угоді, а еталонний розв’язок — у стандартній
   *[standard] у стандартній угоді, а еталонний розв’язок — у модифікованій
}; обидва описують того самого робота.
feedback-axis_reversed = Ваша вісь z{ $frame }, вісь зчленування { $joint }, спрямована протилежно до еталонного розв’язку. Обидва напрями правильні, і знаки у вашій таблиці відповідають вашому вибору.
feedback-end_axis_reversed = Ваша вісь z{ $frame } спрямована протилежно до еталонного розв’язку. Обидва напрями правильні.
feedback-x_turned = Вашу вісь x{ $frame } повернуто на { $degrees }° навколо z{ $frame } щодо еталонного розв’язку. Ваша таблиця це враховує.
feedback-origin_slid = Початок вашої системи { $frame } лежить в іншому місці осі z{ $frame }, ніж в еталонному розв’язку. Тут правильне будь-яке місце.
feedback-axis_moved = Ваша вісь z{ $frame } лежить на іншій прямій, паралельній до еталонної. Тут важливий лише її напрям.
feedback-frame_elsewhere = Вашу систему { $frame } розташовано інакше, ніж в еталонному розв’язку. Її вибір був вільним.
feedback-variable_reversed = Ваша змінна q{ $joint } відлічується в протилежний бік, ніж в еталонному розв’язку. Обидва напрями правильні.
feedback-variable_offset = Там, де q{ $joint } еталонного розв’язку дорівнює нулю, ваша має значення { $offset }. Нуль змінної зчленування обирають вільно.
feedback-rounded = Ваші значення збігаються з еталонним розв’язком у межах допуску, але не точно; можливо, їх округлено.

## Хибна відповідь: загалом

feedback-not_equivalent = Ваша таблиця не описує цього робота, хоч би як було обрано системи координат.
feedback-right_robot = Ваша таблиця описує потрібного робота, але не дотримано всього, що вимагає вправа.
feedback-not_accepted = У вашій таблиці не дотримано всього, що вимагає вправа.
feedback-convention_not_asked = Вправа вимагає { $asked ->
    [modified] модифікованої
   *[standard] стандартної
} угоди; вашу таблицю записано { $given ->
    [modified] в модифікованій
   *[standard] у стандартній
}.
feedback-joint_count_wrong = { $given ->
    [0] У вашій таблиці немає зчленувань
    [one] У вашій таблиці { $given } зчленування
    [few] У вашій таблиці { $given } зчленування
   *[other] У вашій таблиці { $given } зчленувань
}; у робота їх { $asked }.
feedback-mirrored = Ваша таблиця описує дзеркальне відображення робота: усі довжини й кути відповідні, але щось із них відлічено в інший бік. Перевірте знаки за правилом правої руки.
feedback-entries_imprecise = Жодна довжина і жоден кут у вашій таблиці не відхиляються більше, ніж пояснює округлення, але всі округлення разом перевищують допуск вправи. Записуйте кути точно, як pi/2 або 90°, а довжини — з більшою кількістю знаків.
feedback-lengths_rounded = Кілька довжин у вашій таблиці мають правильне значення, але замало знаків. Запишіть їх із більшою кількістю знаків; решта зазначеного тут — окремі помилки.
feedback-base_axis_missed = Ваша вісь z0 не лежить на осі зчленування 1.
feedback-base_origin_missed = Початок вашої системи 0 не там, де вимагає вправа.
feedback-base_frame_missed = Ваша система 0 — не та, яку задає вправа.
feedback-tool_point_missed = Початок вашої останньої системи не в позначеній точці.
feedback-tool_axis_missed = Вісь z вашої останньої системи не лежить на осі останнього зчленування.
feedback-tool_frame_missed = Ваша остання система — не та, яку задає вправа.
feedback-zero_missed = У конфігурації на рисунку всі змінні зчленувань мають дорівнювати нулю; ваші — ні.
feedback-direction_missed = Змінні зчленувань мають зростати в напрямі стрілок на рисунку; у вас це не для всіх так.
feedback-whole_table = Одна й та сама помилка повторюється в усій таблиці.
feedback-columns_throughout = Стовпці a та α не відповідають угоді, яку зазначено в таблиці.
feedback-columns_in_disorder = Стовпці таблиці стоять в іншому порядку.
feedback-angles_throughout = Кути в таблиці — не в тих одиницях, які зазначено.
feedback-lengths_throughout = Довжини в таблиці — не в тих одиницях, які зазначено.
feedback-turns_throughout = Кути зчленувань усюди відлічено не в той бік.
feedback-twists_throughout = Кути α усюди мають хибний знак.
feedback-twists_out_of_place = Кути α в таблиці стоять не в тих рядках, до яких належать.
feedback-names_throughout = Один із розмірів у вашій таблиці названо хибно.
feedback-parameter_unknown = У робота немає розміру з назвою { $name }. Його розміри: { $known }.
feedback-names_asked = Розміри робота тут не мають числових значень. Пишіть їхні назви: { $known }.

## Хибна відповідь: рядки

feedback-one_of_these = Помилкою є лише одне з наведеного далі; сама таблиця не показує, що саме.
feedback-row_wrong = Рядок { $row } неправильний.
feedback-twist_wrong = Рядок { $row }: кут скручення α від z{ $before } до z{ $row } неправильний.
feedback-length_wrong = Рядок { $row }: довжина a, відстань від z{ $before } до z{ $row }, неправильна.
feedback-offset_wrong = Рядок { $row }: зміщення d, відстань від x{ $before } до x{ $row } уздовж z, неправильне.
feedback-angle_wrong = Рядок { $row }: кут θ від x{ $before } до x{ $row } навколо z неправильний.
feedback-sign_wrong = Рядок { $row }: один знак протилежний. Перевірте: { $cells }.
feedback-joint_type_wrong = Рядок { $row }: тип зчленування неправильний.
feedback-variable_zero_wrong = Рядок { $row }: у конфігурації на рисунку змінна зчленування не дорівнює нулю.
feedback-variable_direction_wrong = Рядок { $row }: змінна зчленування зростає проти стрілки на рисунку.
feedback-row_missing = Бракує рядка { $after ->
    [0] перед рядком 1
   *[other] після рядка { $after }
}.
feedback-row_not_needed = Рядок { $row } зайвий.
feedback-rows_out_of_order = Рядки { $row } і { $other } стоять не в тому порядку.

## Що зробило б її правильною

repair-convention = Якщо читати вашу таблицю { $meant ->
    [modified] в модифікованій
   *[standard] у стандартній
} угоді, вона правильна; зазначено ж { $declared ->
    [modified] модифіковану
   *[standard] стандартну
}.
repair-angles_in_degrees = Кути подано в градусах, а в таблиці зазначено радіани.
repair-angles_in_radians = Кути подано в радіанах, а в таблиці зазначено градуси.
repair-length_unit = Довжини подано не в тих одиницях, які зазначено: наприклад, у міліметрах замість метрів.
repair-columns_late = Стовпці a та α стоять на рядок нижче, ніж слід, як в іншій угоді. Якої ланки стосується кожен рядок?
repair-columns_early = Стовпці a та α стоять на рядок вище, ніж слід, як в іншій угоді. Якої ланки стосується кожен рядок?
repair-twists_late = Стовпець α стоїть на рядок нижче, ніж слід; a стоїть на своєму місці. В одному рядку a та α стосуються тієї самої ланки.
repair-twists_early = Стовпець α стоїть на рядок вище, ніж слід; a стоїть на своєму місці. В одному рядку a та α стосуються тієї самої ланки.
repair-columns_exchanged = Стовпці { $one } та { $other } переставлено місцями. Порівняйте порядок стовпців із тим, що в конспекті.
repair-columns_reordered = Те, що стоїть під α, належить до { $alpha }, те, що під a, — до { $a }, а те, що під d, — до { $d }. Порівняйте порядок стовпців із тим, що в конспекті.
repair-parameter_misnamed = { $name } — не розмір цього робота. Який розмір на рисунку ви маєте на увазі?
repair-parameters_swapped = { $name } і { $other } переставлено. Порівняйте їх із рисунком.
repair-alpha_sign = Рядок { $row }: α має хибний знак. Повертайте z{ $before } до z{ $row } навколо x за правилом правої руки.
repair-alpha_value = Рядок { $row }: α має неправильне значення. Погляньте ще раз, як розташовані осі z{ $before } та z{ $row } одна щодо одної.
repair-turns_all_reversed = Усі кути зчленувань відлічено не в той бік. Відлічуйте їх навколо z за правилом правої, а не лівої руки.
repair-twists_all_reversed = Усі α мають хибний знак. Повертайте одну вісь z до наступної навколо x за правилом правої, а не лівої руки.
repair-a_sign = Рядок { $row }: a має хибний знак. Її відлічують у напрямі x.
repair-d_sign = Рядок { $row }: d має хибний знак. Його відлічують у напрямі z.
repair-twists_swapped = Рядки { $row } і { $other }: значення α помінялися місцями.
repair-a_d_swapped = Рядок { $row }: a та d помінялися місцями. a вимірюють уздовж x, d — уздовж z.
repair-a_value = Рядок { $row }: a має неправильне значення. Вимірюйте вздовж спільного перпендикуляра до осей z{ $before } та z{ $row }.
repair-a_missing = Рядок { $row }: a не має бути нулем, бо осі z{ $before } та z{ $row } не перетинаються.
repair-a_not_zero = Рядок { $row }: a має бути нулем, бо осі z{ $before } та z{ $row } перетинаються або збігаються.
repair-d_value = Рядок { $row }: d має неправильне значення. Вимірюйте вздовж z, від x{ $before } до x{ $row }.
repair-d_missing = Рядок { $row }: пропущено зміщення d уздовж z, від x{ $before } до x{ $row }.
repair-d_not_zero = Рядок { $row }: d має бути нулем, бо осі x{ $before } та x{ $row } перетинають вісь z в одній точці.
repair-cell_length_unit = Рядок { $row }: одну довжину подано в інших одиницях, ніж решту.
repair-cell_parameter = Рядок { $row }: тут має стояти інший розмір із рисунка.
repair-cell_in_degrees = Рядок { $row }: один кут подано в градусах, а в таблиці зазначено радіани.
repair-cell_in_radians = Рядок { $row }: один кут подано в радіанах, а в таблиці зазначено градуси.
repair-theta_value = Рядок { $row }: сталий кут θ має неправильне значення. Повертайте x{ $before } до x{ $row } навколо z.
repair-theta_offset = Рядок { $row }: у θ до змінної треба додати іншу сталу, щоб у конфігурації на рисунку змінна дорівнювала нулю.
repair-d_offset = Рядок { $row }: у d до змінної треба додати іншу сталу, щоб у конфігурації на рисунку змінна дорівнювала нулю.
repair-variable_sign = Рядок { $row }: змінну зчленування відлічено не в той бік. Поставте протилежний знак.
repair-joint_type = Рядок { $row }: це зчленування { $joint_type ->
    [prismatic] поступальне; його змінна стоїть у стовпці d
   *[revolute] обертальне; його змінна стоїть у стовпці θ
}.
repair-joint_fixed = Рядок { $row }: це зчленування рухоме; його змінної бракує.
repair-joint_moving = Рядок { $row }: тут нічого не рухається; у рядку мають бути лише сталі.
repair-rows_swapped = Рядки { $row } і { $other } помінялися місцями.
repair-fixed_row_missing = Бракує останнього рядка без змінної: він веде від останнього зчленування до позначеної точки або до заданої останньої системи.
repair-row_missing = Бракує рядка { $after ->
    [0] перед рядком 1
   *[other] після рядка { $after }
}.
repair-row_extra = Рядок { $row } зайвий.

## Відхилено

error-tables_without_value = Не знайдено значень параметрів, за яких кожна клітинка обох таблиць має значення. Перевірте корені, частки та обернені функції.

feedback-frame_wrong = Система { $frame } порушує правило.
feedback-frame_missing = Систему { $frame } не розміщено.
feedback-frame_z_not_along_axis = Система { $frame }: { rule-z_not_along_axis }
feedback-frame_origin_not_on_axis = Система { $frame }: { rule-origin_not_on_axis }
feedback-frame_origin_not_on_common_normal = Система { $frame }: { rule-origin_not_on_common_normal }
feedback-frame_origin_not_at_intersection = Система { $frame }: { rule-origin_not_at_intersection }
feedback-frame_x_not_across_z = Система { $frame }: { rule-x_not_across_z }
feedback-frame_x_not_along_common_normal = Система { $frame }: { rule-x_not_along_common_normal }
feedback-frame_x_not_across_both_axes = Система { $frame }: { rule-x_not_across_both_axes }
feedback-frame_first_x_misses_axis = Система { $frame }: { rule-first_x_misses_axis }
feedback-frame_last_x_misses_axis = Система { $frame }: { rule-last_x_misses_axis }
feedback-frames_other_convention = Ці системи координат відповідають правилам іншої угоди.
feedback-frames_not_as_asked = Системи координат відповідають правилам, але розміщені не так, як просить вправа.
feedback-frames_right = Системи координат правильні.
feedback-repairs_one_cell = Кожна з кількох змін виправила б таблицю; усі вони в клітинці { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
} рядка { $row }.
feedback-repairs_one_row = Кожна з кількох змін виправила б таблицю; усі вони в рядку { $row }.
feedback-repairs_one_column = Кожна з кількох змін виправила б таблицю; усі вони в стовпці { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
}.
feedback-repairs_one_kind = Кожна зі змін (усього { $count }) виправила б таблицю; усі вони одного виду.
