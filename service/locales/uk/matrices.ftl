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
        [link] Таблиця правильна. Хтось записав матрицю її рядка { $row }, від системи { $row } до попередньої, і зробив одну помилку.
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
