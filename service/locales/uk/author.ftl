error-text_markup = Це розмітка, якої не може бути в тексті вправи: { $found }. Пишіть L1 < L2 з пробілами.
error-text_too_long =
    Текст задовгий; дозволено щонайбільше { $limit ->
        [one] { $limit } символ
        [few] { $limit } символи
       *[other] { $limit } символів
    }.
error-text_control_character = Текст містить керівний символ { $found }, якого не видно. Вилучіть його.
error-statement_not_text = Умова не є текстом у кодуванні UTF-8.
error-draft_too_large =
    Опис більший, ніж може бути опис робота: таблиця чи список має щонайбільше { $entries ->
        [one] { $entries } запис
        [few] { $entries } записи
       *[other] { $entries } записів
    }, усі разом — { $values }, а вкладеність не перевищує { $deepest }.
error-archive_too_large =
    Архів завеликий; вправа має щонайбільше { $limit ->
        [one] { $limit } байт
        [few] { $limit } байти
       *[other] { $limit } байтів
    }.
error-archive_not_zip = Це не zip-архів, який можна прочитати.
error-archive_too_many_files =
    Архів містить { $count ->
        [one] { $count } файл
        [few] { $count } файли
       *[other] { $count } файлів
    }; у теці вправи їх щонайбільше { $limit }.
error-archive_entry = { $name } не належить до вправи: одна тека з { $known } і файлами statement.<мова>.md, і більше нічого.
error-archive_method = { $name } зашифровано або стиснуто способом, який тут не читається. Візьміть звичайний zip.
error-archive_file_too_large =
    { $name } завеликий; файл вправи має щонайбільше { $limit ->
        [one] { $limit } байт
        [few] { $limit } байти
       *[other] { $limit } байтів
    }.
error-archive_no_exercise = В архіві немає вправи: очікується одна тека з { $known }.
error-source_form = Вправу починають з одного з: { $known }.
error-drawing_too_many_axes = Осей { $count }; накреслити можна щонайбільше { $limit }.
error-drawing_too_many_lengths = Іменованих довжин { $count }; можливо щонайбільше { $limit }.
error-axis_not_before = Осі { $axis } немає серед накреслених раніше (їх { $before }).
error-length_unknown = { $name } ще не є довжиною цього креслення. Його довжини: { $known }.
error-draft_too_many_rows =
    У таблиці { $count ->
        [one] { $count } рядок
        [few] { $count } рядки
       *[other] { $count } рядків
    }; у чернетці їх щонайбільше { $limit }. Довшу можна записати текою.
