# Відмови самої служби HTTP.

problem-title-400 = Запит неможливо прочитати
problem-title-404 = Не знайдено
problem-title-405 = Цей метод тут недоступний
problem-title-406 = Немає прийнятного формату відповіді
problem-title-408 = Запит надходив занадто довго
problem-title-413 = Запит завеликий
problem-title-415 = Такий вид тіла запиту не підтримується
problem-title-422 = Запит неможливо виконати в такому вигляді
problem-title-500 = Збій служби
problem-title-503 = Служба зайнята

error-body_missing = Запит не має тіла. Надішліть об’єкт JSON.
error-body_invalid = Тіло запиту неможливо прочитати. Надішліть об’єкт JSON у кодуванні UTF-8.
error-json_not_utf8 = Тіло запиту не в UTF-8, як цього вимагає JSON.
error-json_too_deep = Документ JSON має завелику глибину вкладеності.
error-json_not_finite = Рядок { $line }, стовпець { $column }: число має бути скінченним. У JSON немає NaN і нескінченності.
error-json_invalid = Тіло запиту не є JSON: рядок { $line }, стовпець { $column }. Аналізатор повідомляє: { $reason }.
error-json_duplicate_key = Ключ «{ $key }» трапляється двічі в одному об’єкті. Залиште один із них.
error-json_too_many_values =
    Тіло містить забагато: читається щонайбільше { $limit ->
        [one] { $limit } значення
        [few] { $limit } значення
       *[other] { $limit } значень
    }, полів, списків або об’єктів.
error-json_too_many_fields =
    Об’єкт у тілі має { $given ->
        [one] { $given } поле
        [few] { $given } поля
       *[other] { $given } полів
    }; жоден виклик не має більше ніж { $limit }.
error-body_timed_out = Тіло не надійшло за { $seconds } с. Надсилайте його швидше або меншими частинами.
error-content_encoding_unsupported = Стиснені тіла запитів не читаються. Надішліть тіло без Content-Encoding.
error-charset_unsupported = Тіло запиту оголошено як { $charset }. JSON читається лише в UTF-8.
error-media_type_unsupported =
    { $given ->
        [none] Запит не повідомляє, що є його тілом.
       *[other] Тіло запиту оголошено як { $given }.
    } Цей виклик читає { $offers }: зазначте це в заголовку Content-Type.
error-not_acceptable = Цей виклик відповідає у форматі { $offers }; заголовок Accept виключає все це.
error-body_too_large =
    Тіло запиту більше за { $limit ->
        [one] { $limit } байт
        [few] { $limit } байти
       *[other] { $limit } байтів
    } — найбільше, що читає цей виклик.
error-method_not_allowed = Ця адреса підтримує { $allowed }, але не { $method }.
error-address_unknown = За адресою { $path } нічого немає. Усі виклики перелічено в документі /api/v1/openapi.json.
error-problem_unknown = Жодна відмова не має коду { $code }.
error-internal_error = Служба не змогла виконати цей запит. Повідомте про це, вказавши ідентифікатор { $id }.
error-busy = Сервер зайнятий. Спробуйте знову через { $seconds } с.

error-field_missing = Бракує поля «{ $field }».
error-field_unknown = Поля «{ $field }» тут немає. Можливі поля: { $allowed }.
error-target_or_position = Задайте рівно одне з «target», «targets» і «position»; з положенням — щонайбільше одне з «quaternion» і «axis».
error-table_or_robot = Задайте або «table», або «robot» — рівно одне з двох.
error-number_expected = «{ $field }» має бути числом.
error-number_not_finite = «{ $field }» має бути скінченним числом.
error-number_too_small =
    { $bound ->
        [excluded] Число має бути більшим за { $limit }.
       *[included] Число має бути не менше ніж { $limit }.
    }
error-number_too_large =
    { $bound ->
        [excluded] Число має бути меншим за { $limit }.
       *[included] Число має бути не більше ніж { $limit }.
    }
