### Види питань: що потрібно подати і що сказано про відповіді.

field-matrix = Матриця
field-component_order = Порядок компонент кватерніона
field-quaternion = Кватерніон
field-axis = Вісь повороту
field-angle = Кут повороту
field-angles = Трійки кутів
field-middle = За складання рамок: середній кут
field-combination = За складання рамок: яку комбінацію першого й останнього кутів визначено
field-value = Її значення
field-matrix_claim = Ця матриця
field-pose_claim = Ця поза
field-position_claim = Це положення
field-pose = Поза
option-wxyz = w, x, y, z: скаляр перший
option-xyzw = x, y, z, w: скаляр останній
option-sum = сума: перший + останній
option-difference = різниця: перший − останній
option-rotation = є поворотом
option-unit_columns = не є поворотом: довжина стовпця не дорівнює 1
option-perpendicular_columns = не є поворотом: два стовпці не перпендикулярні
option-right_handed = не є поворотом: стовпці утворюють ліву трійку (визначник −1)
given-rotation = Орієнтація як матриця повороту
given-quaternion = Орієнтація як одиничний кватерніон
given-axis_angle = Орієнтація як вісь і кут
given-angles = Орієнтація в кутах
given-matrix = Матриця
given-frame-pose = Поза системи { $end } у системі { $start }

task-orientation =
    { $given ->
        [angles] Систему координат повернуто на три кути навколо { $turning ->
            [fixed] нерухомих
           *[current] поточних
        } осей { $axes } у цьому порядку.
       *[other] Задано орієнтацію системи координат.
    } Подайте її в наведених нижче записах.{ $ask ->
        [every] {" "}Для кутів навколо { $asked_turning ->
            [fixed] нерухомих
           *[current] поточних
        } осей { $asked_axes } потрібні всі трійки: обидві або, за складання рамок, середній кут і те, що визначено з двох інших.
        [one] {" "}Для кутів навколо { $asked_turning ->
            [fixed] нерухомих
           *[current] поточних
        } осей { $asked_axes } досить однієї трійки.
       *[none] {""}
    }
task-rotation-check = Чи є ця матриця поворотом? Якщо ні, вкажіть, яку властивість поворотів порушено.
task-frame-chain = Наведені нижче пози відомі. Запишіть позу системи { $end } у системі { $start } як матрицю 4×4, довжини в { unit-word }.
feedback-orientation_right = Усі записи описують задану орієнтацію.
feedback-orientation_wrong =
    { $notation ->
        [matrix] Матриця не відповідає цій орієнтації.
        [quaternion] Кватерніон не відповідає цій орієнтації.
        [axis_angle] Вісь і кут не відповідають цій орієнтації.
        [angles] Кути не відповідають цій орієнтації.
       *[other] Не всі кути правильні, або наведено не всі.
    }
feedback-orientation_missing =
    { $notation ->
        [matrix] Матриця відсутня.
        [quaternion] Кватерніон відсутній.
        [axis_angle] Вісь і кут відсутні.
       *[other] Кути відсутні.
    }

