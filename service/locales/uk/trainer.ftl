# Тренажер систем координат.

trainer-title = Тренажер систем координат
trainer-heading = Призначте системи координат
trainer-lead = Система за системою, у порядку лекції: усі осі z, спільні перпендикуляри, початки координат, усі осі x. Кожен крок перевіряється наприкінці; потім зчитується таблиця DH.
trainer-back = Назад до вправи
trainer-frames = Системи координат
trainer-table = Таблиця, що випливає
trainer-scene = Осі та системи координат
trainer-click = Клацніть на стрілці чи точці або перетягніть її, щоб вибрати; те саме можна зробити у списках.
trainer-complete = Усі системи відповідають угоді: таблиця повна.
trainer-unfinished = Рядок з’являється, щойно обидві його системи повні й не порушують правил.
trainer-status =
    { $broken ->
        [0] Поки що жодного правила не порушено.
        [one] Порушено { $broken } правило.
        [few] Порушено { $broken } правила.
       *[other] Порушено { $broken } правил.
    }
trainer-step = Система { $frame }: { $state }
trainer-state-open = не завершена
trainer-state-whole = повна
trainer-state-broken = порушує правило
trainer-part-z = Напрям z, система { $frame }
trainer-part-origin = Початок, система { $frame }
trainer-part-x = Напрям x, система { $frame }
trainer-opposite = протилежно:
trainer-candidate-foot = на осі { $axis }, в основі перпендикуляра до осі { $other }
trainer-candidate-intersection = де перетинаються осі { $axis } і { $other }
trainer-candidate-level = на осі { $axis }, на рівні початку системи { $frame }
trainer-candidate-axis_point = на осі { $axis }, де намальовано зчленування
trainer-candidate-base = як у заданій системі основи
trainer-candidate-tool = як у заданій системі інструмента
trainer-candidate-coordinates =
    { $axis ->
        [1] уздовж X координат рисунка
        [2] уздовж Y координат рисунка
        [3] уздовж Z координат рисунка
       *[other] початок координат рисунка
    }
trainer-candidate-axis = уздовж осі { $axis }
trainer-candidate-normal = уздовж перпендикуляра до осей { $axis } і { $other }
trainer-candidate-frame_x = уздовж x системи { $frame }
trainer-candidate-across = перпендикулярно до осі { $axis }

trainer-step-z = Осі z
trainer-step-normals = Спільні перпендикуляри
trainer-step-origin = Початки координат
trainer-step-x = Осі x
trainer-step-read = Зчитування
trainer-task-z = Виберіть для кожної системи координат напрям z. Він лежить на осі зчленування; якого саме, залежить від угоди.
trainer-task-normals = Спільні перпендикуляри сусідніх осей накреслено. З них випливають початки координат і осі x.
trainer-task-origin = Виберіть початок кожної системи координат. Спільні перпендикуляри накреслено.
trainer-task-x = Виберіть для кожної системи координат напрям x. Він іде вздовж спільного перпендикуляра до наступної осі z, а де осі перетинаються, перпендикулярний до обох осей z.
trainer-normal-skew = Осі { $axis } та { $other } мимобіжні: вони мають один спільний перпендикуляр, його накреслено.
trainer-normal-meet = Осі { $axis } та { $other } перетинаються: x перпендикулярна до обох, а початок координат лежить у точці перетину.
trainer-normal-parallel = Осі { $axis } та { $other } паралельні або збігаються: годиться будь-який спільний перпендикуляр; виберіть той, за якого d дорівнює нулю.
trainer-check = Перевірити цей крок
trainer-onward = Далі
trainer-restart = Почати знову
trainer-step-done = Цей крок правильний.
trainer-why-z =
    Кожна z лежить уздовж осі свого зчленування: { $convention ->
        [standard] z системи i−1 вздовж осі i, бо рядок i повертає на θ і зсуває на d відносно z системи i−1.
       *[modified] z системи i вздовж осі i, бо рядок i закінчується поворотом θ і зсувом d відносно z системи i.
    }
trainer-why-origin = Кожен початок стоїть там, де спільний перпендикуляр перетинає його вісь, бо звідти вздовж x вимірюють a.
trainer-why-x = Кожна x лежить на спільному перпендикулярі або перпендикулярна до обох осей, бо a та α вимірюють уздовж неї та навколо неї.
trainer-open-choice = Для системи { $frame } ще нічого не вибрано.
trainer-point-missed = Початок системи { $frame } має бути в позначеній точці { $point }.
trainer-read = Натисніть номер рядка: рисунок показує, як чотири числа переводять одну систему координат у наступну.
trainer-take = Перенести таблицю у вправу
