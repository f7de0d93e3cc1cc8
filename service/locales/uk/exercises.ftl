### Вправи: що потрібно подати, що сказано про відповіді, чого не може містити опис вправи.

## Рисунок словами

figure-title = { $title }: зчленування, осі та розміри
figure-coordinates = { $joints ->
    [one] Робот з { $joints } зчленуванням.
   *[other] Робот із { $joints } послідовними зчленуваннями, рахуючи від основи.
} Положення подано в { unit-word } у вигляді (X; Y; Z). { figure-place }
figure-place = X вказує { $x ->
    [back] назад, Y ліворуч
    [left] ліворуч, Y вперед
    [front] вперед, Y праворуч
   *[right] праворуч, Y назад
}, Z угору; { $fixed ->
    [ground] робот закріплено
   *[joint] корпус зчленування 1 розташований
} у { $at }.
figure-joint-revolute = Зчленування { $joint } обертальне. Його корпус розташований у { $place }; його вісь { $course ->
    [vertical] вертикальна
    [sideways] проходить зліва направо
    [depthways] проходить спереду назад
   *[oblique] має напрям { $direction }
}.
figure-joint-revolute-signed = Зчленування { $joint } обертальне. Його корпус розташований у { $place }; його вісь { $course ->
    [vertical] вертикальна
    [sideways] проходить зліва направо
    [depthways] проходить спереду назад
   *[oblique] похила
}. За правилом правої руки змінна зчленування додатна навколо напряму { $direction }.
figure-joint-prismatic = Зчленування { $joint } поступальне. Його корпус розташований у { $place }; його напрям { $course ->
    [vertical] вертикальний
    [sideways] — зліва направо
    [depthways] — спереду назад
   *[oblique] — { $direction }
}.
figure-joint-prismatic-signed = Зчленування { $joint } поступальне. Його корпус розташований у { $place }; його напрям { $course ->
    [vertical] вертикальний
    [sideways] — зліва направо
    [depthways] — спереду назад
   *[oblique] похилий
}. Змінна зчленування додатна вздовж напряму { $direction }.
figure-dimension = { $name } дорівнює { $length } { $unit ->
    [m] м
    [cm] см
    [mm] мм
   *[other] { $unit }
} і виміряно { $course ->
    [vertical] вертикально
    [sideways] зліва направо
    [depthways] спереду назад
   *[oblique] навскіс
}, між { $start } та { $end }.
figure-point = Точка { $name } лежить у { $place }.
figure-frame = Початок системи { $number } — у { $place }; її вісь x спрямована вздовж { $x }, вісь z — вздовж { $z }.
figure-not-to-scale = Рисунок виконано не в масштабі: на ньому { $names } { $count ->
    [one] має не ту довжину
   *[other] мають не ту довжину
}, що тут.
figure-note = не в масштабі

## Що вільне, а що задане

rule-convention-any = Приймаються і стандартна, і модифікована угода.
rule-convention-standard = Запишіть таблицю в стандартній угоді.
rule-convention-modified = Запишіть таблицю в модифікованій угоді.
rule-base-free = Систему 0 можна розташувати будь-де на основі.
rule-base-axis = Вісь z системи 0 лежить на осі зчленування 1, у будь-якому з двох напрямів.
rule-base-origin = Початок системи 0 — позначена точка O0; напрями її осей обираєте ви.
rule-base-frame = Систему 0 задано; її показано на рисунку.
rule-tool-free = Останню систему можна розташувати будь-де на останній ланці.
rule-tool-point = Початок останньої системи лежить у позначеній точці { $points }.
rule-tool-axis = Вісь z останньої системи лежить на осі останнього зчленування, у будь-якому з двох напрямів; її початок може бути будь-де на цій осі.
rule-tool-frame = Останню систему задано; її показано на рисунку.
rule-zero-free = Ви обираєте, де кожна змінна зчленування дорівнює нулю.
rule-zero-figure = У конфігурації на рисунку всі змінні зчленувань дорівнюють нулю.
rule-direction-free = Ви обираєте, куди спрямована кожна вісь.
rule-direction-figure = Змінні зчленувань додатні в напрямі стрілок на рисунку.

## Що потрібно подати

