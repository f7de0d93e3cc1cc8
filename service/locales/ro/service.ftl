# Refuzurile serviciului HTTP.

problem-title-400 = Cererea nu poate fi citită
problem-title-404 = Nu a fost găsit
problem-title-405 = Metoda nu este disponibilă aici
problem-title-406 = Niciun format de răspuns acceptabil
problem-title-408 = Cererea a sosit prea încet
problem-title-413 = Cererea este prea mare
problem-title-415 = Acest tip de corp nu este acceptat
problem-title-422 = Cererea nu poate fi executată în forma actuală
problem-title-500 = Serviciul a eșuat
problem-title-503 = Serviciul este ocupat

error-body_missing = Cererea nu are corp. Trimiteți un obiect JSON.
error-body_invalid = Corpul cererii nu poate fi citit. Trimiteți un obiect JSON în UTF-8.
error-json_not_utf8 = Corpul cererii nu este UTF-8, așa cum cere JSON.
error-json_too_deep = Documentul JSON are prea multe niveluri de imbricare.
error-json_not_finite = Linia { $line }, coloana { $column }: un număr trebuie să fie finit. JSON nu cunoaște NaN și nici infinit.
error-json_invalid = Corpul cererii nu este JSON: linia { $line }, coloana { $column }. Analizorul spune: { $reason }.
error-json_duplicate_key = Cheia „{ $key }” apare de două ori în același obiect. Păstrați una singură.
error-json_too_many_values =
    Corpul conține prea mult: se citesc cel mult { $limit ->
        [one] { $limit } valoare
        [few] { $limit } valori
       *[other] { $limit } de valori
    }, câmpuri, liste sau obiecte.
error-json_too_many_fields =
    Un obiect din corp are { $given ->
        [one] { $given } câmp
        [few] { $given } câmpuri
       *[other] { $given } de câmpuri
    }; niciun apel nu are mai mult de { $limit }.
error-body_timed_out = Corpul nu a sosit în { $seconds } s. Trimiteți-l mai repede sau în părți mai mici.
error-content_encoding_unsupported = Corpurile comprimate nu sunt citite. Trimiteți corpul fără Content-Encoding.
error-charset_unsupported = Corpul este anunțat ca { $charset }. JSON este citit numai în UTF-8.
error-media_type_unsupported =
    { $given ->
        [none] Cererea nu spune ce conține corpul ei.
       *[other] Corpul este anunțat ca { $given }.
    } Acest apel citește { $offers }: precizați aceasta în antetul Content-Type.
error-not_acceptable = Acest apel răspunde în { $offers }; antetul Accept le exclude pe toate.
error-body_too_large =
    Corpul are mai mult de { $limit ->
        [one] { $limit } octet
        [few] { $limit } octeți
       *[other] { $limit } de octeți
    }, cât citește cel mult acest apel.
error-method_not_allowed = Această adresă acceptă { $allowed }, dar nu și { $method }.
error-address_unknown = La { $path } nu există nimic. Documentul /api/v1/openapi.json enumeră toate apelurile.
error-problem_unknown = Niciun refuz nu are codul { $code }.
error-internal_error = Serviciul a eșuat la această cerere. Semnalați problema cu identificatorul { $id }.
error-busy = Serverul este ocupat. Încercați din nou peste { $seconds } s.

error-field_missing = Câmpul „{ $field }” lipsește.
error-field_unknown = Aici nu există câmpul „{ $field }”. Câmpurile sunt: { $allowed }.
error-target_or_position = Dați exact unul dintre „target”, „targets” și „position”; cu o poziție, cel mult unul dintre „quaternion” și „axis”.
error-table_or_robot = Dați fie „table”, fie „robot”: exact unul dintre ele.
error-number_expected = „{ $field }” trebuie să fie un număr.
error-number_not_finite = „{ $field }” trebuie să fie un număr finit.
error-number_too_small =
    { $bound ->
        [excluded] Numărul trebuie să fie mai mare decât { $limit }.
       *[included] Numărul trebuie să fie cel puțin { $limit }.
    }
error-number_too_large =
    { $bound ->
        [excluded] Numărul trebuie să fie mai mic decât { $limit }.
       *[included] Numărul trebuie să fie cel mult { $limit }.
    }