feedback-rotation_transposed = Це обернений поворот: рядки і стовпці поміняно місцями або напрям обертання змінено на протилежний.
feedback-rotation_order_reversed = Повороти перемножено у зворотному порядку: сплутано нерухомі та поточні осі.
feedback-rotation_degrees = Кут у градусах сприйнято як радіани або навпаки.
feedback-rotation_handedness = Усе обертається в інший бік: це правило лівої руки.
feedback-rotation_half_angle = Цей кватерніон повертає вдвічі далі: потрібні синус і косинус половини кута.
feedback-rotation_component_order = За іншого порядку компонент цей кватерніон був би правильним.
feedback-rotation_not_unit = Норма кватерніона не дорівнює 1.
feedback-rotation_no_axis = Вісь має нульову довжину.
feedback-rotation_solution_missing = Є друга трійка з тією самою орієнтацією.
feedback-rotation_solution_twice = Ваші трійки відрізняються лише повними обертами: це та сама трійка. Є ще одна.
feedback-rotation_family_missing = Це складання рамок: трійок безліч. Укажіть, яку комбінацію першого й останнього кутів визначено.
feedback-rotation_combination = Визначено іншу комбінацію: різницю замість суми або суму замість різниці.
feedback-rotation_not_locked = Це не складання рамок: цю орієнтацію мають рівно дві трійки.
feedback-rotation_quadrant = Кут лежить не в тій чверті, на пів оберту: беріть atan2 замість atan.
feedback-rotation_angle_sign = Кут або комбінація кутів має хибний знак.
feedback-rotation_rounded = Елементи округлено занадто грубо: обчислюйте з більшою кількістю десяткових знаків.
feedback-rotation_unit_columns = Це не поворот: довжина стовпця не дорівнює 1.
feedback-rotation_perpendicular_columns = Це не поворот: два стовпці не перпендикулярні.
feedback-rotation_right_handed = Це не поворот, а відбиття: його визначник −1.
feedback-claim_right = Для цієї матриці це так.
feedback-claim_not_rotation = Це не поворот: перевірте довжини стовпців, кути між ними та визначник.
feedback-claim_rotation = Це таки поворот: стовпці довжини 1, перпендикулярні, визначник +1.
feedback-claim_other_property = Це не поворот, але цю властивість виконано; порушено іншу.
feedback-chain_right = Поза саме та, що випливає з ланцюга систем.
feedback-chain_wrong = Це не та поза, що випливає з відомих.
feedback-chain_rotation_right = Її поворот правильний.
feedback-chain_position_right = Її положення правильне.
feedback-chain_inverted = Це обернена матриця: поза першої системи в останній.
feedback-chain_not_inverted = Відому позу використано як є, хоча її спершу треба обернути.
feedback-chain_inverse_without_transpose = Обернену позу складено з R, а потрібно Rᵀ: (Rᵀ, −Rᵀp).
feedback-chain_inverse_position = Положення оберненої пози — це −Rᵀp, а не −p.
feedback-chain_order_reversed = Множники перемножено у зворотному порядку.
feedback-chain_transposed = Поворот транспоновано.
feedback-chain_not_rigid = Це не рух твердого тіла: стовпці не є перпендикулярними одиничними векторами, або вони утворюють ліву трійку (визначник −1), або останній рядок не 0 0 0 1.
error-euler_axes_unknown = { $axes } не є послідовністю осей: потрібні три з X, Y, Z, сусідні різні.
error-component_order_missing = Укажіть, де стоїть скаляр кватерніона: wxyz чи xyzw.
error-axis_and_angle = До осі потрібен кут, а до кута — вісь.
error-family_incomplete = Родині трійок потрібні всі три дані: середній кут, сума чи різниця та її значення.
error-orientation_empty = Запишіть орієнтацію в одному з потрібних записів.
error-mistake_empty = Укажіть, де помилка, яка вона або як її виправити.
error-frames_not_connected = Відомі пози не ведуть від системи { $start } до системи { $end }.
error-pose_without_table = Поза випливає з власної таблиці студента або з ⁰T: запитайте й про одну з них, або нехай правила фіксують нуль, напрям, систему 0 й останню систему.

error-one_notation = Задайте орієнтацію одним записом: { $known }.
error-name_without_value = Для { $name } тут не задано значення.{ $found ->
    [0] {""}
   *[one] {" "}Можливо, ви мали на увазі { $close }?
} Відомі назви: { $known }.
error-rate_in_marks = { $text } тут не є назвою. Можливо, ви мали на увазі швидкість зчленування { $suggestion }?
error-expected_not_rotation =
    Очікувана матриця не є поворотом: { $property ->
        [unit_columns] довжина стовпця не дорівнює 1.
        [perpendicular_columns] два стовпці не перпендикулярні.
       *[right_handed] це відбиття з визначником −1.
    }

field-solutions = Значення у зчленуваннях
field-combinations = Якщо їх безліч: комбінація, що лишається сталою (коефіцієнти)
option-finite = досягається за цих значень у зчленуваннях
option-infinite = досягається безліччю способів; ось деякі з них
option-out_of_reach = поза межами робочої зони
option-joint_limits = не досягається в межах рухів зчленувань
given-target = Поза
given-target-position = Положення останнього початку координат
given-table = Таблиця DH, { $convention ->
    [modified] модифікована
   *[standard] стандартна
} угода

