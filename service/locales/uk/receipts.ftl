### Сторінка, що перевіряє теку квитанцій.

receipts-title = Квитанції
receipts-lead = Перетягніть сюди файли, які здали студенти, або вставте їхні тексти: кожну квитанцію буде перевірено, а оцінки стануть файлом для Moodle чи Canvas.
receipts-files = Файли з квитанціями
receipts-paste = Або їхні тексти, один за одним
receipts-verify = Перевірити
receipts-none = Квитанцій ще немає.
receipts-found =
    { $all ->
        [1]
            { $valid ->
                [0] Квитанція не справжня.
               *[other] Квитанція справжня.
            }
        [one] Справжніх: { $valid } з { $all } квитанції.
       *[other] Справжніх: { $valid } з { $all } квитанцій.
    }
receipts-save-csv = CSV
receipts-save-moodle = CSV для Moodle
receipts-save-canvas = CSV для Canvas
receipts-name = Ім’я
receipts-exercise = Вправа
receipts-points = Бали
receipts-time = Час
receipts-settings = Налаштування
receipts-said = Висновок
receipts-genuine = справжня
receipts-repeated = справжня, але ще одна з цих квитанцій має ту саму відповідь
receipts-by-link = за посиланням викладача
receipts-answer = Відповідь
receipts-sign = Підписано службою { $service }. Код і текст нижче кажуть те саме; їх перевіряє { $page }.