error-integer_expected = „{ $field }” trebuie să fie un număr întreg.
error-boolean_expected = „{ $field }” trebuie să fie true sau false.
error-string_expected = „{ $field }” trebuie să fie text.
error-string_too_long =
    Textul este prea lung: se { $limit ->
        [one] citește cel mult un caracter
        [few] citesc cel mult { $limit } caractere
       *[other] citesc cel mult { $limit } de caractere
    }.
error-string_too_short =
    Textul este prea scurt: { $limit ->
        [one] este necesar cel puțin un caracter
        [few] sunt necesare cel puțin { $limit } caractere
       *[other] sunt necesare cel puțin { $limit } de caractere
    }.
error-string_pattern = Textul nu are forma așteptată, { $pattern }.
error-list_expected = „{ $field }” trebuie să fie o listă.
error-list_too_long =
    Lista este prea lungă: poate avea cel mult { $limit ->
        [one] un element
        [few] { $limit } elemente
       *[other] { $limit } de elemente
    }.
error-list_too_short =
    Lista este prea scurtă: are nevoie de cel puțin { $limit ->
        [one] un element
        [few] { $limit } elemente
       *[other] { $limit } de elemente
    }.
error-object_expected = „{ $field }” trebuie să fie un obiect cu câmpuri numite.
error-body_not_object = Corpul trebuie să fie un obiect JSON cu câmpuri numite.
error-null_expected = „{ $field }” trebuie să fie null sau să lipsească.
error-value_not_allowed = Valoarea trebuie să fie una dintre: { $expected }.
error-value_invalid = Această valoare nu poate fi folosită: { $reason }.

error-joints_wrong_dimensions = Un tablou de variabile ale cuplelor are una sau două dimensiuni, nu { $dimensions }: (cuple) sau (configurații, cuple).
error-batch_too_large =
    Lotul are { $given ->
        [one] { $given } configurație
        [few] { $given } configurații
       *[other] { $given } de configurații
    }; într-o cerere se calculează cel mult { $limit }.
error-query_missing = Variabilele cuplelor au venit ca npy; restul cererii se dă ca JSON în parametrul de interogare „request”.
error-npy_header_invalid =
    Corpul nu este un fișier npy așa cum îl scrie numpy.save: { $rule ->
        [magic] trebuie să înceapă cu \x93NUMPY, versiunea și lungimea antetului
        [version] versiunea trebuie să fie 1.0, 2.0 sau 3.0
        [header] antetul trebuie să fie complet, să aibă cel mult 4096 de octeți și să numească descr, fortran_order și shape
       *[shape] shape trebuie să fie un tuplu de dimensiuni pe care le poate avea un tablou
    }.
error-npy_length_mismatch =
    Antetul npy promite { $promised ->
        [one] { $promised } octet
        [few] { $promised } octeți
       *[other] { $promised } de octeți
    } de date; urmează { $present }.
error-npy_object_refused = Fișierul npy conține obiecte Python, care nu sunt niciodată deserializate. Trimiteți un tablou de numere.
error-npy_type_unsupported = Fișierul npy conține { $type }. Trimiteți numere reale, de exemplu float64 (<f8).
error-npy_one_part = Un fișier npy conține un singur tablou. Numiți o singură parte: { $allowed }.
error-one_source = Descrieți robotul într-un singur fel: { $allowed }.

error-api_key_missing = Cererea nu indică nicio cheie. Trimiteți-o ca Authorization: Bearer fwk_….
error-api_key_invalid = Această cheie nu este cunoscută aici, a expirat sau a fost revocată.
error-api_key_scope = Această cheie este pentru { $scopes }; apelul cere { $needed }.
error-idempotency_key_length =
    Un Idempotency-Key are între 1 și { $limit ->
        [one] { $limit } caracter
        [few] { $limit } caractere
       *[other] { $limit } de caractere
    }.
error-idempotency_key_in_use = O cerere cu acest Idempotency-Key este încă în lucru. Încercați din nou peste o secundă.
error-idempotency_key_reused = Acest Idempotency-Key a fost folosit pentru altă cerere. Folosiți o cheie nouă pentru o cerere nouă.
error-rate_exceeded =
    S-a depășit limita de { $limit ->
        [one] { $limit } unitate
        [few] { $limit } unități
       *[other] { $limit } de unități
    } de cost pe minut. Încercați din nou peste { $seconds } s.
error-setting_missing = Lipsește setarea { $name }.
problem-title-429 = Prea multe cereri
error-quaternion_or_axis = Dați cel mult unul dintre „quaternion” și „axis”.

language-name = Română