task-inverse-kinematics =
    { $variables ->
        [own] За яких значень ваших власних змінних остання система займе це місце в системі 0?
       *[given] Таблицю робота задано. За яких значень у зчленуваннях його остання система займе це місце в системі 0?
    } { $solutions ->
        [one] Досить одного розв’язку.
       *[all] Наведіть усі; повні оберти не рахуються.
    } { $reach ->
        [position] Важливе лише положення останнього початку координат, у { unit-word }.
       *[pose] Важливі й положення, у { unit-word }, і орієнтація.
    }

feedback-joints_right = Відповідь правильна: у ній є все, що потрібно подати.
feedback-joints_searched = Для цієї пози розв’язки знайдено пошуком; можуть бути й інші.
feedback-joints_need_table = Значення стосуються ваших власних змінних: здайте також правильну таблицю.
feedback-claim_wrong = Це не так: порахуйте ще раз, скільки розв’язків дають цю позу, якщо такі є.
feedback-joints_wrong = Рядок { $row } не дає цієї пози.
feedback-joints_twice = Рядки { $other } і { $row } відрізняються лише повними обертами: це один розв’язок.
feedback-joints_missing =
    { $count ->
        [one] Бракує { $count } розв’язку.
       *[other] Бракує { $count } розв’язків.
    }
feedback-branch_shoulder =
    { $count ->
        [one] Маніпулятор може дотягтися й назад, через інше плече.
       *[other] Маніпулятор може дотягтися й назад, через інше плече: бракує таких розв’язків: { $count }.
    }
feedback-branch_elbow =
    { $count ->
        [one] Лікоть може згинатися й в інший бік.
       *[other] Лікоть може згинатися й в інший бік: бракує таких розв’язків: { $count }.
    }
feedback-branch_wrist =
    { $count ->
        [one] Зап’ястя може бути й перевернутим.
       *[other] Зап’ястя може бути й перевернутим: бракує таких розв’язків: { $count }.
    }
feedback-branch_other =
    { $count ->
        [one] Є ще одна гілка розв’язків.
       *[other] Є інші гілки розв’язків: { $count }.
    }
feedback-joints_quadrant = Рядок { $row }: q{ $joint } лежить не в тій чверті, на пів оберту. Беріть atan2 замість atan.
feedback-joints_sign = Рядок { $row }: q{ $joint } має неправильний знак.
feedback-joints_degrees = Рядок { $row }: градуси сприйнято як радіани або навпаки.
feedback-joints_swapped = Рядок { $row }: q{ $joint } дорівнює 90° мінус потрібне; аргументи atan2 поміняно місцями.
feedback-joints_half_branch = Рядок { $row } — це рядок { $other }, у якому змінено лише q{ $joint }: в іншій гілці разом із нею змінюються й інші зчленування.
feedback-joints_position_only = Рядок { $row } дає положення, але не орієнтацію.
feedback-joints_orientation_only = Рядок { $row } дає орієнтацію, але не положення.
feedback-joints_limits = Рядок { $row } дає позу, але зчленування { $joint } виходить за межу.
feedback-joints_rounded = Рядок { $row } близький до розв’язку, але недостатньо: обчислюйте з більшою кількістю десяткових знаків.
feedback-joints_family_missing = Поза сингулярна: укажіть, яка комбінація змінних не змінюється вздовж розв’язків.
feedback-joints_taken_off = За хибне бали віднімаються, щоб угадування нічого не давало: тут від балів за правильні рядки нічого не лишилося.
feedback-joints_combination_wrong = Комбінація { $row } змінюється вздовж розв’язків.
feedback-joints_combination_zero = Комбінація { $row } дорівнює 0 за будь-яких положень зчленувань і нічого не говорить.
feedback-joints_combination_loose = Комбінація { $row } не змінюється вздовж розв’язків, але цього не досить: інші значення у зчленуваннях з тією самою комбінацією не досягають пози.
error-pose_frames_free = Позу задано в системі 0 і для останньої: правила мають фіксувати обидві, base = "frame" і tool = "frame".
error-pose_within_reach = Цей маніпулятор досягає як завгодно далеких поз, бо поступальні зчленування тут не мають меж: приберіть out_of_reach з cases.
error-joint_row_length = Рядок містить по одному значенню на зчленування: потрібно { $expected }, наведено { $given }.
error-joint_rows_empty = Наведіть значення у зчленуваннях, що дають цю позу.

