### Курси, збережені спроби та запуски з системи керування навчанням: що відхиляється і чому.

problem-title-401 = Вхід не виконано
problem-title-403 = Доступ закрито
problem-title-409 = Зараз неможливо

## Сховище

error-storage_folder = Теку даних { $folder } неможливо використати: { $reason }. Задайте у FRAMEWISE_DATA_FOLDER теку, доступну для запису, або FRAMEWISE_STORAGE=off.
error-storage_address = FRAMEWISE_DATABASE_URL не називає бази даних PostgreSQL. Вона має вигляд postgresql://користувач:пароль@сервер/база.
error-storage_unusable = Базу даних { $location } неможливо використати: { $reason }.
error-storage_unavailable = База даних зараз не відповідає. Усе підтверджене раніше збережено. Надішліть це ще раз за кілька секунд.
error-storage_missing = За адресою { $location } немає бази даних. FRAMEWISE_DATA_FOLDER або FRAMEWISE_DATABASE_URL має вказувати базу даних служби.
error-schema_newer = Дані записала новіша версія програми (схема { $found }; ця версія знає { $known }). Установіть новішу версію.
error-storage_not_empty = Резервну копію відновлюють лише в порожню базу даних; у відношенні { $table } вже є рядки.
error-backup_unreadable = { $file } неможливо прочитати чи записати як резервну копію: { $reason }.

## Спроби

error-record_unknown = { $kind ->
    [attempt] Такої спроби в цьому курсі немає.
    [person] Такої особи в цьому курсі немає.
    [anybody] Такої особи тут немає.
    [link] Такого посилання в цьому курсі немає.
    [platform] Такої платформи немає.
   *[other] Такого запису в цьому курсі немає.
}
error-attempts_not_open = Спроби приймаються з { TIME($opens) } UTC.
error-attempts_closed = Вправу закрито: { TIME($closes) } UTC.
error-attempts_used = { $allowed ->
    [one] Використано { $allowed } спробу — усі, що дозволяє ця вправа.
    [few] Використано { $allowed } спроби — усі, що дозволяє ця вправа.
   *[other] Використано { $allowed } спроб — усі, що дозволяє ця вправа.
}
error-exercise_changed = Вправу змінено після того, як ви відкрили цю сторінку, і нічого не здано. Оновіть сторінку: те, що ви ввели, збережено.
error-settings_changed = Ваші зміни не збережено: хтось інший зберіг інші правила після того, як ви відкрили цю сторінку. Оновіть сторінку й перегляньте їх.
error-regrading_outdated = Нічого не застосовано: вправа або правила посилання змінилися після обчислення цих балів, або застосовано інші бали. Оцініть знову.
error-setting_invalid = { $name } може бути: { $known }.
error-closes_before_opening = Вправа закрилася б раніше, ніж відкрилася.
error-session_expired = Ваш сеанс завершився. Введене вами збережено на цій сторінці: відкрийте вправу з курсу ще раз.
error-administrator_unknown = Цю сторінку відкривають за адресою, яку виводить framewise lti administer; вона діє один раз, протягом двох годин.
error-code_used = Цю адресу вже використано. Відкрийте вправу з курсу ще раз.
error-staff_only = Це доступно лише викладачам курсу.
error-publishing_closed =
    { $who ->
        [staff] Публікувати вправи тут можуть лише викладачі, що прийшли з курсу, або ті, хто має ключ із правом publish.
        [key] Публікувати вправи тут можна лише з ключем, що має право publish.
       *[nobody] На цій службі ніхто не може публікувати вправи.
    }
error-link_without_exercise = Для цього посилання ще не вибрано вправи. Її вибирає викладач, відкривши посилання.
error-invitation_used = Цю адресу реєстрації вже використано, або вона застаріла. Попросіть нову.
error-storage_off = Ця установка не зберігає курсів: сховище вимкнено.
error-posted_form_too_large =
    Форма більша за { $limit ->
        [one] { $limit } байт
        [few] { $limit } байти
       *[other] { $limit } байтів
    }.
error-form_invalid = Тіло запиту не є формою (application/x-www-form-urlencoded).
