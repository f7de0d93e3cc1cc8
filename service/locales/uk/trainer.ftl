# Тренажер систем координат.

trainer-title = Тренажер систем координат
trainer-heading = Призначте системи координат
trainer-lead = Для кожної системи оберіть напрямок z, початок і напрямок x. Кожне правило перевіряється одразу, а таблиця DH випливає з ваших систем.
trainer-back = Назад до вправи
trainer-frames = Системи координат
trainer-table = Таблиця, що випливає
trainer-scene = Осі та системи координат
trainer-click = Натисніть точку або стрілку, щоб обрати; списки роблять те саме.
trainer-clear = Очистити цю систему
trainer-next = Наступна система
trainer-complete = Усі системи відповідають конвенції: таблиця повна.
trainer-unfinished = Рядок з’являється, щойно обидві його системи повні й не порушують правил.
trainer-status =
    { $broken ->
        [0] Поки що жодного правила не порушено.
        [one] Порушено { $broken } правило.
        [few] Порушено { $broken } правила.
       *[other] Порушено { $broken } правил.
    }
trainer-open = Відкрити таблицю в майстерні
trainer-step = Система { $frame }: { $state }
trainer-state-open = не завершена
trainer-state-whole = повна
trainer-state-broken = порушує правило
trainer-part-z = Напрямок z, система { $frame }
trainer-part-origin = Початок, система { $frame }
trainer-part-x = Напрямок x, система { $frame }
trainer-opposite = протилежно:
trainer-candidate-foot = на осі { $axis }, в основі перпендикуляра до осі { $other }
trainer-candidate-intersection = де перетинаються осі { $axis } і { $other }
trainer-candidate-level = на осі { $axis }, на рівні початку системи { $frame }
trainer-candidate-axis_point = на осі { $axis }, де намальовано зчленування
trainer-candidate-base = як у заданій системі основи
trainer-candidate-tool = як у заданій системі інструмента
trainer-candidate-coordinates =
    { $axis ->
        [1] уздовж x системи відліку
        [2] уздовж y системи відліку
        [3] уздовж z системи відліку
       *[other] початок системи відліку
    }
trainer-candidate-axis = уздовж осі { $axis }
trainer-candidate-normal = уздовж перпендикуляра до осей { $axis } і { $other }
trainer-candidate-frame_x = уздовж x системи { $frame }
trainer-candidate-across = упоперек осі { $axis }