field-row = Рядок із помилкою
field-name = Що неправильно
field-mended = Рядок, яким він має бути
field-verdict = Обидві таблиці описують
field-reason = бо
option-alpha_sign = α має неправильний знак
option-alpha_value = α має неправильне значення
option-a_sign = a має неправильний знак
option-d_sign = d має неправильний знак
option-a_value = a має неправильне значення
option-d_value = d має неправильне значення
option-a_d_swapped = a і d поміняно місцями
option-a_missing = a дорівнює нулю, хоча не має дорівнювати
option-a_not_zero = a не дорівнює нулю, хоча має дорівнювати
option-d_missing = пропущено зміщення d
option-d_not_zero = d не дорівнює нулю, хоча має дорівнювати
option-angles_in_degrees = усі кути в градусах, хоч зазначено радіани
option-angles_in_radians = усі кути в радіанах, хоч зазначено градуси
option-cell_in_degrees = один кут у градусах серед радіанів
option-cell_in_radians = один кут у радіанах серед градусів
option-cell_length_unit = одна довжина в інших одиницях
option-cell_parameter = узято інший розмір із рисунка
option-columns_early = a та α на рядок вище
option-columns_late = a та α на рядок нижче
option-columns_exchanged = переставлено два стовпці
option-columns_reordered = стовпці в іншому порядку
option-convention = зазначено не ту угоду
option-fixed_row_missing = бракує останнього рядка, без змінної
option-joint_fixed = зчленування без своєї змінної
option-joint_moving = змінна там, де нічого не рухається
option-joint_type = зчленування не того типу
option-length_unit = усі довжини в інших одиницях
option-parameter_misnamed = позначення, якого немає на рисунку
option-parameters_swapped = переставлено два розміри
option-row_extra = зайвий рядок
option-row_missing = бракує рядка
option-rows_swapped = переставлено два рядки
option-theta_offset = стала, додана до змінної θ, неправильна
option-d_offset = стала, додана до змінної d, неправильна
option-theta_value = стала θ має неправильне значення
option-turns_all_reversed = усі кути зчленувань відлічено не в той бік
option-twists_all_reversed = усі α мають неправильний знак
option-twists_early = лише α на рядок вище
option-twists_swapped = α двох рядків поміняно місцями
option-twists_late = лише α на рядок нижче
option-variable_sign = змінну зчленування відлічено не в той бік
option-same = того самого робота
option-different = різних роботів
option-axis_reversed = системи відрізняються: вісь z або змінну зчленування спрямовано протилежно
option-x_turned = системи відрізняються: вісь x повернуто, і нуль змінної в іншому місці
option-origin_moved = системи відрізняються: початок координат розташовано деінде, або перша чи остання система стоїть інакше
option-other_convention = системи відрізняються: таблиці записано в різних угодах
option-twist = кут між двома осями різний
option-length = відстань між двома осями різна
option-offset = зміщення вздовж осі або сталий кут навколо неї різні
given-table-with-mistake = Таблиця з помилкою ({ $convention ->
    [modified] модифікована угода
   *[standard] стандартна угода
})
given-first-table = Перша таблиця ({ $convention ->
    [modified] модифікована угода
   *[standard] стандартна угода
})
given-second-table = Друга таблиця ({ $convention ->
    [modified] модифікована угода
   *[standard] стандартна угода
})

task-find-mistake = Ця таблиця має описувати робота на рисунку, але в одному рядку є помилка. У якому, що неправильно і яким має бути рядок?
task-compare-tables = Чи описують ці дві таблиці того самого робота, хоч би як обрано системи координат? Поясніть чому.

