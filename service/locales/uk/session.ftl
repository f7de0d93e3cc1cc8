### Запуски з курсу та те, що читає студент після входу.

session-launch-title = Відкриття вправи
session-registration-title = Реєстрація навчальної платформи
session-new-window = Відкрити в новому вікні
session-registered = Framewise зареєстровано в { $issuer }. Адміністратор Framewise активує реєстрацію; після цього можна створювати посилання.
session-registered-again = Framewise знову зареєстровано в { $issuer }; посилання працюють, як і раніше.
session-tool-description = Вправи з кінематики роботів: приймається будь-який правильний вибір систем координат, а помилкові таблиці пояснюються.
session-heading = Ваш сеанс
session-signed-in = Ви ввійшли як { $name } · { $course }
session-attempts = Спроби: { $made }
session-attempts-of = Спроби: { $made } з { $allowed }
session-hand-in = Здати
session-hand-in-ready = Здати те, що готове
session-counting = { $counting ->
    [first] Зараховується перша спроба
   *[last] Зараховується остання спроба
}
session-penalty = Кожна наступна спроба коштує { $percent } усіх балів
session-closes = Закривається: { $when }
session-grade =
    Зараховано: { $points } з { $total ->
        [one] { $total } бала
       *[other] { $total } балів
    }
session-gradebook = Для журналу: { $percent }
session-no-more = Зараз спроби не приймаються
session-back = Назад до курсу
session-received = Спробу { $attempt } отримано й збережено. Результат буде показано пізніше.
session-draft-other = Показано те, що ви ввели останнім. Є ще інша версія вашої відповіді, від { $when }.
session-draft-take = Показати іншу версію
session-exercise-changed = Вправу змінено після однієї з попередніх спроб
session-attempt-then = Спробу { $attempt } зроблено до зміни вправи. Її результат стосується вправи в тодішньому вигляді.
session-exercise-then = Переглянути вправу в тодішньому вигляді
session-opens = Відкривається: { $when }
session-late = Закрито: спроби вже не зараховуються
session-handed-in = здано
session-attempts-kept = Зберігаються у вашому курсі.
session-attempts-latest = Тут показано останні { $count }.
session-ended = Ваш сеанс завершився: відповіді, дані тут, не зараховуються. Відкрийте вправу з курсу ще раз; введене там збережено.
session-elsewhere = У вашому курсі задано іншу вправу: відповіді на цю не зараховуються.
session-elsewhere-go = Відкрити вправу з курсу
session-launch-by-hand = Навчальні платформи надсилають сюди студентів, тому сама ця адреса нічого не показує. Відкрийте вправу зі свого курсу.
