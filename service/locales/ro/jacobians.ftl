task-jacobian-analytic =
    { $variables ->
        [own] Luați propriul tabel și propriile variabile ale cuplelor la aceste valori.
       *[given] Sunt date tabelul robotului și o configurație.
    } Scrieți jacobianul analitic: viteza ultimei origini în sistemul 0, apoi derivatele în raport cu timpul ale celor trei unghiuri în jurul axelor { $turning ->
            [fixed] fixe
           *[current] curente
        } { $axes }, în ordinea lor. În numere, lungimile în { unit-word }, pe radian.

task-jacobian-form =
    { $variables ->
        [own] Luați propriul tabel și propriile variabile ale cuplelor.
       *[given] Este dat tabelul robotului.
    } { $ask ->
        [jacobian] Scrieți jacobianul geometric al ultimei origini în formă închisă: elementele sale sunt funcții de variabilele cuplelor, pe radian.
        [forces] Scrieți momentele și forțele din cuple care corespund forței și momentului din ultima origine, τ = Jᵀ(f, m), ca funcții de variabilele cuplelor.
       *[both] Scrieți jacobianul geometric al ultimei origini în formă închisă, pe radian, și momentele și forțele din cuple τ = Jᵀ(f, m) care corespund forței și momentului din ultima origine.
    } { $frame ->
        [end] Toți vectorii sunt în axele ultimului sistem.
       *[base] Toți vectorii sunt în axele sistemului 0.
    }

task-jacobian-form-analytic =
    { $variables ->
        [own] Luați propriul tabel și propriile variabile ale cuplelor.
       *[given] Este dat tabelul robotului.
    } Scrieți jacobianul analitic: viteza ultimei origini în sistemul 0, apoi derivatele în raport cu timpul ale celor trei unghiuri în jurul axelor { $turning ->
            [fixed] fixe
           *[current] curente
        } { $axes }, în ordinea lor. Elementele sunt funcții de variabilele cuplelor.

feedback-jacobian_geometric = Ultimele trei rânduri sunt cele ale vitezei unghiulare; se cer derivatele unghiurilor.
feedback-jacobian_other_point = Acestea sunt vitezele altui punct; se cere cea a originii ultimului sistem.
feedback-jacobian_reversed =
    { $count ->
        [1] Coloana { $joint } are semnul opus: urmăriți în ce sens este îndreptată axa z.
       *[other] Coloanele { $joints } au semnul opus: urmăriți în ce sens este îndreptată axa z.
    }
feedback-jacobian_per_degree = Coloanele cuplelor de rotație sunt pe grad; se cer pe radian.
feedback-jacobian_other_unit = Lungimile sunt în altă unitate decât cea cerută.
feedback-jacobian_angles_locked = În această configurație, primul și ultimul unghi se rotesc în jurul aceleiași drepte: unghiurile nu au derivate și nu există jacobian analitic.
error-angles_locked = Primul și ultimul dintre unghiurile { $axes } se rotesc aici în jurul aceleiași drepte: nu există jacobian analitic. Alegeți alte unghiuri.