error-draft_without_table = Подавати таблицю DH у вправі не потрібно, тож таблиць для показу немає. Додайте частину «Таблиця DH».
error-publications_full = Уже опубліковано стільки вправ, скільки зберігає ця служба ({ $limit }). Завантажте натомість теку.
author-title = Створити вправу
author-lead = Перетворіть маніпулятор зі свого підручника на вправу: накресліть його або почніть з того, що маєте. Вправа перевіряє себе, поки ви пишете.
author-card-start = Робот
author-card-texts = Назва й умова
author-card-parts = Що потрібно подати
author-card-policy = Що вільне, а що задане
author-card-values = Значення
author-card-help = Підказки та спроби
author-card-figure = Рисунок
author-card-preview = Попередній перегляд
author-card-trials = Випробуйте
author-card-take = Завантажити й опублікувати
author-selftest = Самоперевірка
author-start = Почати з
author-start-robot = Каталог
author-start-axes = Креслення
author-start-table = Таблиця DH
author-start-scm = Ланцюг SCM
author-start-urdf = URDF
author-start-robot-hint = Робот із каталогу, з його таблицею та розмірами.
author-start-axes-hint = Розставте осі зчленувань одну за одною від основи, коли робот у нульовому положенні. Іменовані довжини стануть розмірами рисунка; таблиця складеться сама.
author-start-table-hint = Розв’язок так, як ви б його записали: числа або імена на зразок L1. Довжини, задані числами, отримують імена автоматично.
author-start-scm-hint = Рядок на зчленування: переміщення X Y Z і повороти A B C до наступного; змінна стоїть у своїй клітинці: q1, q2, …
author-start-urdf-hint = Файл з одним послідовним ланцюгом. Читаються лише зчленування, без сіток; таблиця закінчується останнім рухомим зчленуванням, без інструмента за ним.
author-robot = Робот
author-begin = Почати з цим роботом
author-started = Вправу можна писати.
author-urdf-file = Файл URDF
author-scm-final = Кінцеве перетворення
author-axes = Осі зчленувань
author-axis = { $number } · { $joint }
author-axis-add = Додати вісь
author-axis-added = Додано вісь { $number }.
author-axis-remove = Вилучити вісь { $number }
author-axis-removed = Вісь { $number } вилучено.
author-axis-joint = Тип зчленування { $number }
author-placed = Вісь { $number } поставлено.
author-how = Як
author-point = Точка осі
author-point-at = за координатами
author-point-on = на іншій осі
author-point-from = зсунута від іншої осі
author-point-axis = Вісь
author-point-distance = Відстань уздовж неї
author-direction = Її напрям
author-direction-vector = довільний вектор
author-direction-through = через іншу точку
author-along = уздовж { $axis }
author-parallel = паралельно осі { $axis }
author-opposite = протилежно осі { $axis }
author-perpendicular = перпендикулярно до осі { $axis }, у бік …
author-across = перпендикулярно до осей { $axis } і { $other }
author-lengths-named = Іменовані довжини
author-lengths-named-hint = Пишіть у будь-якому полі вище ім’я на зразок L1 чи a2, також суми L1 + L2, а тут задайте значення.
author-lengths-none = Жодна довжина ще не має імені.
author-scene = Осі у просторі
author-scene-hint = Клацніть на точці сітки чи іншої осі, щоб поставити туди вибрану вісь, на стрілці — щоб її повернути, на осі — щоб вибрати. Усе можна зробити й у полях нижче.
author-scene-text = { $count ->
    [one] { $count } вісь зчленування
    [few] { $count } осі зчленувань
   *[other] { $count } осей зчленувань
} з точками й напрямами, на яких можна клацнути.
author-language = Мова тексту
author-title-of = Назва
author-statement = Умова
author-statement-hint = Markdown: абзаци, списки, *виділення*, **жирний**, `код`. *L1* набирається як змінна. Що потрібно подати і що вільне, писати не треба: служба додає це мовою читача.
author-statement-preview = Як його читають студенти
author-statement-none = Цією мовою нічого не написано: її читачам показують іншу й кажуть про це.
author-statement-waiting = Хвилинку …
author-points = балів
author-points-of = Бали за: { $part }
author-points-total =
    Усього: { $points ->
        [one] { $points } бал
        [few] { $points } бали
       *[other] { $points } балів
    }.
author-rule-convention = Угода
author-rule-convention-any = будь-яка
author-rule-convention-standard = стандартна
author-rule-convention-modified = модифікована
author-rule-base = Система 0
author-rule-base-free = будь-де
author-rule-base-axis = z як у розв’язку
author-rule-base-origin = початок як у розв’язку
author-rule-base-frame = точно як у розв’язку
author-rule-tool = Остання система
author-rule-tool-free = будь-де
author-rule-tool-point = початок у позначеній точці
author-rule-tool-axis = z на останній осі
author-rule-tool-frame = точно як у розв’язку
author-rule-zero = Нуль змінних
author-rule-zero-free = вільний
author-rule-zero-figure = як на рисунку
author-rule-direction = Додатний напрям
author-rule-direction-free = вільний
author-rule-direction-figure = як на рисунку
author-tolerance-length = Допуск, частка розміру робота
author-tolerance-angle = Допуск кутів, рад
author-policy-admits =
    З { $choices ->
        [one] { $choices } способу
       *[other] { $choices } способів
    }, якими підручники записали б таблицю цього робота, { $admitted ->
    [one] прийнятний { $admitted }
    [few] прийнятні { $admitted }
   *[other] прийнятно { $admitted }
}. Системи між зчленуваннями вільні в кожному разі.
author-values-hint = Де задано діапазон, кожен студент має власне значення; інакше діє звичайне.
author-values-none = У таблиці немає іменованих розмірів.
author-value = Звичайне значення
author-drawn = своє для кожного студента
author-draw-from = { $name } від
author-draw-to = { $name } до
author-draw-step = { $name } з кроком
author-draw-from-short = від
author-draw-to-short = до
author-draw-step-short = крок
author-aliases = Інші імена
author-help-most = Найбільше, що кажуть про хибну таблицю
author-help-ladder = спочатку мало, з кожною спробою більше
author-attempts = Спроби
author-access = Що доступно студентам під час роботи
author-access-hint = Студентам за посиланням курсу служба сама відмовляє в тому, що вимкнено.
author-access-catalogue = каталог роботів
author-access-playground = майстерня
author-access-matrices = матриці таблиці
author-access-trainer = тренажер систем координат
author-view-azimuth = Погляд: поворот навколо вертикалі
author-view-elevation = Погляд: висота
author-posture = Конфігурація на рисунку
author-marks = Позначені точки
author-marks-hint = Потрібні, якщо правила прив’язують останню систему до точки.
author-mark-end = позначити останній початок як P
author-lengths = Розміри, накреслені інакше
author-lengths-hint = Дайте малому розміру іншу довжину на рисунку, щоб його було видно; на рисунку буде зазначено, що він не в масштабі. Порожньо: як є.
author-saved = збережено в цьому браузері
author-other-tab = Цю сторінку відкрито також в іншій вкладці, і там щойно змінено чернетку. Зберігається лише чернетка, яку змінено останньою.
author-test-waiting = Змінено; перевірки почнуться за мить.
author-test-refused = Перевірки почнуться, щойно буде виправлено зазначені вище помилки.
author-test-running = Триває перевірка: правильні відповіді в інших системах, помилки, кожна частина …
author-test-passed = Усі перевірки пройдено: { $passed }.
author-test-failed = { $failed ->
    [one] Не пройдено { $failed } перевірку
    [few] Не пройдено { $failed } перевірки
   *[other] Не пройдено { $failed } перевірок
}, пройдено { $passed }.
author-test-warnings = Варто знати:
author-try = Спробувати як студент
author-right = Показати десять різних правильних відповідей
author-right-shown = { $wrong ->
    [0] Прийнято всі { $count }; перша — ваш розв’язок.
   *[other] Відхилено { $wrong } з { $count }.
}
author-wrong = Показати найчастіші хибні відповіді та їхні бали
author-wrong-hint = Спершу найімовірніші: що скажуть студентові й скільки ще варта вся відповідь. Де хочете, додайте власні слова.
author-wrong-marks =
    { $points } з { $most ->
        [one] { $most } бала
       *[other] { $most } балів
    }, таблиця { $score } %
