### Exerciții: ce se cere, ce se spune despre răspunsuri, ce nu poate conține o definiție.

## Figura în cuvinte

figure-title = { $title }: cuple, axe și cote
figure-coordinates = { $joints ->
    [one] Un robot cu o singură cuplă.
    [few] Un robot cu { $joints } cuple, una după alta, numărate de la bază.
   *[other] Un robot cu { $joints } de cuple, una după alta, numărate de la bază.
} Pozițiile sunt date în { unit-word } sub forma (X; Y; Z). { figure-place }
figure-place = X arată { $x ->
    [back] în spate, Y la stânga
    [left] la stânga, Y în față
    [front] în față, Y la dreapta
   *[right] la dreapta, Y în spate
}, Z în sus; { $fixed ->
    [ground] robotul este fixat
   *[joint] corpul cuplei 1 se află
} la { $at }.
figure-joint-revolute = Cupla { $joint } este de rotație. Corpul ei se află la { $place }; axa ei { $course ->
    [vertical] este verticală
    [sideways] este orientată de la stânga la dreapta
    [depthways] este orientată din față în spate
   *[oblique] este orientată după { $direction }
}.
figure-joint-revolute-signed = Cupla { $joint } este de rotație. Corpul ei se află la { $place }; axa ei { $course ->
    [vertical] este verticală
    [sideways] este orientată de la stânga la dreapta
    [depthways] este orientată din față în spate
   *[oblique] este oblică
}. După regula mâinii drepte, variabila cuplei este pozitivă în jurul direcției { $direction }.
figure-joint-prismatic = Cupla { $joint } este de translație. Corpul ei se află la { $place }; direcția ei { $course ->
    [vertical] este verticală
    [sideways] este de la stânga la dreapta
    [depthways] este din față în spate
   *[oblique] este { $direction }
}.
figure-joint-prismatic-signed = Cupla { $joint } este de translație. Corpul ei se află la { $place }; direcția ei { $course ->
    [vertical] este verticală
    [sideways] este de la stânga la dreapta
    [depthways] este din față în spate
   *[oblique] este oblică
}. Variabila cuplei este pozitivă de-a lungul direcției { $direction }.
figure-dimension = { $name } este { $length } { $unit }, măsurată { $course ->
    [vertical] pe verticală
    [sideways] de la stânga la dreapta
    [depthways] din față în spate
   *[oblique] oblic
}, între { $start } și { $end }.
figure-point = Punctul { $name } se află la { $place }.
figure-frame = Sistemul { $number } are originea în { $place }; axa sa x este orientată după { $x }, iar axa z după { $z }.
figure-not-to-scale = Desenul nu este la scară: în el, { $names } { $count ->
    [one] nu are lungimea dată
   *[other] nu au lungimile date
} aici.
figure-note = nu este la scară

## Ce este liber și ce este impus

rule-convention-any = Se acceptă atât convenția standard, cât și cea modificată.
rule-convention-standard = Scrieți tabelul în convenția standard.
rule-convention-modified = Scrieți tabelul în convenția modificată.
rule-base-free = Sistemul 0 poate fi plasat oriunde pe bază.
rule-base-axis = Axa z a sistemului 0 este pe axa cuplei 1, în oricare dintre sensuri.
rule-base-origin = Originea sistemului 0 este punctul marcat O0; direcțiile lui le alegeți dumneavoastră.
rule-base-frame = Sistemul 0 este impus; figura îl arată.
rule-tool-free = Ultimul sistem poate fi plasat oriunde pe ultimul element.
rule-tool-point = Originea ultimului sistem se află în punctul marcat { $points }.
rule-tool-axis = Axa z a ultimului sistem este pe axa ultimei cuple, în oricare dintre sensuri; originea lui poate fi oriunde pe ea.
rule-tool-frame = Ultimul sistem este impus; figura îl arată.
rule-zero-free = Alegeți dumneavoastră unde este zero fiecare variabilă a cuplelor.
rule-zero-figure = În configurația din figură, toate variabilele cuplelor sunt zero.
rule-direction-free = Alegeți dumneavoastră sensul fiecărei axe.
rule-direction-figure = Variabilele cuplelor sunt pozitive în sensul săgeților din figură.

