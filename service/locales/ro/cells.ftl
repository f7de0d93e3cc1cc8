# De ce este respinsă o celulă, un tabel sau un parametru.

error-cell_empty = Celula este goală. Dacă valoarea este zero, scrieți 0.
error-cell_dash = Această celulă nu conține nicio valoare. Dacă valoarea este zero, scrieți 0.
error-cell_not_a_value =
    O celulă conține un număr sau o expresie sub formă de text, nu { $kind ->
        [list] o listă
        [dict] un obiect
       *[other] { $kind }
    }.
error-cell_too_long =
    Celula are { $length ->
        [one] { $length } caracter
        [few] { $length } caractere
       *[other] { $length } de caractere
    }; se citesc cel mult { $limit }.
error-cell_too_deep =
    Expresia din celulă depășește { $limit ->
        [one] { $limit } nivel
        [few] { $limit } niveluri
       *[other] { $limit } de niveluri
    } de imbricare.
error-cell_too_many_symbols =
    Celula conține peste { $limit ->
        [one] { $limit } nume
        [few] { $limit } nume diferite
       *[other] { $limit } de nume diferite
    }.

error-character_not_allowed = La caracterul { $column }: { $character } nu are sens într-o celulă.
error-character_invisible = La caracterul { $column }: există un caracter invizibil sau de control ({ $character }). Ștergeți-l.
error-character_lookalike = La caracterul { $column }: { $character } doar seamănă cu litera latină { $latin }. Tastați { $latin }.
error-character_full_width = La caracterul { $column }: { $character } este un caracter de lățime dublă. Tastați { $latin }.
error-dollar_misplaced = La caracterul { $column }: $ poate doar să încadreze întreaga celulă.
error-command_unknown = La caracterul { $column }: comanda \{ $command } nu este recunoscută.
error-script_misplaced = La caracterul { $column }: { $character } nu urmează după nimic de care să țină.

error-number_malformed = La caracterul { $column }: { $text } nu este un număr zecimal. Scrieți cifre și un singur punct, fără separatori.
error-number_too_long =
    La caracterul { $column }: un număr poate avea cel mult { $limit ->
        [one] { $limit } cifră
        [few] { $limit } cifre
       *[other] { $limit } de cifre
    }.
error-number_out_of_range =
    { $size ->
        [small] La caracterul { $column }: acest număr este prea apropiat de 0 ca să fie citit. Scrieți 0.
       *[large] La caracterul { $column }: valoarea absolută a unui număr este cel mult { $largest }.
    }
error-cell_not_finite = O celulă conține doar numere finite; NaN și infinit sunt respinse.
error-decimal_comma = La caracterul { $column }: scrieți punct zecimal în loc de virgulă: { $suggestion }.
error-minutes_in_cell = La caracterul { $column }: minutele și secundele de arc nu se citesc. În zecimale, { $text } este { $suggestion }.
error-about_in_cell = La caracterul { $column }: o celulă spune care este valoarea, fără { $character }. Scrieți { $suggestion }.

error-names_run_together = La caracterul { $column }: { $text } este lipit de ceea ce urmează. Scrieți produsul cu *.
error-name_malformed = La caracterul { $column }: liniuța de subliniere stă doar între literă și indice, ca în L_1.
error-name_too_long =
    La caracterul { $column }: un nume poate avea cel mult { $limit ->
        [one] { $limit } caracter
        [few] { $limit } caractere
       *[other] { $limit } de caractere
    }.
error-name_is_not_a_number = La caracterul { $column }: { $name } nu este o valoare. O celulă conține doar numere finite.
error-unit_in_cell = La caracterul { $column }: unitățile nu se scriu în celule. Dacă unitatea cerută este { $name }, scrieți { $suggestion }; dacă nu, convertiți mai întâi.
error-function_unknown = La caracterul { $column }: { $name } nu este o funcție. Funcțiile sunt { $functions }. Un produs se scrie { $name }*(…).
error-function_without_parentheses =
    La caracterul { $column }: scrieți argumentul lui { $name } între paranteze: { $name }({ $name ->
        [atan2] y, x
        [arctan2] y, x
       *[other] x
    }).
error-function_arity =
    { $expected ->
        [one] La caracterul { $column }: { $name } are un singur argument, nu { $given }.
       *[other] La caracterul { $column }: { $name } are { $expected } argumente, nu { $given }.
    }

error-value_missing = La caracterul { $column }: lipsește o valoare înainte de { $symbol }.
error-cell_incomplete = La caracterul { $column }: celula se termină acolo unde ar trebui să urmeze o valoare.
error-symbol_misplaced = La caracterul { $column }: { $symbol } nu poate sta aici.
error-comma_misplaced = La caracterul { $column }: virgula separă doar cele două argumente ale funcției atan2.
error-parenthesis_not_closed = La caracterul { $column }: această paranteză nu este închisă.
error-parenthesis_not_opened = La caracterul { $column }: această paranteză nu închide nimic.
error-number_after_value = La caracterul { $column }: un număr nu poate urma direct după o valoare. Lipsește un operator?
error-division_ambiguous = La caracterul { $column }: nu este clar la ce se împarte. Scrieți a/(b*c) sau (a/b)*c.
error-exponent_ambiguous = La caracterul { $column }: { $text } poate însemna { $number } sau { $difference }. Scrieți una dintre ele.