error-integer_expected = «{ $field }» має бути цілим числом.
error-boolean_expected = «{ $field }» має бути true або false.
error-string_expected = «{ $field }» має бути текстом.
error-string_too_long =
    Текст задовгий: читається не більше ніж { $limit ->
        [one] { $limit } символ
        [few] { $limit } символи
       *[other] { $limit } символів
    }.
error-string_too_short =
    Текст закороткий: потрібно щонайменше { $limit ->
        [one] { $limit } символ
        [few] { $limit } символи
       *[other] { $limit } символів
    }.
error-string_pattern = Текст не має очікуваного вигляду, { $pattern }.
error-list_expected = «{ $field }» має бути списком.
error-list_too_long =
    Список задовгий: у ньому може бути не більше ніж { $limit ->
        [one] { $limit } елемент
        [few] { $limit } елементи
       *[other] { $limit } елементів
    }.
error-list_too_short =
    Список закороткий: потрібно щонайменше { $limit ->
        [one] { $limit } елемент
        [few] { $limit } елементи
       *[other] { $limit } елементів
    }.
error-object_expected = «{ $field }» має бути об’єктом з іменованими полями.
error-body_not_object = Тіло запиту має бути об’єктом JSON з іменованими полями.
error-null_expected = «{ $field }» має бути null або відсутнє.
error-value_not_allowed = Значення має бути одним із таких: { $expected }.
error-value_invalid = Це значення неможливо використати: { $reason }.

error-joints_wrong_dimensions = Масив змінних зчленувань має один або два виміри, а не { $dimensions }: (зчленування) або (конфігурації, зчленування).
error-batch_too_large =
    У пакеті { $given ->
        [one] { $given } конфігурація
        [few] { $given } конфігурації
       *[other] { $given } конфігурацій
    }; за один запит обчислюється не більше ніж { $limit }.
error-query_missing = Змінні зчленувань надійшли як npy; решту запиту подайте як JSON у параметрі запиту «request».
error-npy_header_invalid =
    Тіло запиту не є файлом npy, як його записує numpy.save: { $rule ->
        [magic] він має починатися з \x93NUMPY, версії та довжини заголовка
        [version] його версія має бути 1.0, 2.0 або 3.0
        [header] його заголовок має бути повним, не довшим за 4096 байт і називати descr, fortran_order і shape
       *[shape] shape має бути кортежем розмірів, які може мати масив
    }.
error-npy_length_mismatch =
    Заголовок npy обіцяє { $promised ->
        [one] { $promised } байт
        [few] { $promised } байти
       *[other] { $promised } байтів
    } даних; за ним іде { $present }.
error-npy_object_refused = Файл npy містить об’єкти Python, які ніколи не десеріалізуються. Надішліть масив чисел.
error-npy_type_unsupported = Файл npy містить { $type }. Надішліть дійсні числа, наприклад float64 (<f8).
error-npy_one_part = Файл npy містить один масив. Назвіть одну частину: { $allowed }.
error-one_source = Опишіть робота рівно одним способом: { $allowed }.

error-api_key_missing = У запиті немає ключа. Надішліть його як Authorization: Bearer fwk_….
error-api_key_invalid = Цей ключ тут невідомий, прострочений або відкликаний.
error-api_key_scope = Цей ключ призначено для { $scopes }; виклик потребує { $needed }.
error-idempotency_key_length = Idempotency-Key має від 1 до { $limit } символів.
error-idempotency_key_in_use = Запит із цим Idempotency-Key ще виконується. Спробуйте знову через секунду.
error-idempotency_key_reused = Цей Idempotency-Key уже використано для іншого запиту. Для нового запиту візьміть новий ключ.
error-rate_exceeded =
    Перевищено межу в { $limit ->
        [one] { $limit } одиницю
        [few] { $limit } одиниці
       *[other] { $limit } одиниць
    } вартості за хвилину. Спробуйте ще раз через { $seconds } с.
error-setting_missing = Бракує налаштування { $name }.
problem-title-429 = Забагато запитів
error-quaternion_or_axis = Задайте щонайбільше одне з «quaternion» і «axis».

language-name = Українська