## Ce se cere

task-schematic = Descrieți structura: tipul fiecărei cuple și cum este așezată axa fiecărei cuple față de axa următoarei.
task-table = Alegeți sistemele de coordonate și scrieți tabelul DH. Celulele pot conține { $names }, numere și variabilele cuplelor q1 … q{ $n }.
task-link-matrices = Pentru fiecare rând al tabelului, scrieți matricea elementului, adică situarea sistemului i în sistemul i−1. Puteți prescurta cos(q1) ca c1 și sin(q1 + q2) ca s12.
task-transform = Scrieți ⁰T, situarea ultimului sistem în sistemul 0, în formă închisă.
task-pose = Evaluați ⁰T pentru { $joints } și pentru cotele date aici, cu lungimile în { unit-word }.
task-workspace-axis = Cât de aproape de axa cuplei 1 poate fi adus { $point } și cât de departe de ea? { $limits ->
    [none] Fiecare cuplă poate lua orice valoare.
   *[some] Cuplele își respectă limitele: { $ranges }; în figură, { $drawn }.
} Dați ambele raze în { unit-word }.
task-workspace-point = Care sunt distanța minimă și cea maximă de la { $point } la { $origin }? { $limits ->
    [none] Fiecare cuplă poate lua orice valoare.
   *[some] Cuplele își respectă limitele: { $ranges }; în figură, { $drawn }.
} Dați ambele raze în { unit-word }.

## Comentarii la părți