feedback-mistake_found = Ви знайшли помилку, назвали її й виправили.
feedback-mistake_row_wrong = Помилка в іншому рядку.
feedback-mistake_name_wrong = Помилка іншого виду.
feedback-mistake_not_mended = Із цим рядком таблиця все ще не описує робота.
feedback-mistake_missing =
    { $what ->
        [row] Укажіть, у якому рядку помилка.
        [name] Укажіть, що неправильно.
       *[mended] Запишіть рядок, яким він має бути.
    }
feedback-tables_right = Правильно, і саме з цієї причини.
feedback-tables_same = Це той самий робот: лише системи координат обрано інакше.
feedback-tables_different = Це різні роботи: жоден вибір систем координат не перетворює одну таблицю на іншу.
feedback-tables_reason_wrong = Висновок правильний, але не з цієї причини.
feedback-tables_reason_missing = Висновок правильний; поясніть також чому.
error-row_unknown = Укажіть номер рядка, від 1 до { $count }.
error-column_unknown = Укажіть номер стовпця, від 1 до { $count }.
error-vector_length = Вектор має компонент: { $expected }, а дано: { $given }.
error-joint_variable_in_number = { $name } — змінна зчленування, а тут потрібне число: підставте її значення.
error-no_mistake_does_harm = Жодна з цих помилок не змінює цього робота за його правилами.
error-frame_mistakes_not_shown = Системи координат цього робота не можуть показати жодної з цих помилок. Що вони можуть показати: { $known }.
error-key_given_away = Ця частина показує таблицю; вправа, у якій потрібно подати таблицю, не може її мати.
error-not_plantable = Жодна із заданих помилок не змінює цього робота.

field-frame = Гвинти записано в
field-order = Порядок v і ω
field-screws = Гвинти, по рядку на зчленування
field-home = Початкова поза M
option-space = нерухомій системі (простір)
option-body = системі інструмента в нульовому положенні (тіло)
option-linear_first = v, ω: лінійна частина перша
option-angular_first = ω, v: кутова частина перша

task-screws = Запишіть робота як добуток експонент: гвинти зчленувань від 1 до { $n } і початкову позу M, довжини в { unit-word }. Систему, нульове положення й напрям кожної осі оберіть у межах правил.

feedback-screws_right = Гвинти й початкова поза описують цього робота.
feedback-screws_right_robot = Цей добуток експонент описує потрібного робота, але не дотримано всього, що вимагає вправа.
feedback-screws_wrong = Цей добуток експонент не описує робота, хоч би які систему, нуль і напрями обрано.
feedback-screw_not_unit = Зчленування { $joint }: ω обертального зчленування є одиничним вектором.
feedback-screw_pitch = Зчленування { $joint }: v має складову вздовж ω; обертальне зчленування не просувається вздовж осі.
feedback-screw_joint_type = Зчленування { $joint }: у поступального ω = 0, а v — одиничний вектор; в обертального довжина ω дорівнює 1.
feedback-screw_halves = v і ω поміняно місцями: в іншому порядку рядки були б правильними.
feedback-screw_moment_sign =
    { $joint ->
        [0] Усі v мають неправильний знак
       *[other] Зчленування { $joint }: v має неправильний знак
    }: v = −ω × p, де p — будь-яка точка осі.
feedback-screw_other_frame = Це гвинти в іншій системі: сплутано простір і тіло.
feedback-screw_home_inverted = Початкову позу обернено.
feedback-screw_sign_or_home = Або v скрізь має хибний знак (v = −ω × p, де p — будь-яка точка осі), або початкову позу обернено.
feedback-screw_home = Гвинти правильні, початкова поза M — ні.
feedback-screw_not_rigid = Початкова поза не є рухом твердого тіла: стовпці не є перпендикулярними одиничними векторами, або вони утворюють ліву трійку (визначник −1), або останній рядок не 0 0 0 1.
feedback-screw_length_unit = Довжини наведено в іншій одиниці, ніж у робота: у його одиниці рядки були б правильними.
feedback-screw_exchanged = Рядки зчленування { $joint } і наступного поміняно місцями.
feedback-screw_reversed = Рядки стоять у зворотному порядку: перший належить зчленуванню біля основи.
feedback-screws_relation_wrong = Осі зчленувань { $joint } і { $next } розташовані одна відносно одної не так, як на рисунку.
error-screw_count = Робот має зчленувань: { $expected }, а гвинтів наведено: { $given }.

