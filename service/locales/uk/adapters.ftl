# Файли студентів, перевірники інших систем, пакети SCORM, квитанції.

error-file_too_large =
    { $file } займає понад { $limit ->
        [one] { $limit } байт
        [few] { $limit } байти
       *[other] { $limit } байтів
    }; таблиця займає кілька кілобайтів.
error-file_missing = Файлу чи теки { $file } немає.
error-grade_path_needed = Потрібен файл, тека або архів zip: лише з --for дефіс або відсутність аргументу означає стандартний ввід.
error-options_without_effect = { $options } не матиме дії { $host ->
    [yes] з --for
   *[no] без --for
}.
error-marks_are_text = { $file } не містив би електронної таблиці: оцінки записуються текстом, який читають табличні програми. Дайте файлу назву з .csv.
error-file_unreadable = { $file } не вдається прочитати: { $reason ->
    [empty] файл порожній
    [binary] це не текстовий файл
    [columns] його рядки не можна поділити на стовпці; збережіть його як CSV
    [UTF-16] він починається як UTF-16, але далі ним не є; збережіть його в UTF-8
   *[other] { $reason }
}.
error-file_unusable = { $file } неможливо прочитати або записати: { $reason }.
error-file_type_unknown = Файли такого типу, як { $file }, тут не читаються. Читаються { $known }.
error-file_without_table = { $file } не містить таблиці DH. Таблиця має стовпці theta, d, a та alpha.
error-files_too_many =
    { $file } містить понад { $limit ->
        [one] { $limit } файл
        [few] { $limit } файли
       *[other] { $limit } файлів
    }.
error-rows_too_many =
    { $file } має понад { $limit ->
        [one] { $limit } рядок
        [few] { $limit } рядки
       *[other] { $limit } рядків
    }. Поділіть його на кілька файлів.
error-columns_unknown = Жоден рядок у { $file } не називає стовпців { $known }. Напишіть їх над таблицею.
error-columns_repeated = Заголовки { $titles } у { $file } позначають один і той самий стовпець. Запишіть кожен стовпець один раз; зміщення зчленування пишеться в його клітинці: q1 + 90.
error-units_differ = Заголовки у { $file } називають дві одиниці для тієї самої величини: { $units }. Запишіть усі кути в одній одиниці, а всі довжини — в одній одиниці.
error-columns_differ_in_length = Стовпці в { $file } різної довжини; у кожному має бути по одному значенню на рядок.
error-exercise_not_named = Не сказано, на яку вправу це відповідь. Назвіть її, наприклад puma560.
error-artefact_unknown = Роботи типу { $type } тут не оцінюються; оцінюються { $known }.
error-function_command_unknown = Ця команда невідома. Відомі команди: { $known }.
error-function_call_invalid = Тіло виклику має `response`, `answer` і `params` (об’єкт). Помилки в: { $places }.
error-callback_not_allowed = Оператор цієї служби не дозволяє надсилати відгуки на цю адресу.
error-version_not_supported = Ця версія API оцінювання тут не підтримується; підтримується { $supported }.

error-api_key_unknown = Ключа { $id } немає.
error-key_file_unreadable = { $file } не є придатним файлом ключів: { $reason }.
error-receipt_kid_unknown = У { $file } немає ключа { $id }.
error-receipt_malformed = Це не квитанція або не вся квитанція. Скопіюйте її від першого символу до останнього.
error-receipt_key_unknown = Квитанцію підписано ключем, якого ця служба не має. Зверніться до служби, що її видала.
error-receipt_altered = Квитанцію змінено після видачі.

evaluation-right = Правильно
evaluation-wrong = Ще не правильно
evaluation-readable = Відповідь можна оцінити.
evaluation-unreadable = Відповідь у такому вигляді оцінити не можна; це не рахується за спробу.

scorm-no-script = Для цієї вправи потрібен JavaScript.
scorm-no-lms = Навколо цієї сторінки не знайдено навчальної платформи. Ви можете вправлятися, але оцінку не буде записано.

grade-summary = Правильних: { $right }, неправильних: { $wrong }, таких, що їх не можна оцінити: { $ungraded }.
grade-left-out = Файли, пропущені через їхній тип: { $count } ({ $files }).
