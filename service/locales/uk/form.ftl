# Вебформа для студентів: що каже кожна сторінка.

form-skip = Перейти до вмісту
form-nav-label = Сторінки
form-nav-exercises = Вправи
form-nav-playground = Майстерня
form-language = Мова
form-needs-script = Ця сторінка потребує JavaScript: він малює робота й перевіряє таблицю під час введення.
form-unreachable = Служба недоступна. Уведене збережено; спробуйте ще раз за мить.
form-retry = Спробувати ще раз
form-cancel = Скасувати
form-close = Закрити
form-named = { $name }: { $said }
form-loading = Завантаження …

form-home-title = Вправи
form-home-heading = Опишіть робота. Зараховується будь-який правильний вибір систем координат.
form-home-lead = Таблиці Денавіта–Гартенберга з роботом, що рухається під час введення, і перевіркою, яка доводить, чи описує таблиця той самий механізм.
form-home-exercises = Вправи
form-home-subjects = Теми
form-home-more = Інше
form-home-playground = Будь-яка таблиця: пози, якобіани, вирази в замкненому вигляді, перетворення.
form-home-api = Програмний інтерфейс
form-home-api-text = Те саме через HTTP, як документ OpenAPI.
form-home-best =
    Найкраще: { $points } з { $total ->
        [one] { $total } бала
       *[other] { $total } балів
    }
form-home-joints =
    { $joints ->
        [one] { $joints } зчленування
        [few] { $joints } зчленування
        [many] { $joints } зчленувань
       *[other] { $joints } зчленування
    }
form-home-trainer = Тренування: вибір систем координат

form-scene-role = тривимірний вигляд
form-scene-label = Робот
form-scene-tools = Вигляд
form-scene-view = Дивитися
form-scene-view-corner = З кута
form-scene-view-front = Спереду
form-scene-view-side = Збоку
form-scene-view-top = Зверху
form-scene-view-now = Вигляд: { $view }
form-scene-turn-left = Повернути ліворуч
form-scene-turn-right = Повернути праворуч
form-scene-turn-up = Нахилити вгору
form-scene-turn-down = Нахилити вниз
form-scene-zoom-in = Збільшити
form-scene-zoom-out = Зменшити
form-scene-reset = Показати все
form-scene-keys = Стрілки повертають вигляд, Shift зі стрілками зсуває його, + і − змінюють масштаб, 0 показує все.

form-joint = Зчленування
form-joint-revolute = обертальне
form-joint-prismatic = поступальне
form-joint-fixed = нерухоме
form-joint-of-row = Тип зчленування, рядок { $row }
form-joint-turn = Кут зчленування { $name }
form-joint-slide = Переміщення в зчленуванні { $name }
form-joint-value = { $name }, { unit-word.alone }
form-joints-reset = Повернути зчленування на місце

form-convention = Угода
form-convention-standard = стандартна
form-convention-modified = модифікована
form-convention-now-standard = Уведене лишається без змін і тепер читається за стандартною угодою: a й α належать ланці i, зчленування i рухається відносно осі z системи i−1.
form-convention-now-modified = Уведене лишається без змін і тепер читається за модифікованою угодою: a й α належать ланці i−1, зчленування i рухається відносно осі z системи i.
form-angle-unit = Одиниця кутів
form-degrees = градуси
form-radians = радіани
form-length-unit = Одиниця довжин
unit-word = { $unit ->
    [m] м
    [cm] см
    [mm] мм
    [in] дюймах
   *[other] { $unit }
}
    .alone = { $unit ->
        [m] м
        [cm] см
        [mm] мм
        [in] дюйми
       *[other] { $unit }
    }
form-unit-now-deg = Числа в стовпцях кутів тепер читаються в градусах.
form-unit-now-rad = Числа в стовпцях кутів тепер читаються в радіанах.
form-unit-now-length = Числа в стовпцях довжин тепер читаються в { unit-word }.
form-unit-doubt-deg = { $value } rad — це більше ніж повний оберт. Ці кути в градусах?
form-unit-doubt-rad = { $value }° — дуже малий кут. Ці кути в радіанах?
form-unit-read-deg = Читати їх у градусах
form-unit-read-rad = Читати їх у радіанах
form-unit-convert = Перерахувати числа
form-unit-converted = Числа перераховано.
form-unit-converted-but =
    { $count ->
        [one] Числа перераховано, крім { $count } клітинки, що не є простою сумою: перевірте її.
        [few] Числа перераховано, крім { $count } клітинок, що не є простими сумами: перевірте їх.
        [many] Числа перераховано, крім { $count } клітинок, що не є простими сумами: перевірте їх.
       *[other] Числа перераховано, крім { $count } клітинки, що не є простою сумою: перевірте їх.
    }

