field-cell_row = Rândul unui element greșit
field-cell_column = Coloana unui element greșit
field-mistake = Ce este greșit
field-mended_matrix = Matricea așa cum ar trebui să fie
option-entry_sign = un element al rotației are semnul greșit
option-sine_for_cosine = într-un element al rotației, sinusul și cosinusul au fost schimbate între ele
option-position_sign = un element al poziției are semnul greșit
option-position_missing = lipsește un element al poziției
option-position_sine_for_cosine = într-un element al poziției, sinusul și cosinusul au fost schimbate între ele
option-rotation_transposed = rotația este transpusă
option-matrix_other_convention = a fost formată în cealaltă convenție
option-link_missing = un element al lanțului a fost omis din produs
given-matrix-with-mistake =
    { $matrix ->
        [link] Matricea rândului { $row }, cu o greșeală
       *[transform] ⁰T_N, cu o greșeală
    }

task-matrix-mistake =
    { $matrix ->
        [link] Tabelul este corect. Cineva a scris matricea rândului { $row }, de la sistemul { $row } la cel dinainte, și a făcut o greșeală.
       *[transform] Tabelul este corect. Cineva a scris ⁰T_N, produsul tuturor matricelor sale, și a făcut o greșeală.
    } Dați un element greșit, spuneți ce nu este bine și scrieți întreaga matrice așa cum ar trebui să fie.

feedback-matrix_mistake_place_wrong = Acest element este corect; greșeala este în altă parte.
feedback-matrix_mistake_name_wrong = Greșeala este de alt fel.
feedback-matrix_not_mended = Aceasta nu este încă matricea tabelului.
feedback-matrix_mistake_missing =
    { $what ->
        [cell_row] Dați rândul și coloana unui element greșit.
        [mistake] Spuneți ce este greșit.
       *[mended_matrix] Scrieți matricea așa cum ar trebui să fie.
    }