task-schematic = Опишіть структуру: тип кожного зчленування і те, як вісь кожного зчленування розташована відносно осі наступного.
task-table = Оберіть системи координат і запишіть таблицю DH. Клітинки можуть містити { $names }, числа та змінні зчленувань q1 … q{ $n }.
task-link-matrices = Для кожного рядка вашої таблиці запишіть матрицю ланки: позу системи i у системі i−1. Можна скорочувати cos(q1) до c1, а sin(q1 + q2) до s12.
task-transform = Запишіть ⁰T, позу останньої системи в системі 0, у замкненому вигляді.
task-pose = Обчисліть вашу ⁰T для { $joints } і поданих тут розмірів; довжини в { unit-word }.
task-workspace-axis = На яку найменшу і на яку найбільшу відстань від осі зчленування 1 можна відвести { $point }? { $limits ->
    [none] Кожне зчленування може набувати будь-якого значення.
   *[some] Зчленування не виходять за свої межі: { $ranges }; на рисунку { $drawn }.
} Подайте обидва радіуси в { unit-word }.
task-workspace-point = Які найменша і найбільша відстані між { $point } та { $origin }? { $limits ->
    [none] Кожне зчленування може набувати будь-якого значення.
   *[some] Зчленування не виходять за свої межі: { $ranges }; на рисунку { $drawn }.
} Подайте обидва радіуси в { unit-word }.

## Зауваження до частин

feedback-part_wrong = Ця частина ще не правильна.
feedback-schematic_right = Структура правильна.
feedback-schematic_joint_count = Ви вказали { $given ->
    [one] { $given } зчленування
    [few] { $given } зчленування
   *[other] { $given } зчленувань
}; перелічіть ще раз, скільки з них рухомі.
feedback-schematic_joint_type = Тип зчленування { $joint } неправильний.
feedback-schematic_relation = Взаємне розташування осей { $first } і { $second } неправильне.
feedback-schematic_angle_right = Осі { $first } і { $second }: кут між ними правильний, але не те, чи вони перетинаються.
feedback-schematic_meeting_right = Осі { $first } і { $second } справді перетинаються, але не під таким кутом.
feedback-matrices_right = Матриці ланок правильні.
feedback-matrices_follow_table = Матриці ланок випливають із вашої таблиці й отримують свої бали, хоча таблиця неправильна.
feedback-matrices_right_not_from_table = Матриці ланок правильні для робота, хоча й не випливають із вашої таблиці.
feedback-matrices_product_wrong = Перемножені між собою, ваші матриці ланок не описують цього робота.
feedback-matrix_missing = Немає матриці { $matrix }.
feedback-matrix_wrong = Матриця { $matrix } не відповідає рядку { $matrix } вашої таблиці.
feedback-matrix_cells_wrong = Матриця { $matrix } відрізняється від рядка { $matrix } вашої таблиці в таких клітинках (рядок,стовпець): { $cells }.
feedback-matrix_inverse = Матрицю { $matrix } обернено: це поза системи i−1 у системі i.
feedback-matrix_rotation_transposed = Поворот у матриці { $matrix } транспоновано.
feedback-matrix_other_convention = Матрицю { $matrix } складено за правилом іншої угоди.
feedback-matrix_without_variable = Матрицю { $matrix } записано для нульового значення змінної; збережіть змінну.
feedback-matrix_of_other_row = Матриця { $matrix } належить рядку { $other }.
feedback-matrix_not_rigid = Матриця { $matrix } не є рухом твердого тіла: її стовпці не є взаємно перпендикулярними одиничними векторами, або вони утворюють ліву трійку (визначник −1), або останній рядок не 0 0 0 1.
feedback-transform_right = ⁰T правильна.
feedback-transform_follows_table = ⁰T випливає з вашої таблиці й отримує свої бали, хоча таблиця неправильна.
feedback-transform_right_not_from_table = ⁰T правильна для робота, хоча й не випливає з вашої таблиці.
feedback-table_says_little = У вашій таблиці менше половини довжин і кутів α, потрібних для опису цього робота; те, що з неї випливає, отримує лише частину балів, а з таблиці нулів — жодного.
feedback-transform_wrong = Ця ⁰T не описує робота.
feedback-transform_rotation_right = Поворот у ⁰T правильний.
feedback-transform_position_right = Положення в ⁰T правильне.
feedback-transform_cells_wrong = ⁰T відрізняється від вашої таблиці в таких клітинках (рядок,стовпець): { $cells }.
feedback-transform_not_rigid = ⁰T не є рухом твердого тіла: її стовпці не є взаємно перпендикулярними одиничними векторами, або вони утворюють ліву трійку (визначник −1), або останній рядок не 0 0 0 1.
feedback-transform_inverse = Це матриця, обернена до ⁰T: поза системи 0 в останній системі.
feedback-transform_rotation_transposed = Поворот у ⁰T транспоновано.
feedback-transform_order_reversed = Матриці ланок перемножено у зворотному порядку.
feedback-transform_links_missing = Це добуток лише до системи { $last }; продовжіть до останньої системи.
feedback-pose_right = Поза правильна.
feedback-pose_follows_table = Поза випливає з вашої таблиці й отримує свої бали, хоча таблиця неправильна.
feedback-pose_wrong = Це не та поза, яку дає ваша таблиця для цих значень у зчленуваннях.
feedback-pose_last_row = Останній рядок пози — 0 0 0 1; з іншим матриця не є позою й не отримує балів.
feedback-pose_rotation_right = Поворот правильний.
feedback-pose_position_right = Положення правильне.
feedback-pose_inverse = Це обернена поза.
feedback-pose_rotation_transposed = Поворот транспоновано.
feedback-pose_degrees_as_radians = Синуси й косинуси обчислено так, ніби градуси — це радіани.
feedback-workspace_right = Обидва радіуси правильні.
feedback-workspace_inner_wrong = Внутрішній радіус неправильний.
feedback-workspace_outer_wrong = Зовнішній радіус неправильний.
feedback-workspace_swapped = Внутрішній і зовнішній радіуси переставлено.
feedback-workspace_diameters = Це діаметри, а потрібні радіуси.
feedback-workspace_other_length_unit = Радіуси правильні в іншій одиниці; вони потрібні в { unit-word }.