form-table-caption = Таблиця DH, { $convention } угода
form-row-actions = Дії
form-row-add = Додати рядок
form-row-added = Рядок { $row } додано
form-row-remove = Вилучити рядок { $row }
form-row-removed = Рядок { $row } вилучено
form-row-up = Підняти рядок { $row }
form-row-down = Опустити рядок { $row }
form-row-moved = Рядок { $row } тепер рядок { $to }
form-row = рядок { $row }
form-column = стовпець { $name }
form-row-cell = рядок { $row }, { $name }
form-cell-label = Рядок { $row }, { $name } [{ $unit }]
form-cell-empty = Порожньо: якщо нуль, напишіть 0.
form-refused = Не вдалося:
form-faults =
    { $count ->
        [one] { $count } клітинка потребує уваги:
        [few] { $count } клітинки потребують уваги:
        [many] { $count } клітинок потребують уваги:
       *[other] { $count } клітинки потребують уваги:
    }
form-undo = Скасувати дію
form-undone = Дію скасовано
form-redo = Повторити
form-redone = Дію повторено
form-symbols = Символи
form-symbol-insert = Вставити { $symbol }
form-keys = Стрілки вгору та вниз змінюють рядок · Alt зі стрілкою пересуває рядок · Alt+Enter додає рядок · Alt+Delete вилучає · Ctrl+Z скасовує.
form-paste-title = Вставити таблицю
form-paste-label = Таблиця з електронної таблиці, LaTeX, Markdown, PDF, MATLAB або Python
form-paste-order = Стовпці без заголовків читаються в такому порядку: { $order }
form-paste-found =
    { $rows ->
        [one] Знайдено { $rows } рядок:
        [few] Знайдено { $rows } рядки:
        [many] Знайдено { $rows } рядків:
       *[other] Знайдено { $rows } рядка:
    }
form-paste-nothing = У цьому тексті таблиці не розпізнано: кожному рядку потрібні чотири параметри DH.
form-paste-preview = Що знайдено
form-paste-apply = Узяти цю таблицю
form-pasted =
    { $rows ->
        [one] Вставлено { $rows } рядок.
        [few] Вставлено { $rows } рядки.
        [many] Вставлено { $rows } рядків.
       *[other] Вставлено { $rows } рядка.
    }

form-matrix-mode = Матриці як
form-matrix-numbers = Числа
form-matrix-symbols = Символи
form-matrix-notation = Запис
form-matrix-short = скорочений
form-matrix-full = повний
form-matrix-none = Матриці з’являться, щойно кожен рядок можна буде прочитати.
form-matrix-name = Поза системи { $to } у системі { $from }
form-copy = Копіювати як
form-copy-group = Копіювати: { $what }
form-copied = Скопійовано як { $format }
form-copy-failed = Браузер не дозволяє копіювати

form-exercise-title = Вправа
form-exercise-task = Завдання
form-exercise-robot = Робот
form-exercise-description = Опис словами
form-exercise-answer = Ваша відповідь
form-exercise-givens = Дано
form-exercise-rules = Що можна вибирати, а що задано
form-figure-mode = Показати робота
form-figure-drawing = Рисунок
form-figure-space = 3D
form-figure-alt = Рисунок робота: { $title }. Далі — опис словами.
form-figure-label = { $title } у просторі
form-figure-move = Рухати зчленуваннями
form-figure-posture = Відлік від конфігурації на рисунку.
form-choose = Виберіть …
form-choose-missing = Виберіть один із варіантів.
form-points =
    { $points } з { $total ->
        [one] { $total } бала
       *[other] { $total } балів
    }
form-row-go = До рядка { $row }
form-row-heading = Рядок
form-row-missing =
    { $after ->
        [0] перед 1
       *[other] після { $after }
    }
form-submit = Перевірити відповідь
form-submitting = Перевірка …
form-submit-hint = Ctrl+Enter робить те саме.
form-help = Якщо відповідь хибна, показати
form-help-verdict = лише це
form-help-row = які рядки хибні
form-help-kind = що хибне в кожному рядку
form-help-repair = що її виправить