feedback-part_wrong = Această parte nu este încă corectă.
feedback-schematic_right = Structura este corectă.
feedback-schematic_joint_count = Ați indicat { $given ->
    [one] o cuplă
    [few] { $given } cuple
   *[other] { $given } de cuple
}; numărați din nou câte se pot mișca.
feedback-schematic_joint_type = Tipul cuplei { $joint } nu este corect.
feedback-schematic_relation = Poziția relativă a axelor { $first } și { $second } nu este corectă.
feedback-schematic_angle_right = Axele { $first } și { $second }: unghiul dintre ele este corect, dar nu și dacă se intersectează.
feedback-schematic_meeting_right = Axele { $first } și { $second } se intersectează într-adevăr, dar nu sub acest unghi.
feedback-matrices_right = Matricele elementelor sunt corecte.
feedback-matrices_follow_table = Matricele elementelor rezultă din tabelul dumneavoastră și își primesc punctele, deși tabelul nu este corect.
feedback-matrices_right_not_from_table = Matricele elementelor sunt corecte pentru robot, deși nu rezultă din tabelul dumneavoastră.
feedback-matrices_product_wrong = Înmulțite între ele, matricele elementelor nu descriu acest robot.
feedback-matrix_missing = Lipsește matricea { $matrix }.
feedback-matrix_wrong = Matricea { $matrix } nu corespunde rândului { $matrix } din tabel.
feedback-matrix_cells_wrong = Matricea { $matrix } diferă de rândul { $matrix } din tabel în aceste celule (rând,coloană): { $cells }.
feedback-matrix_inverse = Matricea { $matrix } este inversată: este situarea sistemului i−1 în sistemul i.
feedback-matrix_rotation_transposed = Rotația din matricea { $matrix } este transpusă.
feedback-matrix_other_convention = Matricea { $matrix } a fost formată după regula celeilalte convenții.
feedback-matrix_without_variable = Matricea { $matrix } a fost scrisă pentru variabila cuplei egală cu zero; păstrați variabila.
feedback-matrix_of_other_row = Matricea { $matrix } este cea a rândului { $other }.
feedback-matrix_not_rigid = Matricea { $matrix } nu este o mișcare rigidă: coloanele nu sunt versori perpendiculari, sau formează un triedru stâng (determinant −1), sau ultimul rând nu este 0 0 0 1.
feedback-transform_right = ⁰T este corectă.
feedback-transform_follows_table = ⁰T rezultă din tabelul dumneavoastră și își primește punctele, deși tabelul nu este corect.
feedback-transform_right_not_from_table = ⁰T este corectă pentru robot, deși nu rezultă din tabelul dumneavoastră.
feedback-table_says_little = Tabelul dumneavoastră are mai puțin de jumătate din lungimile și unghiurile α necesare pentru a descrie acest robot; ce rezultă din el primește doar o parte din puncte, iar dintr-un tabel de zerouri, niciunul.
feedback-transform_wrong = Această matrice ⁰T nu descrie robotul.
feedback-transform_rotation_right = Rotația din ⁰T este corectă.
feedback-transform_position_right = Poziția din ⁰T este corectă.
feedback-transform_cells_wrong = ⁰T diferă de tabelul dumneavoastră în aceste celule (rând,coloană): { $cells }.
feedback-transform_not_rigid = ⁰T nu este o mișcare rigidă: coloanele nu sunt versori perpendiculari, sau formează un triedru stâng (determinant −1), sau ultimul rând nu este 0 0 0 1.
feedback-transform_inverse = Aceasta este inversa lui ⁰T: situarea sistemului 0 în ultimul sistem.
feedback-transform_rotation_transposed = Rotația din ⁰T este transpusă.
feedback-transform_order_reversed = Matricele elementelor au fost înmulțite în ordine inversă.
feedback-transform_links_missing = Acesta este produsul doar până la sistemul { $last }; continuați până la ultimul sistem.
feedback-pose_right = Situarea este corectă.
feedback-pose_follows_table = Situarea rezultă din tabelul dumneavoastră și își primește punctele, deși tabelul nu este corect.
feedback-pose_wrong = Aceasta nu este situarea pe care o dă tabelul dumneavoastră pentru aceste valori ale cuplelor.
feedback-pose_last_row = Ultimul rând al unei situări este 0 0 0 1; cu altul, matricea nu este o situare și nu primește puncte.
feedback-pose_rotation_right = Rotația este corectă.
feedback-pose_position_right = Poziția este corectă.
feedback-pose_inverse = Aceasta este inversa situării.
feedback-pose_rotation_transposed = Rotația este transpusă.
feedback-pose_degrees_as_radians = Sinusurile și cosinusurile au fost calculate cu gradele luate drept radiani.
feedback-workspace_right = Ambele raze sunt corecte.
feedback-workspace_inner_wrong = Raza interioară nu este corectă.
feedback-workspace_outer_wrong = Raza exterioară nu este corectă.
feedback-workspace_swapped = Raza interioară și cea exterioară au fost schimbate între ele.
feedback-workspace_diameters = Acestea sunt diametre; se cer razele.
feedback-workspace_other_length_unit = Razele sunt corecte în altă unitate; se cer în { unit-word }.

## De ce nu poate fi notat un răspuns