## Чому відповідь не можна оцінити

problem-note-ungraded = Цю відповідь не оцінено, і вона не забирає спроби.
error-answer_empty = Нічого не здано. У вправі потрібно подати: { $known }.
error-part_not_asked = У вправі не потрібно подавати { $part }; потрібно: { $known }.
error-link_matrices_count = У таблиці { $expected ->
    [one] { $expected } рядок
    [few] { $expected } рядки
   *[other] { $expected } рядків
}, але подано { $given ->
    [one] { $given } матрицю
    [few] { $given } матриці
   *[other] { $given } матриць
}. Подайте по одній на кожен рядок; null пропускає одну.
error-link_matrices_need_table = Без таблиці матриці ланок оцінюються за їхнім добутком. Подайте всі.
error-pose_needs_table = Поза визначається вашою власною таблицею. Здайте і таблицю.
error-matrix_not_4x4 = Матриця має чотири рядки по чотири клітинки.
error-joint_variable_unknown = Немає { $name }; робот має { $joints ->
    [one] { $joints } зчленування
    [few] { $joints } зчленування
   *[other] { $joints } зчленувань
}.{ $summed ->
    [0] {""}
   *[other] {" "}Суму пишуть повністю: { $sum }.
}
error-short_form_unknown = { $name } читається як косинус або синус, але не всі його індекси є обертальними зчленуваннями; робот має { $joints ->
    [one] { $joints } зчленування
    [few] { $joints } зчленування
   *[other] { $joints } зчленувань
}.
error-radius_negative = Радіус не буває від’ємним.
error-schematic_fixed_joint = У структурі перелічуються рухомі зчленування: обертальні або поступальні.
error-schematic_relations_count = { $joints ->
    [one] { $joints } зчленування має
    [few] { $joints } зчленування мають
   *[other] { $joints } зчленувань мають
} { $expected ->
    [one] { $expected } пару
    [few] { $expected } пари
   *[other] { $expected } пар
} сусідніх осей. Подайте одне відношення для кожної пари.
error-seed_invalid = Зерно — це текст або ціле число.
error-seed_too_long =
    Зерно має щонайбільше { $limit ->
        [one] { $limit } символ
        [few] { $limit } символи
       *[other] { $limit } символів
    }.
error-exercise_unknown = Немає вправи { $id }. Є такі: { $known }.
error-language_unknown = Мови { $language } тут немає. Є такі: { $known }.

## Чому опис вправи не можна прочитати

error-exercise_file_missing = Немає файлу exercise.toml.
error-exercise_file_not_toml = Це не TOML: { $reason }
error-exercise_key_missing = Бракує { $key }.
error-exercise_key_unknown = { $key } — невідомий ключ. Відомі ключі: { $known }.
error-exercise_value_type = Значення { $key } має бути таким: { expected-value }.
error-exercise_value_unknown = Значення { $key } має бути одним із таких: { $known }.
error-exercise_robot_unknown = У каталозі немає робота { $robot }. У ньому є { $known }.
error-exercise_limits_reversed = Межі зчленування { $joint } подаються як [найменше, найбільше].
error-exercise_limits_unknown = У каталозі немає меж цього робота.
error-folder_missing = Немає теки { $folder }.
error-exercise_id_invalid = { $id } не є ідентифікатором вправи; ідентифікатор має літери, цифри та поодинокі дефіси.
error-exercise_exists = Вправа { $id } вже існує.
error-source_unreadable = Файл не можна прочитати: { $reason }
error-robot_and_reference = Подайте або robot, або [reference], але не обидва.
error-statement_missing = Немає умови мовою { $language }.
error-statement_name_unknown = { $name } не є ні розміром робота, ні точкою чи розміром на рисунку.
error-misconception_unknown = { $name } — не помилка зі списку. Є такі: { $known }.
error-nothing_asked = У вправі має бути завдання: додайте частину.
error-part_twice = { $kind } стоїть у вправі двічі.
error-points_not_positive = За частину має даватися більше ніж нуль балів.
error-draw_empty = Немає з чого вибирати: «from» не може перевищувати «to», а «step» має бути додатним.
error-draw_too_large =
    Вибір має щонайбільше { $limit ->
        [one] { $limit } значення
        [few] { $limit } значення
       *[other] { $limit } значень
    }.