author-wrong-refused = не приймається, спроби не коштує
author-wrong-untold = Виправлення не підказують ({ $name }).
author-wrong-tested = вправа перевіряє себе цією помилкою
author-own-words = Ваші слова про це, після наших
author-id = Назва теки
author-download = Завантажити теку
author-downloaded = В архіві тека для git і для «framewise exercises check».
author-publish = Опублікувати на цій службі
author-publish-closed = Ця служба не приймає вправ із цієї сторінки: завантажте теку й передайте її тому, хто керує службою.
author-published = Опубліковано. Ця версія лишиться такою назавжди; зміна створює іншу.
author-open = Відкрити вправу
author-insert = Вставити в курс
author-lti-hint = У посиланні, яке створює ваша платформа, задайте це як власний параметр:
author-link = Копіювати посилання на чернетку
author-link-copied = Адреса тепер містить усю чернетку, її скопійовано.
author-import = Відкрити теку (zip)
author-import-hint = Як завантажено звідси або як є у вас у git.
author-imported = Вправу відкрито.

## What a definition may say beside

author-add = Додати: { $name }
author-remove = Вилучити { $name }
author-usual = типове значення
author-dimension-handle = Розмір { $name }: перетягніть його або скористайтеся стрілками; Backspace лишає місце на розсуд служби
author-dimension-hint = Перетягніть назву розміру туди, де його добре видно.
author-dimension-moved = { $name } переміщено.
author-dimension-free = { $name } знову розміщено автоматично.
author-draw-without = крім
author-part-keys = { $part }: що дано і що потрібно подати
author-part-not-beside = Не разом із «{ $part }»: одна частина показує відповідь на іншу.
author-needs = Потрібні в кожній правильній відповіді
author-needs-hint = Про це мають подбати правила: зафіксуйте основу або інструмент, інакше вибір систем лишає розмір осторонь.
author-rungs = Найбільше, що кажуть
author-rung = у спробі { $number }
author-rung-more = Ще один щабель
author-rung-less = На щабель менше
author-weights = Скільки коштують помилки
author-weights-hint = Відносна вага: помилка з вагою 2 коштує вдвічі більше, ніж із вагою 1. Порожнє поле — звичайна вага.
author-weight-joint = зчленування бракує; не того типу — удвічі більше
author-weight-twist = кут скручення α
author-weight-length = довжина a
author-weight-offset = зміщення d або θ поступального
author-weight-rule = правило, якого не дотримано
author-weight-sign = лише знак, як частка
author-weight-row = названа помилка в рядку, щонайбільше
author-weight-table = одна в усій таблиці, щонайбільше
author-samples = Власні відповіді для перевірки
author-samples-hint = Самоперевірка оцінює їх і каже, де висновок не той, якого ви чекаєте. Спробуйте відповідь як студент, щоб зберегти її тут.
author-sample = Зразок
author-sample-key = розв’язок
author-sample-name = Що він показує
author-sample-expect = Очікується
author-sample-correct = правильно
author-sample-incorrect = неправильно
author-sample-invalid = відхилено
author-sample-feedback = Коди, які містить висновок
author-sample-keep = Зберегти цю відповідь як зразок
author-sample-kept = Збережено серед зразків.
author-figure-more = Усе інше про рисунок
author-figure-upright = Як стоїть система 0 на рисунку, градуси
author-figure-roll = крен
author-figure-pitch = тангаж
author-figure-yaw = рискання
author-figure-width = Ширина паперу
author-figure-points = Названі точки
author-figure-joints = Корпуси зчленувань
author-figure-name = Назва
author-figure-at = у точці
author-figure-label = номер на кінці
author-figure-scale = розмір
author-figure-reach = довжина осі
author-figure-links = Ланки
author-figure-links-hint = Ланцюг точок у кожному рядку: O0 O1 P
author-figure-marks = Усі позначені точки
author-figure-ground = Основа
author-figure-normal = напрям від неї, x y z
author-figure-gripper = Захват
author-figure-away = від точки
author-figure-jaws = губки поруч уздовж x y z
author-figure-dimension = Розмір
author-figure-value = довжина, якщо не назва
author-figure-offset = зсунуто до, x y z
author-figure-distance = наскільки
author-figure-distance-along = наскільки вздовж неї
author-figure-form = Як
author-figure-frame = у системі розв’язку
author-figure-between = між двома точками
author-figure-by = зсунута
author-figure-joint = уздовж осі зчленування
author-figure-coordinates = координати
author-figure-ratio = на частці
author-figure-from = від точки
author-key-joints = Значення у зчленуваннях
author-key-turns = Кути, що випадають кожному студентові
author-key-slides = Переміщення, що випадають кожному студентові
author-key-tolerance = Допуск
author-key-point = Позначена точка
author-key-from = Відстань від
author-key-limits = Межі зчленувань
author-key-mistakes = Помилки, які можна внести
author-key-known = Відома поза
author-key-asked = Потрібно подати: поза
author-key-ask = Що потрібно подати
author-key-frame = В осях
author-key-axes = Порядок осей
author-key-turning = Обертання навколо
author-key-asked_axes = Потрібний порядок осей
author-key-asked_turning = Потрібно подати: обертання навколо
author-key-wrench = Сила й момент, з якими діє інструмент
author-key-cases = Пози, що можуть трапитися в завданні
author-key-solutions = Скільки розв’язків потрібно подати
author-key-reach = Чого треба досягти
author-key-given = Дано як
author-key-angles = Кути
author-key-middle = Середній кут випадає з
author-choice-jacobian = якобіан
author-choice-forces = моменти й сили у зчленуваннях
author-choice-base = системи 0
author-choice-end = останньої системи
author-choice-reached = досяжне
author-choice-out_of_reach = недосяжне
author-choice-all = усі
author-choice-one = один
author-choice-pose = положення й орієнтація
author-choice-position = лише положення
author-choice-matrix = матриця повороту
author-choice-quaternion = кватерніон
author-choice-axis_angle = вісь і кут
author-choice-angles = три кути
author-choice-every_triple = усі трійки кутів
author-choice-current = осей рухомої системи
author-choice-fixed = нерухомих осей
author-choice-axis = осі зчленування 1
author-key-one-joint = { $name } випадає окремо
author-version = Версія: збільште її, коли змінюються правильні відповіді або значення
author-variants = Наборів значень на всіх студентів разом
author-key-motion = Рух, що береться до уваги
author-choice-twist = лінійна й кутова швидкості
author-choice-translation = лише лінійна швидкість
author-key-links = Ланки маніпулятора
author-key-gravity = Прискорення вільного падіння в системі 0
author-key-weights = Позначення та їхні значення
author-key-matrix = Показана матриця
author-choice-mass = матриця інерції M
author-choice-coriolis = якась матриця C
author-choice-skew = що Ṁ − 2C кососиметрична
author-choice-velocity = лише C q̇
author-choice-gravity = гравітаційні члени g
author-choice-link = однієї ланки
author-choice-transform = усього маніпулятора
author-body = Ланка { $number }
author-body-mass = маса
author-body-centre = центр мас
author-body-moments = моменти інерції
author-quantity-name = Назва величини
author-quantity-value = значення
author-quantity-draw = своє для кожного студента