problem-note-ungraded = Acest răspuns nu a fost notat și nu consumă nicio încercare.
error-answer_empty = Nu s-a predat nimic. Exercițiul cere { $known }.
error-part_not_asked = Exercițiul nu cere { $part }; el cere { $known }.
error-link_matrices_count = Tabelul are { $expected ->
    [one] un rând
    [few] { $expected } rânduri
   *[other] { $expected } de rânduri
}, dar { $given ->
    [one] este dată o matrice
    [few] sunt date { $given } matrice
   *[other] sunt date { $given } de matrice
}. Dați câte una pentru fiecare rând; null sare peste una.
error-link_matrices_need_table = Fără tabel, matricele elementelor sunt judecate după produsul lor. Dați-le pe toate.
error-pose_needs_table = Situarea este cea a tabelului dumneavoastră. Predați și tabelul.
error-matrix_not_4x4 = O matrice are patru rânduri cu câte patru celule.
error-joint_variable_unknown = Nu există { $name }; robotul are { $joints ->
    [one] o cuplă
    [few] { $joints } cuple
   *[other] { $joints } de cuple
}.{ $summed ->
    [0] {""}
   *[other] {" "}O sumă se scrie desfășurat: { $sum }.
}
error-short_form_unknown = { $name } este citit ca un cosinus sau un sinus, dar nu toți indicii lui sunt cuple de rotație; robotul are { $joints ->
    [one] o cuplă
    [few] { $joints } cuple
   *[other] { $joints } de cuple
}.
error-radius_negative = O rază nu poate fi negativă.
error-schematic_fixed_joint = Structura enumeră cuplele care se mișcă: de rotație sau de translație.
error-schematic_relations_count = { $joints ->
    [one] O cuplă are
    [few] { $joints } cuple au
   *[other] { $joints } de cuple au
} { $expected ->
    [one] o pereche
    [few] { $expected } perechi
   *[other] { $expected } de perechi
} de axe vecine. Dați câte o relație pentru fiecare pereche.
error-seed_invalid = O sămânță este un text sau un număr întreg.
error-seed_too_long =
    O sămânță are cel mult { $limit ->
        [one] { $limit } caracter
        [few] { $limit } caractere
       *[other] { $limit } de caractere
    }.
error-exercise_unknown = Nu există exercițiul { $id }. Disponibile: { $known }.
error-language_unknown = Limba { $language } nu este disponibilă aici. Disponibile: { $known }.

## De ce nu poate fi citită o definiție

error-exercise_file_missing = Lipsește fișierul exercise.toml.
error-exercise_file_not_toml = Acesta nu este TOML: { $reason }
error-exercise_key_missing = Lipsește { $key }.
error-exercise_key_unknown = { $key } nu este o cheie cunoscută. Cheile cunoscute sunt { $known }.
error-exercise_value_type = { $key } trebuie să fie { expected-value }.
error-exercise_value_unknown = { $key } trebuie să fie una dintre valorile: { $known }.
error-exercise_robot_unknown = Catalogul nu conține robotul { $robot }. Conține { $known }.
error-exercise_limits_reversed = Limitele cuplei { $joint } se dau ca [minim, maxim].
error-exercise_limits_unknown = Catalogul nu cunoaște limitele acestui robot.
error-folder_missing = Nu există dosarul { $folder }.
error-exercise_id_invalid = { $id } nu este identificatorul unui exercițiu; un identificator are litere, cifre și cratime simple.
error-exercise_exists = Exercițiul { $id } există deja.
error-source_unreadable = Fișierul nu poate fi citit: { $reason }
error-robot_and_reference = Dați fie robot, fie [reference], nu pe amândouă.
error-statement_missing = Lipsește enunțul în limba { $language }.
error-statement_name_unknown = { $name } nu este nici cotă a robotului, nici punct sau cotă din figură.
error-misconception_unknown = { $name } nu este o greșeală din listă. Disponibile: { $known }.
error-nothing_asked = Un exercițiu trebuie să ceară ceva: adăugați o parte.
error-part_twice = { $kind } se cere de două ori.
error-points_not_positive = O parte valorează mai mult de zero puncte.
error-draw_empty = Nu există nicio valoare din care să se tragă la sorți: „from” nu poate depăși „to”, iar „step” trebuie să fie pozitiv.
error-draw_too_large =
    O tragere la sorți are cel mult { $limit ->
        [one] { $limit } valoare
        [few] { $limit } valori
       *[other] { $limit } de valori
    }.
error-variants_too_many =
    Sunt cel mult { $limit ->
        [one] { $limit } variantă
        [few] { $limit } variante
       *[other] { $limit } de variante
    }.