form-part-table = Таблиця DH
form-part-schematic = Структура
form-part-link-matrices = Матриці ланок
form-part-transform = Поза останньої системи, у символах
form-part-pose = Поза останньої системи, у числах
form-part-workspace = Робоча зона
form-part-orientation = Орієнтація
form-part-rotation-check = Поворот чи ні
form-part-frame-chain = Ланцюг систем
form-part-inverse-kinematics = Обернена задача кінематики
form-part-find-mistake = Знайти помилку
form-part-matrix-mistake = Знайти помилку в матриці
form-part-frame-mistake = Знайти помилку на рисунку
form-part-compare-tables = Дві таблиці
form-part-screws = Добуток експонент
form-part-jacobian = Якобіан і статика
form-part-jacobian-form = Якобіан у замкненому вигляді
form-part-singularities = Сингулярності
form-part-equations-of-motion = Рівняння руху
form-part-wrong = Варто переглянути:
form-radius-inner = Внутрішній радіус
form-radius-outer = Зовнішній радіус
form-matrix-cell = { $name }, рядок { $row }, стовпець { $column }
form-schematic-joint = Зчленування { $joint }
form-schematic-relation = Вісь { $joint } відносно осі { $next }
form-relation-coincident = збігаються
form-relation-parallel = паралельні
form-relation-intersecting-perpendicular = перетинаються, перпендикулярні
form-relation-intersecting-oblique = перетинаються під іншим кутом
form-relation-skew-perpendicular = мимобіжні, перпендикулярні
form-relation-skew-oblique = мимобіжні під іншим кутом

form-own-heading = Ваш робот
form-own-scene = Ваш робот, як його описує ваша таблиця
form-own-empty = Ваш робот росте тут із кожним рядком, який можна прочитати.
form-own-missing =
    { $count ->
        [one] Ще порожня { $count } клітинка.
        [few] Ще порожні { $count } клітинки.
        [many] Ще порожні { $count } клітинок.
       *[other] Ще порожні { $count } клітинки.
    }
form-own-unread =
    { $count ->
        [one] { $count } клітинку ще не можна прочитати.
        [few] { $count } клітинки ще не можна прочитати.
        [many] { $count } клітинок ще не можна прочитати.
       *[other] { $count } клітинки ще не можна прочитати.
    }
form-own-last = На зображенні — остання таблиця, яку вдалося прочитати.
form-own-values = Щоб намалювати вашого робота, задайте значення: { $names }.
form-own-shown =
    { $joints ->
        [one] Намальовано за вашою таблицею: { $joints } зчленування.
        [few] Намальовано за вашою таблицею: { $joints } зчленування.
        [many] Намальовано за вашою таблицею: { $joints } зчленувань.
       *[other] Намальовано за вашою таблицею: { $joints } зчленування.
    }
form-own-description = Системи координат вашої таблиці з осями x, y, z.{ $count ->
    [0] {""}
   *[other] {" "}Зчленування: { $joints }.
}
form-own-parameters = Значення для рисунка
form-joints = Зчленування
form-matrices = Матриці

form-verdict-heading = Висновок
form-verdict-correct = Ваша таблиця описує цього робота.
form-verdict-wrong = Ваша таблиця ще неправильна.
form-verdict-all = Усе, що ви здали, правильне.
form-verdict-some = Ще не все правильно.
form-verdict-outdated = Відтоді ви змінили відповідь.
form-basis-proved = Доведено: тотожність справджується за всіх значень змінних зчленувань.
form-basis-verified = Перевірено в багатьох конфігураціях.
form-links-caption = Що правильно в кожному рядку
form-fact-twist = Скручення α
form-fact-length = Довжина a
form-fact-offset = Зміщення
form-fact-joint = Тип зчленування
form-finding-ok = правильно
form-finding-wrong = неправильно
form-finding-doubtful = можливо, неправильно
form-finding-missing = бракує
form-finding-unknown = не вирішено
form-finding-hidden = –
form-repairs = Що зробило б її правильною
form-repair-or = або
form-both-label = Робот із вправи й ваш рухаються разом
form-both-text = Обидва роботи рухаються разом: ваш — із вашими системами, робот із вправи — сірий з помаранчевим.
form-both-description = Ваші системи накладено на робота з вправи, і обидва виконують той самий рух.
form-both-position = Мить руху
form-play = Запустити
form-pause = Зупинити

form-history-heading = Ваші спроби
form-history-restore = Повернути у форму
form-history-restored = Спроба знову у формі
form-history-kept = Зберігаються лише в цьому браузері.
form-history-clear = Забути все