error-variants_too_many = Варіантів щонайбільше { $limit }.
error-tolerance_out_of_range = { $name } лежить між 0 і 0,1.
error-name_invalid = { $name } не є назвою розміру; назва має вигляд L1.
error-width_out_of_range = Ширина лежить між 320 і 960.
error-unknown_point = Немає точки { $name }. Є такі: { $known }.
error-unknown_frame = Такої системи координат немає: системи пронумеровано від 0 до { $last }.
error-unknown_joint = Зчленування { $joint } немає: зчленування пронумеровано від 1 до { $last }.
error-point_without_form = Точка задається через frame і at; через between і ratio; через from і by; або через from, joint і distance.
error-joint_off_axis = Точка { $point } не лежить на осі зчленування { $joint }.
error-dimension_disagrees = Відстань між точками { $name } дорівнює { $length }, але { $name } — це { $value }.
error-dimension_too_short = { $name } дорівнює { $length } — це замало, щоб показати на рисунку: це менше від мільйонної частки розміру робота. Задайте інше значення або напишіть замість нього 0.
error-posture_not_zero = За правила zero = figure студентам повідомляється, що в конфігурації на рисунку всі змінні зчленувань дорівнюють нулю: зобразіть робота в цій конфігурації (posture 0 для кожного зчленування) або залиште нулі вільними.
error-tool_point_unmarked = За правила tool = point останній початок має лежати в позначеній точці, але жодна з позначених точок не є останнім початком еталонного розв’язку. Позначте початок системи { $last }.
error-gripper_without_direction = Захват і точка, від якої він спрямований, збігаються.
error-jaws_along_gripper = Губки стоять поруч, перпендикулярно до захвата.

error-name_unknown = { $name } не є розміром цієї вправи.{ $unit ->
    [0] {""}
   *[one] {" "}Одиниці в клітинках не пишуть: якщо { $name } — одиниця, приберіть її.
}{ $found ->
    [0] {""}
   *[one] {" "}Можливо, ви мали на увазі { $close }?
} Відомі назви: { $known }.
error-need_unmet = За цих правил жодна відповідь не потребує { $name }: можна вибрати системи координат, у яких його немає. { $rules ->
    [none] Жодне правило цього не змінює: вилучіть його з needs.
   *[other] Кожного з цих правил досить, щоб він став потрібним: { $rules }.
}
error-need_unknown = { $name } не є розміром таблиці. Її розміри: { $known }.
error-alias_taken = { $name } вже має значення.
error-title_missing = Потрібна назва принаймні однією мовою: [title] з en = "…".
exercise-other-language = Цю вправу ще не написано вашою мовою. Мова тексту: { $language }.
rule-dimension-free = { $names } не мусить бути у вашій таблиці: за відповідного вибору систем координат цей розмір зникає.
error-context_invalid = Це посилання створено не тут, або його змінено.
error-context_expired = Термін дії цього посилання минув.
error-switched_off = { $path } вимкнено для цієї вправи.
error-attempts_used_up = { $limit ->
    [1] Єдину спробу використано.
   *[other] Усі спроби ({ $limit }) використано.
}
error-ladder_falls = На кожній спробі можна сказати стільки ж, як на попередній, або більше, але не менше.
task-frames = Розмістіть системи координат 0–{ $n } на роботі так, як його показано на рисунку: для кожної початок, у { unit-word } і в координатах рисунка, та напрями x і z. { figure-place }
error-frames_count = Є системи від 0 до N: потрібно { $expected }, дано { $given }.
error-convention_not_asked = У вправі потрібна { $asked ->
    [modified] модифікована
   *[standard] стандартна
} угода.
error-weight_out_of_range = Вага { $name } — число від 0 до { $most }.
