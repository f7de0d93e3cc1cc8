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
        [link] Tabelul este corect. Cineva a scris matricea rândului { $row }, situarea sistemului { $row } în cel dinainte, și a făcut o greșeală.
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

field-wrong_frame = Sistemul de coordonate cu greșeala
field-mended_origin = Originea sa, așa cum ar trebui să fie
field-mended_x = Axa sa x, așa cum ar trebui să fie
field-mended_y = Axa sa y, așa cum ar trebui să fie
field-mended_z = Axa sa z, așa cum ar trebui să fie
option-z_not_along_axis = z nu este de-a lungul axei cuplei sale
option-origin_not_on_axis = originea nu este pe axa cuplei sale
option-origin_not_on_common_normal = originea nu este pe perpendiculara comună
option-origin_not_at_intersection = originea nu este în punctul de intersecție al celor două axe
option-x_not_across_z = x nu este perpendiculară pe z
option-x_not_along_common_normal = x nu este de-a lungul perpendicularei comune
option-x_not_across_both_axes = x nu este perpendiculară pe ambele axe
option-first_x_misses_axis = axa x a primului sistem nu intersectează axa 1 în unghi drept
option-last_x_misses_axis = axa x a ultimului sistem nu intersectează ultima axă în unghi drept
option-y_left_handed = sistemul este stâng: y nu este z × x
given-drawn-frames = Sistemele de coordonate așa cum sunt desenate

task-frame-mistake =
    { $convention ->
        [standard] Sistemele de coordonate din figură ar trebui să respecte convenția standard, cu axa z a sistemului i de-a lungul cuplei i+1
       *[modified] Sistemele de coordonate din figură ar trebui să respecte convenția modificată, cu axa z a sistemului i de-a lungul cuplei i
    }, dar unul dintre ele are o greșeală. Care sistem este greșit, ce este greșit la el și cum ar trebui să stea? Punctele și direcțiile sunt date în coordonatele figurii; lungimea unei direcții nu contează. { figure-place }

feedback-frame_mistake_place_wrong = Acest sistem este corect; greșeala este în altul.
feedback-frame_mistake_name_wrong = Greșeala este de alt fel.
feedback-frame_not_mended = Cu acest sistem desenul încă încalcă o regulă.
feedback-frame_mistake_missing =
    { $what ->
        [wrong_frame] Spuneți care sistem este greșit.
        [mistake] Spuneți ce este greșit.
       *[mended_origin] Dați originea, x, y și z așa cum ar trebui să fie.
    }