error-screw_too_large = Число завелике для робота; найбільше — { $limit }.

field-jacobian = Якобіан, по стовпцю на зчленування
field-forces = Моменти й сили у зчленуваннях
given-configuration = Конфігурація
given-wrench = Сила й момент, з якими діє інструмент

task-jacobian =
    { $variables ->
        [own] Візьміть власну таблицю й власні змінні за цих значень.
       *[given] Задано таблицю робота й конфігурацію.
    } { $ask ->
        [jacobian] Запишіть геометричний якобіан останнього початку координат, довжини в { unit-word }, на радіан.
        [forces] Які моменти й сили у зчленуваннях, τ = Jᵀ(f, m), відповідають силі й моменту в останньому початку координат, довжини в { unit-word }?
       *[both] Запишіть геометричний якобіан останнього початку координат, довжини в { unit-word }, на радіан, а також моменти й сили у зчленуваннях τ = Jᵀ(f, m).
    } { $frame ->
        [end] Усі вектори — в осях останньої системи.
       *[base] Усі вектори — в осях системи 0.
    }

feedback-jacobian_right = Усе правильно.
feedback-jacobian_follows_table = Це випливає з вашої таблиці й отримує свої бали, хоча сама таблиця неправильна.
feedback-jacobian_needs_table = Якобіан стосується вашої власної таблиці: здайте також таблицю з усіма зчленуваннями.
feedback-jacobian_missing =
    { $what ->
        [jacobian] Бракує якобіана.
       *[forces] Бракує моментів і сил у зчленуваннях.
    }
feedback-jacobian_wrong = Не всі стовпці якобіана правильні.
feedback-forces_wrong = Не всі моменти й сили у зчленуваннях правильні.
feedback-jacobian_next_axis =
    { $count ->
        [1] У стовпці { $joint } взято вісь сусіднього зчленування: зважайте, яка z належить якому зчленуванню у вашій угоді.
       *[other] У стовпцях { $joints } взято вісь сусіднього зчленування: зважайте, яка z належить якому зчленуванню у вашій угоді.
    }
feedback-jacobian_point_swapped =
    { $count ->
        [1] Стовпець { $joint }: лінійна частина — z × (pₙ − p), а не z × (p − pₙ).
       *[other] Стовпці { $joints }: лінійна частина — z × (pₙ − p), а не z × (p − pₙ).
    }
feedback-jacobian_prismatic =
    { $count ->
        [1] Стовпець { $joint }: поступальне зчленування дає (z, 0), обертальне — (z × (pₙ − p), z).
       *[other] Стовпці { $joints }: поступальне зчленування дає (z, 0), обертальне — (z × (pₙ − p), z).
    }
feedback-jacobian_other_frame =
    { $count ->
        [0] Це якобіан в осях іншої системи.
        [1] Стовпець { $joint } записано в осях іншої системи.
       *[other] Стовпці { $joints } записано в осях іншої системи.
    }
feedback-jacobian_rows_exchanged = Лінійні й кутові рядки поміняно місцями.
feedback-jacobian_spatial = Це швидкість точки в початку системи 0; потрібен початок останньої системи.
feedback-forces_sign = Усі знаки обернено: потрібно τ = Jᵀ(f, m) для заданих сили й моменту.
feedback-forces_other_frame = Силу й момент узято в осях іншої системи.
feedback-forces_rows_exchanged = Силу й момент поміняно місцями.
feedback-forces_spatial = Силу прикладено до початку системи 0.
error-row_order_missing = Укажіть, які рядки перші: (v, ω) чи (ω, v).
error-jacobian_empty = Наведіть якобіан або моменти й сили у зчленуваннях.

error-wrench_missing = Моменти й сили у зчленуваннях відповідають силі й моменту: задайте «wrench».