form-missing-title = Не знайдено
form-missing-text = Такої сторінки тут немає. Усі вправи — на першій сторінці.
form-missing-home = До вправ
form-storage-blocked = Браузер тут нічого не зберігає: уведене зникне, якщо закрити або перезавантажити сторінку.
form-other-tab = Цю вправу відкрито також в іншій вкладці, і там щойно щось уведено. Залишиться те, що введено останнім.
form-other-tab-take = Показати введене там

form-row-play = Показати рядок { $row } на рисунку
form-film = Рядок крок за кроком
form-film-hint = Поставте курсор у клітинку або натисніть номер рядка: видно, як чотири числа переводять систему координат i−1 у систему i.
form-film-none = Рядок { $row } ще не можна показати: заповніть його та попередні рядки.
form-film-play = Відтворити рядок
form-film-back = Крок назад
form-film-forward = Крок уперед
form-film-row-before = Попередній рядок
form-film-row-after = Наступний рядок
form-film-start = Рядок { $row }: початок у системі { $frame }.
form-film-turn = Рядок { $row }, { $number } з 4: поворот навколо { $axis } на { $letter } = { $value }.
form-film-slide = Рядок { $row }, { $number } з 4: переміщення вздовж { $axis } на { $letter } = { $value }.
form-scene-enlarge = На весь екран
form-scene-record = Зберегти як зображення
form-scene-recorded = Зображення збережено
form-own-rows =
    { $rows ->
        [one] Поки що накреслено { $rows } рядок.
        [few] Поки що накреслено { $rows } рядки.
       *[other] Поки що накреслено { $rows } рядків.
    }

form-matrix-text = Як текст
form-matrix-text-label = { $name } як текст: LaTeX, MATLAB, Python або клітинки електронної таблиці
form-matrix-text-unread = У цьому тексті не розпізнано матриці 4×4.
form-name-unknown =
    { $known ->
        [none] { $name } не є розміром цього робота; розмірів із назвами в нього немає.
       *[other] { $name } не є розміром цього робота. Його розміри: { $names }.
    }

form-nav-lesson = Перший урок
form-term = Що означає «{ $term }»?
form-convention-what = Що це таке?
form-exercise-write = Зв’яжіть із кожною ланкою систему координат і запишіть таблицю DH цього робота.

form-why = Чому кожен рядок правильний
form-why-row = Рядок { $row }: осі z{ $before } і z{ $row }: { $relation }; тому α = { $alpha } і a = { $a }; уздовж z системи розділяє d = { $d }.
form-second-table = Друга правильна таблиця
form-second-other-convention = Угода інша: { $convention }.
form-second-axis-reversed = Вісь z спрямована протилежно, або змінна зчленування відлічується в протилежний бік.
form-second-x-turned = Вісь x спрямована інакше, тому змінна її зчленування дорівнює нулю в іншому положенні.
form-second-origin-moved = Початок координат лежить в іншій точці своєї осі.
form-second-none = Правила цієї вправи не залишають іншої таблиці.

form-ghost-label = Ваш прозорий робот поверх робота з вправи
form-ghost-text = Робот із вправи сірий з помаранчевим, ваш — прозорий червоний. Обидва роблять той самий рух. Позначена система координат { $row }, система рядка { $row }, — перша, що відходить від робота з вправи.
form-ghost-description = Ваш робот збігається з роботом із вправи до системи координат { $row }, яку позначено: там вони розходяться.
form-ghost-later = Зараз перевіряється так багато відповідей, що ще не намальовано, де ваш робот відходить від робота з вправи.
form-ghost-draw = Намалювати зараз
form-ghost-none = Вашого робота не можна намалювати поверх робота з вправи.
form-new = Нова
form-new-done = Нова, порожня таблиця.

