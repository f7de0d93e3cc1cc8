field-cell_row = Рядок неправильного елемента
field-cell_column = Стовпець неправильного елемента
field-mistake = Що неправильно
field-mended_matrix = Матриця, якою вона має бути
option-entry_sign = один елемент повороту має неправильний знак
option-sine_for_cosine = в одному елементі повороту сплутано синус і косинус
option-position_sign = один елемент положення має неправильний знак
option-position_missing = бракує одного елемента положення
option-position_sine_for_cosine = в одному елементі положення сплутано синус і косинус
option-rotation_transposed = поворот транспоновано
option-matrix_other_convention = її складено за іншою угодою
option-link_missing = у добутку пропущено одну ланку
given-matrix-with-mistake =
    { $matrix ->
        [link] Матриця рядка { $row } з помилкою
       *[transform] ⁰T_N з помилкою
    }

task-matrix-mistake =
    { $matrix ->
        [link] Таблиця правильна. Хтось записав матрицю її рядка { $row }, позу системи { $row } у попередній, і зробив одну помилку.
       *[transform] Таблиця правильна. Хтось записав ⁰T_N, добуток усіх її матриць, і зробив одну помилку.
    } Укажіть один неправильний елемент, скажіть, що не так, і запишіть усю матрицю, якою вона має бути.

feedback-matrix_mistake_place_wrong = Цей елемент правильний; помилка в іншому місці.
feedback-matrix_mistake_name_wrong = Помилка іншого виду.
feedback-matrix_not_mended = Це ще не матриця цієї таблиці.
feedback-matrix_mistake_missing =
    { $what ->
        [cell_row] Укажіть рядок і стовпець неправильного елемента.
        [mistake] Скажіть, що неправильно.
       *[mended_matrix] Запишіть матрицю, якою вона має бути.
    }

field-wrong_frame = Система координат з помилкою
field-mended_origin = Її початок, яким він має бути
field-mended_x = Її вісь x, якою вона має бути
field-mended_y = Її вісь y, якою вона має бути
field-mended_z = Її вісь z, якою вона має бути
option-z_not_along_axis = z не лежить уздовж осі свого зчленування
option-origin_not_on_axis = початок не лежить на осі свого зчленування
option-origin_not_on_common_normal = початок не лежить на спільному перпендикулярі
option-origin_not_at_intersection = початок не там, де перетинаються дві осі
option-x_not_across_z = x не перпендикулярна до z
option-x_not_along_common_normal = x не лежить уздовж спільного перпендикуляра
option-x_not_across_both_axes = x не перпендикулярна до обох осей
option-first_x_misses_axis = x першої системи не перетинає вісь 1 під прямим кутом
option-last_x_misses_axis = x останньої системи не перетинає останню вісь під прямим кутом
option-y_left_handed = система ліва: y не дорівнює z × x
given-drawn-frames = Системи координат, як їх накреслено

task-frame-mistake =
    { $convention ->
        [standard] Системи координат на рисунку мають відповідати стандартній угоді, з віссю z системи i уздовж зчленування i+1
       *[modified] Системи координат на рисунку мають відповідати модифікованій угоді, з віссю z системи i уздовж зчленування i
    }, але в одній з них є помилка. Яка система хибна, що в ній не так і як вона має стояти? Точки й напрями подано в координатах рисунка; довжина напряму довільна. { figure-place }

feedback-frame_mistake_place_wrong = Ця система правильна; помилка в іншій.
feedback-frame_mistake_name_wrong = Помилка іншого виду.
feedback-frame_not_mended = З цією системою рисунок усе ще порушує якесь правило.
feedback-frame_mistake_missing =
    { $what ->
        [wrong_frame] Укажіть, яка система хибна.
        [mistake] Укажіть, що не так.
       *[mended_origin] Укажіть початок, x, y та z, якими вони мають бути.
    }
