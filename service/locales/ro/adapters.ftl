# Fișiere ale studenților, evaluatori ai altor sisteme, pachete SCORM, recipise.

error-file_too_large =
    { $file } depășește { $limit ->
        [one] { $limit } octet
        [few] { $limit } octeți
       *[other] { $limit } de octeți
    }; un tabel ocupă câțiva kiloocteți.
error-file_missing = Nu există niciun fișier sau dosar { $file }.
error-grade_path_needed = Este nevoie de un fișier, un dosar sau o arhivă zip: doar cu --for, - sau nimic înseamnă intrarea standard.
error-options_without_effect = { $options } nu ar avea niciun efect { $host ->
    [yes] cu --for
   *[no] fără --for
}.
error-marks_are_text = { $file } nu ar conține o foaie de calcul: notele se scriu ca text, pe care îl citesc programele de calcul tabelar. Dați fișierului un nume cu .csv.
error-file_unreadable = { $file } nu poate fi citit: { $reason ->
    [empty] este gol
    [binary] nu este un fișier text
    [columns] rândurile lui nu se pot împărți în coloane; salvați-l ca CSV
    [UTF-16] începe ca UTF-16, dar nu este UTF-16 până la capăt; salvați-l ca UTF-8
   *[other] { $reason }
}.
error-file_unusable = { $file } nu poate fi citit sau scris: { $reason }.
error-file_type_unknown = { $file } este de un tip care nu se citește aici. Se citesc { $known }.
error-file_without_table = { $file } nu conține niciun tabel DH. Un tabel are coloanele theta, d, a și alpha.
error-files_too_many =
    { $file } conține mai mult de { $limit ->
        [one] { $limit } fișier
        [few] { $limit } fișiere
       *[other] { $limit } de fișiere
    }.
error-rows_too_many =
    { $file } are mai mult de { $limit ->
        [one] { $limit } rând
        [few] { $limit } rânduri
       *[other] { $limit } de rânduri
    }. Împărțiți-l în mai multe fișiere.
error-columns_unknown = Niciun rând din { $file } nu numește coloanele { $known }. Scrieți-le deasupra tabelului.
error-columns_repeated = Titlurile { $titles } din { $file } desemnează aceeași coloană. Scrieți fiecare coloană o singură dată; decalajul unei cuple se scrie în celula ei: q1 + 90.
error-units_differ = Titlurile din { $file } numesc două unități pentru aceeași mărime: { $units }. Scrieți toate unghiurile într-o singură unitate și toate lungimile într-o singură unitate.
error-columns_differ_in_length = Coloanele din { $file } au lungimi diferite; fiecare are nevoie de o valoare pentru fiecare rând.
error-exercise_not_named = Nu se spune la ce exercițiu răspunde. Numiți-l, de exemplu puma560.
error-artefact_unknown = Aici nu se evaluează artefacte de tipul { $type }; se evaluează { $known }.
error-function_command_unknown = Această comandă nu este cunoscută. Comenzi cunoscute: { $known }.
error-function_call_invalid = Corpul unui apel are `response`, `answer` și `params` (un obiect). Greșit la: { $places }.
error-callback_not_allowed = Operatorul acestui serviciu nu permite trimiterea observațiilor la această adresă.
error-version_not_supported = Această versiune a API-ului de evaluare nu este suportată aici; este suportată { $supported }.

error-api_key_unknown = Nu există cheia { $id }.
error-key_file_unreadable = { $file } nu este un fișier de chei utilizabil: { $reason }.
error-receipt_kid_unknown = { $file } nu conține cheia { $id }.
error-receipt_malformed = Aceasta nu este o recipisă sau nu este întreagă. Copiați-o de la primul până la ultimul caracter.
error-receipt_key_unknown = Recipisa a fost semnată cu o cheie pe care acest serviciu nu o are. Întrebați serviciul care a emis-o.
error-receipt_altered = Recipisa a fost modificată după emitere.

evaluation-right = Corect
evaluation-wrong = Încă nu este corect
evaluation-readable = Răspunsul poate fi notat.
evaluation-unreadable = Răspunsul nu poate fi notat așa cum este; aceasta nu se socotește ca încercare.

scorm-no-script = Acest exercițiu are nevoie de JavaScript.
scorm-no-lms = Nu s-a găsit nicio platformă de învățare în jurul acestei pagini. Puteți exersa, dar nu se va înregistra nicio notă.

grade-summary = Corecte: { $right }; greșite: { $wrong }; care nu pot fi notate: { $ungraded }.
grade-left-out = Fișiere lăsate deoparte din cauza tipului: { $count } ({ $files }).
