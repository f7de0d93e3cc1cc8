# Fișierele catalogului de roboți.

error-catalogue_not_toml = Acesta nu este TOML: { $reason }.
error-catalogue_key_missing = Lipsește { $key }.
error-catalogue_key_unknown = { $key } nu este o cheie cunoscută. Cheile cunoscute sunt { $known }.
error-catalogue_value_type = { $key } trebuie să fie { expected-value }.
error-catalogue_limits_reversed = Cupla { $joint }: limita inferioară trebuie să fie mai mică decât cea superioară.
error-catalogue_outside_limits = Cupla { $joint } iese din limite în această configurație.
error-robot_unknown = Catalogul nu conține robotul { $robot }. Conține { $known }.
expected-value = { $expected ->
    [text] un text nevid
    [texts] o listă de texte
    [number] un număr a cărui valoare absolută este cel mult 10^15
    [integer] un număr întreg
    [count] un număr întreg cel puțin egal cu 1
    [flag] true sau false
    [table] un tabel
    [tables] o listă de tabele
    [cell] un număr sau o expresie
    [cells] o listă de { $count } numere sau expresii
    [choice] una dintre valorile: { $known }
    [direction] o listă de trei numere, nu toate nule
    [point_names] o listă de { $count } nume de puncte
    [point_chains] o listă de liste cu cel puțin două nume de puncte
    [help_levels] o listă cu cel puțin un nivel de ajutor
    [numbers] { $count ->
        [0] o listă de numere finite
       *[other] o listă de { $count } numere finite
    }
    [rows] { $count ->
        [0] o listă de liste cu câte { $width } elemente
       *[other] o listă de { $count } liste cu câte { $width } elemente
    }
   *[other] de alt tip
}