error-tolerance_out_of_range = { $name } este între 0 și 0,1.
error-name_invalid = { $name } nu este numele unei cote; un nume arată ca L1.
error-width_out_of_range = Lățimea este între 320 și 960.
error-unknown_point = Nu există punctul { $name }. Disponibile: { $known }.
error-unknown_frame = Acest sistem de coordonate nu există: sunt numerotate de la 0 la { $last }.
error-unknown_joint = Nu există cupla { $joint }: sunt numerotate de la 1 la { $last }.
error-point_without_form = Un punct se dă prin frame și at; prin between și ratio; prin from și by; sau prin from, joint și distance.
error-joint_off_axis = Punctul { $point } nu se află pe axa cuplei { $joint }.
error-dimension_disagrees = Punctele cotei { $name } se află la { $length } unul de altul, dar { $name } este { $value }.
error-dimension_too_short = { $name } este { $length }, prea puțin pentru a fi arătată în figură: este sub o milionime din mărimea robotului. Dați-i altă valoare sau scrieți 0 în locul ei.
error-posture_not_zero = Cu zero = figure, studenții sunt informați că în configurația din figură toate variabilele cuplelor sunt zero: desenați robotul în acea configurație (posture 0 pentru fiecare cuplă) sau lăsați zerourile libere.
error-tool_point_unmarked = Cu tool = point, ultima origine trebuie să fie într-un punct marcat, dar niciunul dintre punctele marcate nu este ultima origine a rezolvării de referință. Marcați originea sistemului { $last }.
error-gripper_without_direction = Prehensorul și punctul de la care pornește direcția lui coincid.
error-jaws_along_gripper = Fălcile stau una lângă alta, perpendicular pe prehensor.

error-name_unknown = { $name } nu este niciuna dintre cotele acestui exercițiu.{ $unit ->
    [0] {""}
   *[one] {" "}Unitățile nu se scriu în celule: dacă { $name } este una, omiteți-o.
}{ $found ->
    [0] {""}
   *[one] {" "}Ați vrut să scrieți { $close }?
} Se cunosc { $known }.
error-need_unmet = Cu aceste reguli niciun răspuns nu are nevoie de { $name }: se pot alege sisteme în care nu apare. { $rules ->
    [none] Nicio regulă nu schimbă acest lucru: scoateți-o din needs.
   *[other] Oricare dintre aceste reguli o face necesară: { $rules }.
}
error-need_unknown = { $name } nu este o cotă a tabelului. Cotele lui: { $known }.
error-alias_taken = { $name } are deja un înțeles.
error-title_missing = Este nevoie de un titlu în cel puțin o limbă: [title] cu en = "…".
exercise-other-language = Acest exercițiu nu este încă scris în limba dumneavoastră. Limba textului: { $language }.
rule-dimension-free = { $names } nu trebuie să apară neapărat în tabel: cu sisteme alese potrivit, dispare.
error-context_invalid = Această legătură nu a fost creată aici sau a fost modificată.
error-context_expired = Această legătură a expirat.
error-switched_off = { $path } este dezactivat pentru acest exercițiu.
error-attempts_used_up =
    { $limit ->
        [one] Singura încercare a fost folosită.
        [few] Toate cele { $limit } încercări au fost folosite.
       *[other] Toate cele { $limit } de încercări au fost folosite.
    }
error-ladder_falls = La fiecare încercare se poate spune cel puțin cât la cea dinainte, niciodată mai puțin.
task-frames = Așezați sistemele 0 până la { $n } pe robotul din figură: pentru fiecare originea, în { unit-word } și în coordonatele figurii, și direcțiile axelor x și z. { figure-place }
error-frames_count = Există sistemele 0 până la N: sunt necesare { $expected }, au fost date { $given }.
error-convention_not_asked = Exercițiul cere convenția { $asked ->
    [modified] modificată
   *[standard] standard
}.
error-weight_out_of_range = Ponderea lui { $name } este un număr de la 0 la { $most }.