error-exponent_not_constant = La caracterul { $column }: exponentul este un număr rațional.
error-exponent_out_of_range = La caracterul { $column }: exponentul, ca și numitorul lui, este în valoare absolută cel mult { $limit }.
error-division_by_zero = La caracterul { $column }: aici se împarte la zero.
error-value_not_real = Celula nu are o valoare reală finită.
error-degree_of_angle = La caracterul { $column }: semnul de grad se pune după un număr; aici este deja un unghi.
error-degree_in_length = La caracterul { $column }: o lungime nu se exprimă în grade.
error-angle_in_length = La caracterul { $column }: { $name } dă un unghi în grade, care nu este o lungime.
error-angle_product = La caracterul { $column }: se înmulțesc două unghiuri. Un unghi se înmulțește doar cu numere.
error-angle_in_denominator = La caracterul { $column }: se împarte la un unghi. Aici se poate împărți doar la numere.
error-angle_power = La caracterul { $column }: un unghi nu se ridică la putere.
error-parameter_two_kinds =
    La caracterul { $column }: { $name } este aici { $kind ->
        [angle] un unghi
       *[length] o lungime
    }, iar în altă parte { $other ->
        [angle] un unghi
       *[length] o lungime
    }. Folosiți două nume.

error-variable_without_number = La caracterul { $column }: { $name } are nevoie de numărul cuplei sale, ca în { $suggestion }.
error-variable_misspelled = La caracterul { $column }: { $name } nu este variabila unei cuple. Scrieți { $suggestion } sau θ cu numărul cuplei.
error-variable_called = La caracterul { $column }: { $name } este variabila unei cuple, deci nu este urmată de nimic între paranteze. Scrieți constanta ca termen al unei sume: { $name } + ….
error-variable_scaled = La caracterul { $column }: { $name } este înmulțită cu { $factor }. Variabila unei cuple apare ca +{ $name } sau -{ $name }; altfel nu ar mai fi mișcarea cuplei sale.
error-variable_in_product = La caracterul { $column }: { $name } este înmulțită cu altă mărime. Variabila unei cuple apare ca +{ $name } sau -{ $name }, plus o constantă.
error-variable_in_denominator = La caracterul { $column }: { $name } stă la numitor. Variabila unei cuple apare ca +{ $name } sau -{ $name }, plus o constantă.
error-variable_in_power = La caracterul { $column }: { $name } este ridicată la putere. Variabila unei cuple apare ca +{ $name } sau -{ $name }, plus o constantă.
error-variable_in_function = La caracterul { $column }: { $name } stă în interiorul unei funcții. Celula conține chiar variabila cuplei; sinusurile și cosinusurile rezultă din tabel.
error-variable_in_constant_cell = La caracterul { $column }: { $name } stă la { $cell }. Lungimea și unghiul de torsiune ale unui element nu variază; variabila unei cuple stă la θ (rotație) sau la d (translație).
error-variable_in_fixed_row = La caracterul { $column }: { $name } stă într-un rând declarat fix. Un rând fix nu are variabilă.
error-variable_in_wrong_cell =
    La caracterul { $column }: { $name } stă la { $cell }, dar variabila unei cuple de { $joint ->
        [prismatic] translație
       *[revolute] rotație
    } stă la { $expected }.
error-variable_twice = La caracterul { $column }: { $name } apare a doua oară. Fiecare variabilă apare în tabel o singură dată.
error-variable_of_other_row = La caracterul { $column }: variabila acestui rând nu este { $name }, ci { $expected }. Dacă acționările a două cuple sunt legate între ele, ca în { $expected } + { $name }, scrieți doar { $expected }; valoarea ei este suma.
error-variable_numbering_mixed = La caracterul { $column }: { $name } este numerotată după rând, iar altele după cuplă. Numerotați-le de la q1 la q{ $joints }, în ordinea cuplelor.

error-table_empty = Tabelul nu are niciun rând; este nevoie de cel puțin unul.
error-table_too_many_rows =
    Tabelul are { $rows ->
        [one] { $rows } rând
        [few] { $rows } rânduri
       *[other] { $rows } de rânduri
    }; se citesc cel mult { $limit }.
error-table_too_long =
    Celulele au împreună { $length ->
        [one] { $length } caracter
        [few] { $length } caractere
       *[other] { $length } de caractere
    }; se citesc cel mult { $limit }.
error-table_too_many_parameters =
    Tabelul conține peste { $limit ->
        [one] { $limit } parametru
        [few] { $limit } parametri diferiți
       *[other] { $limit } de parametri diferiți
    }.

error-parameter_missing = Parametrul { $name } nu are valoare.
error-parameter_unused = Tabelul nu conține parametrul { $name }.
error-parameter_not_finite = Valoarea lui { $name } trebuie să fie un număr finit.
error-parameter_name_invalid = { $name } nu este nume de parametru. Un nume este un cuvânt cu indice, ca L1.
error-parameter_given_twice = { $name } și { $other } sunt același parametru. Dați valoarea lui o singură dată.