form-progress = Поступ
form-progress-open = ще не зроблено
form-progress-typed = ще не перевірено
form-part-missing = не здано
form-part-empty = Тут ще нічого не написано.
form-submit-part = Перевірити цю частину
form-points-for = Хибна таблиця отримує бали за правильні кути скручення, довжини й зміщення, яких не мала б таблиця з нулів. Найдорожче коштує зчленування, якого бракує або яке має не той тип, найдешевше — помилка в знаку.
form-help-steps = по одній підказці
form-help-principle = Принцип.
form-help-worked = Розібраний крок на іншому роботі.
form-help-next = Щоб отримати наступну підказку, змініть відповідь і перевірте її ще раз.
form-principle-twist = Скручення α переводить одну вісь z у наступну, якщо дивитися вздовж осі x, перпендикулярної до обох. Паралельні осі z мають 0° або 180°, перпендикулярні — 90° або −90°; знак дає права рука з великим пальцем уздовж x.
form-principle-length = Довжина a — це відстань між двома сусідніми осями z уздовж їхнього спільного перпендикуляра, тобто осі x. Вона дорівнює 0 тоді й лише тоді, коли прямі перетинаються.
form-principle-offset = Зміщення d — це відстань уздовж осі z між двома основами: де приходить спільний перпендикуляр від попередньої осі і де виходить перпендикуляр до наступної. Якщо сусідні осі паралельні, можна обрати, де його поставити, але лише один раз.
form-principle-joint = Обертальне зчленування повертається навколо своєї осі z: його змінна — θ. Поступальне ковзає вздовж неї: його змінна — d. Кожне зчленування має один рядок, у порядку від основи до інструмента.
form-worked-twist = Плече, перша вісь якого вертикальна, а друга горизонтальна: обидві осі z перпендикулярні. Якщо x спрямовано до вас, права рука переводить вертикальну z у горизонтальну на −90° або 90°, залежно від обраного напряму z; отже α = −90° або 90°, ніколи не 0.
form-worked-length = Дві ланки в площині, 0,4 м і 0,3 м: обидві осі вертикальні, на відстані 0,4 м. Їхній спільний перпендикуляр — перша ланка, тому a = 0,4 м. У зап’ясті, осі якого перетинаються в одній точці, кожне a дорівнює 0.
form-worked-offset = Плече стоїть на 0,2 м збоку від першої, вертикальної осі, а друга вісь горизонтальна. Уздовж другої осі між основою перпендикуляра від першої осі та основою перпендикуляра до третьої — 0,2 м: d = 0,2 м, у рядку другого зчленування.
form-worked-joint = Портал рухає каретку по рейці й повертає захват під нею. Рейка — поступальне зчленування: її рядок має змінну в d і число в θ. Захват — обертальне: змінна в θ і число в d.
form-home-author = Створити вправу
form-home-author-text = Для викладачів: перетворіть маніпулятор зі свого підручника на вправу за чверть години.

form-matrices-withheld = Матриці з’являться тут, коли частини, що їх вимагають, будуть правильні.
form-sharing = Для викладачів: посилання й пакети
form-sharing-text = Посилання містить ці налаштування з підписом: хто прийшов за ним, не може їх змінити, а дотримання їх забезпечує сама служба. Пакет SCORM додається до курсу без адміністратора; його оцінка приходить із браузера студента, а квитанцію в коментарях підробити не можна.
form-sharing-may = Студенти можуть користуватися
form-sharing-catalogue = каталогом роботів
form-sharing-playground = майстернею
form-sharing-matrices = матрицями власної таблиці
form-sharing-trainer = тренажером систем координат
form-sharing-help = Що їм кажуть про хибну відповідь
form-sharing-attempts = Спроби
form-sharing-link = Створити посилання
form-sharing-receipts = Перевірити квитанції
form-receipt = Отримати квитанцію
form-receipt-text = У квитанції, яку підписує ця служба, зазначено, скільки балів отримала ця відповідь. Передайте її викладачеві: текстом, QR-кодом або надрукованою сторінкою.
form-receipt-name = Ваше ім’я, як його знає курс
form-receipt-as-text = Квитанція текстом
form-receipt-copy = Скопіювати текст
form-receipt-qr = Квитанція QR-кодом
form-receipt-pdf = Сторінка для друку (PDF)

form-part-frames = Системи координат
form-frames-hint = Довжини в { unit-word }. Напрям може мати будь-яку довжину.
form-frames-scene = Робот із вашими системами координат
form-frames-drawn = Намальовано { $drawn } з { $all } систем координат.
form-frames-frame = Система { $frame }
form-frames-z = z вказує
form-frames-origin = Початок
form-frames-x = x вказує
form-frames-z-of = z системи { $frame }
form-frames-origin-of = початок системи { $frame }
form-frames-x-of = x системи { $frame }
form-frames-ends = де лежать перша й остання системи
form-frames-typed = ввести …
form-frames-at-joint = біля корпуса зчленування { $joint }
form-frames-at-point = у { $name }
form-frames-at-ground = там, де закріплено робота
form-frames-along = уздовж осі зчленування { $joint }
form-frames-against = проти осі зчленування { $joint }
form-answer-empty = Нічого не здано. У вправі потрібно подати: { $parts }.
