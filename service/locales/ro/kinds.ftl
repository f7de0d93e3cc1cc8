### Feluri de întrebări: ce se cere și ce se spune despre răspunsuri.

field-matrix = Matrice
field-component_order = Ordinea componentelor cuaternionului
field-quaternion = Cuaternion
field-axis = Axa de rotație
field-angle = Unghiul de rotație
field-angles = Triplete de unghiuri
field-middle = La blocaj cardanic: unghiul din mijloc
field-combination = La blocaj cardanic: ce combinație a primului și ultimului unghi este determinată
field-value = Valoarea ei
field-matrix_claim = Această matrice
field-pose_claim = Această situare
field-position_claim = Această poziție
field-pose = Situare
option-wxyz = w, x, y, z: scalarul întâi
option-xyzw = x, y, z, w: scalarul la sfârșit
option-sum = suma: primul + ultimul
option-difference = diferența: primul − ultimul
option-rotation = este o rotație
option-unit_columns = nu este o rotație: o coloană nu are lungimea 1
option-perpendicular_columns = nu este o rotație: două coloane nu sunt perpendiculare
option-right_handed = nu este o rotație: coloanele formează un triedru stâng (determinant −1)
given-rotation = Orientarea ca matrice de rotație
given-quaternion = Orientarea ca un cuaternion unitar
given-axis_angle = Orientarea ca axă și unghi
given-angles = Orientarea în unghiuri
given-matrix = Matricea
given-frame-pose = Situarea sistemului { $end } în sistemul { $start }

task-orientation =
    { $given ->
        [angles] Un sistem de coordonate este rotit cu trei unghiuri în jurul axelor { $turning ->
            [fixed] fixe
           *[current] curente
        } { $axes }, în această ordine.
       *[other] Este dată orientarea unui sistem de coordonate.
    } Scrieți-o în notațiile de mai jos.{ $ask ->
        [every] {" "}Din unghiurile în jurul axelor { $asked_turning ->
            [fixed] fixe
           *[current] curente
        } { $asked_axes } se cer toate tripletele: amândouă sau, la blocaj cardanic, unghiul din mijloc și combinația determinată a celorlalte două.
        [one] {" "}Din unghiurile în jurul axelor { $asked_turning ->
            [fixed] fixe
           *[current] curente
        } { $asked_axes } este suficient un triplet.
       *[none] {""}
    }
task-rotation-check = Este această matrice o rotație? Dacă nu, spuneți ce proprietate a rotațiilor nu este îndeplinită.
task-frame-chain = Situările de mai jos sunt cunoscute. Scrieți situarea sistemului { $end } în sistemul { $start } ca matrice 4×4, lungimile în { unit-word }.
feedback-orientation_right = Toate notațiile descriu orientarea dată.
feedback-orientation_wrong =
    { $notation ->
        [matrix] Matricea nu este cea a acestei orientări.
        [quaternion] Cuaternionul nu este cel al acestei orientări.
        [axis_angle] Axa și unghiul nu sunt cele ale acestei orientări.
        [angles] Unghiurile nu sunt cele ale acestei orientări.
       *[other] Unghiurile nu sunt toate corecte sau lipsesc unele.
    }
feedback-orientation_missing =
    { $notation ->
        [matrix] Matricea lipsește.
        [quaternion] Cuaternionul lipsește.
        [axis_angle] Axa și unghiul lipsesc.
       *[other] Unghiurile lipsesc.
    }

feedback-rotation_transposed = Aceasta este rotația inversă: rândurile și coloanele, sau sensul de rotire, au fost schimbate între ele.
feedback-rotation_order_reversed = Rotațiile au fost înmulțite în ordine inversă: axele fixe au fost confundate cu cele curente.
feedback-rotation_degrees = Un unghi în grade a fost luat drept radiani, sau invers.
feedback-rotation_handedness = Totul se rotește invers: s-a folosit regula mâinii stângi.
feedback-rotation_half_angle = Acest cuaternion rotește de două ori mai mult: trebuie sinusul și cosinusul jumătății unghiului.
feedback-rotation_component_order = În cealaltă ordine a componentelor acest cuaternion ar fi corect.
feedback-rotation_not_unit = Cuaternionul nu are norma 1.
feedback-rotation_no_axis = Axa are lungimea zero.
feedback-rotation_solution_missing = Mai există un triplet cu aceeași orientare.
feedback-rotation_solution_twice = Tripletele diferă doar prin rotații complete: sunt unul și același. Mai există unul.
feedback-rotation_family_missing = Este blocaj cardanic: există o infinitate de triplete. Spuneți ce combinație a primului și ultimului unghi este determinată.
feedback-rotation_combination = Cealaltă combinație este cea determinată: diferența în locul sumei sau suma în locul diferenței.
feedback-rotation_not_locked = Nu este blocaj cardanic: exact două triplete au această orientare.
feedback-rotation_quadrant = Un unghi se află în cadranul greșit, la o jumătate de rotație: folosiți atan2 în loc de atan.
feedback-rotation_angle_sign = Un unghi sau o combinație de unghiuri are semnul greșit.
feedback-rotation_rounded = Elementele sunt rotunjite prea mult: calculați cu mai multe zecimale.
feedback-rotation_unit_columns = Aceasta nu este o rotație: o coloană nu are lungimea 1.
feedback-rotation_perpendicular_columns = Aceasta nu este o rotație: două coloane nu sunt perpendiculare.
feedback-rotation_right_handed = Aceasta nu este o rotație, ci o reflexie: determinantul este −1.
feedback-claim_right = Așa este pentru această matrice.
feedback-claim_not_rotation = Nu este o rotație: verificați lungimile coloanelor, unghiurile dintre ele și determinantul.
feedback-claim_rotation = Este totuși o rotație: coloane de lungime 1, perpendiculare, determinant +1.
feedback-claim_other_property = Nu este o rotație, dar această proprietate este îndeplinită; alta nu este.
feedback-chain_right = Situarea este cea care rezultă din lanțul de sisteme.
feedback-chain_wrong = Aceasta nu este situarea care rezultă din cele cunoscute.
feedback-chain_rotation_right = Rotația ei este corectă.
feedback-chain_position_right = Poziția ei este corectă.
feedback-chain_inverted = Aceasta este inversa: situarea primului sistem în ultimul.
feedback-chain_not_inverted = O situare cunoscută a fost folosită așa cum este, deși trebuia mai întâi inversată.
feedback-chain_inverse_without_transpose = Inversa unei situări a fost formată cu R; trebuie Rᵀ: (Rᵀ, −Rᵀp).
feedback-chain_inverse_position = Poziția unei inverse este −Rᵀp, nu −p.
feedback-chain_order_reversed = Factorii au fost înmulțiți în ordine inversă.
feedback-chain_transposed = Rotația este transpusă.
feedback-chain_not_rigid = Aceasta nu este o mișcare rigidă: coloanele nu sunt versori perpendiculari, sau formează un triedru stâng (determinant −1), sau ultimul rând nu este 0 0 0 1.
error-euler_axes_unknown = { $axes } nu este o secvență de axe: trei dintre X, Y, Z, cele vecine diferite.
error-component_order_missing = Spuneți unde stă scalarul cuaternionului: wxyz sau xyzw.
error-axis_and_angle = O axă are nevoie de un unghi, iar un unghi de o axă.
error-family_incomplete = O familie de triplete are nevoie de toate trei: unghiul din mijloc, suma sau diferența și valoarea ei.
error-orientation_empty = Scrieți orientarea într-una dintre notațiile cerute.
error-mistake_empty = Spuneți unde este greșeala, care este ea sau cum se îndreaptă.
error-frames_not_connected = Situările cunoscute nu duc de la sistemul { $start } la sistemul { $end }.
error-pose_without_table = O situare este cea a tabelului studentului sau a lui ⁰T: cereți și unul dintre ele sau lăsați regulile să fixeze zeroul, sensul, sistemul 0 și ultimul sistem.

error-one_notation = Dați orientarea într-o singură notație: { $known }.
error-name_without_value = Numele { $name } nu are valoare aici.{ $found ->
    [0] {""}
   *[one] {" "}Ați vrut să scrieți { $close }?
} Se cunosc { $known }.
error-rate_in_marks = { $text } nu este un nume aici. Ați vrut să scrieți viteza cuplei { $suggestion }?
error-expected_not_rotation =
    Matricea așteptată nu este o rotație: { $property ->
        [unit_columns] o coloană nu are lungimea 1.
        [perpendicular_columns] două coloane nu sunt perpendiculare.
       *[right_handed] este o reflexie, cu determinantul −1.
    }

field-solutions = Valorile cuplelor
field-combinations = Dacă sunt o infinitate: combinația care rămâne constantă (coeficienți)
option-finite = se atinge cu aceste valori ale cuplelor
option-infinite = se atinge într-o infinitate de feluri; acestea sunt câteva
option-out_of_reach = se află în afara spațiului de lucru
option-joint_limits = nu se atinge în limitele cuplelor
given-target = Situarea
given-target-position = Poziția ultimei origini
given-table = Tabelul DH, convenția { $convention ->
    [modified] modificată
   *[standard] standard
}

task-inverse-kinematics =
    { $variables ->
        [own] Ce valori ale variabilelor dumneavoastră aduc ultimul sistem în acest loc din sistemul 0?
       *[given] Tabelul robotului este dat. Ce valori ale cuplelor aduc ultimul său sistem în acest loc din sistemul 0?
    } { $solutions ->
        [one] Este suficientă o soluție.
       *[all] Dați-le pe toate; rotațiile complete nu contează.
    } { $reach ->
        [position] Contează numai poziția ultimei origini, în { unit-word }.
       *[pose] Contează și poziția, în { unit-word }, și orientarea.
    }

feedback-joints_right = Răspunsul este corect: conține tot ce s-a cerut.
feedback-joints_searched = Pentru această situare soluțiile au fost găsite prin căutare; pot exista și altele.
feedback-joints_need_table = Valorile sunt cele ale variabilelor dumneavoastră: predați și un tabel corect.
feedback-claim_wrong = Nu este așa: numărați din nou câte soluții ating această situare, dacă există.
feedback-joints_wrong = Rândul { $row } nu atinge situarea.
feedback-joints_twice = Rândurile { $other } și { $row } diferă doar prin rotații complete: sunt o singură soluție.
feedback-joints_missing =
    { $count ->
        [one] Lipsește o soluție.
        [few] Lipsesc { $count } soluții.
       *[other] Lipsesc { $count } de soluții.
    }
feedback-branch_shoulder =
    { $count ->
        [one] Brațul poate ajunge și pe la spate, cu celălalt umăr.
       *[other] Brațul poate ajunge și pe la spate, cu celălalt umăr: lipsesc { $count } soluții de acest fel.
    }
feedback-branch_elbow =
    { $count ->
        [one] Cotul se poate îndoi și în partea cealaltă.
       *[other] Cotul se poate îndoi și în partea cealaltă: lipsesc { $count } soluții de acest fel.
    }
feedback-branch_wrist =
    { $count ->
        [one] Încheietura poate fi și răsucită.
       *[other] Încheietura poate fi și răsucită: lipsesc { $count } soluții de acest fel.
    }
feedback-branch_other =
    { $count ->
        [one] Mai există o ramură de soluții.
       *[other] Mai există { $count } ramuri de soluții.
    }
feedback-joints_quadrant = Rândul { $row }: q{ $joint } se află în cadranul greșit, la o jumătate de rotație. Folosiți atan2 în loc de atan.
feedback-joints_sign = Rândul { $row }: q{ $joint } are semnul greșit.
feedback-joints_degrees = Rândul { $row }: gradele au fost luate drept radiani, sau invers.
feedback-joints_swapped = Rândul { $row }: q{ $joint } este 90° minus valoarea corectă; argumentele lui atan2 au fost schimbate între ele.
feedback-joints_half_branch = Rândul { $row } este rândul { $other } în care s-a schimbat doar q{ $joint }: pe altă ramură se schimbă odată cu ea și alte cuple.
feedback-joints_position_only = Rândul { $row } atinge poziția, dar nu și orientarea.
feedback-joints_orientation_only = Rândul { $row } atinge orientarea, dar nu și poziția.
feedback-joints_limits = Rândul { $row } atinge situarea cu cupla { $joint } dincolo de limita ei.
feedback-joints_rounded = Rândul { $row } este aproape de o soluție, dar nu destul de aproape: calculați cu mai multe zecimale.
feedback-joints_family_missing = Situarea este singulară: spuneți ce combinație a variabilelor rămâne neschimbată de-a lungul soluțiilor.
feedback-joints_taken_off = Ce este greșit se scade din ce este corect, ca ghicitul să nu aducă puncte: aici nu mai rămâne nimic din rândurile corecte.
feedback-joints_combination_wrong = Combinația { $row } nu rămâne neschimbată de-a lungul soluțiilor.
feedback-joints_combination_zero = Combinația { $row } este 0 orice ar face cuplele și nu spune nimic.
feedback-joints_combination_loose = Combinația { $row } rămâne neschimbată de-a lungul soluțiilor, dar nu este destul: alte valori ale cuplelor cu aceeași combinație nu ating situarea.
error-pose_frames_free = Situarea este dată în sistemul 0 și pentru ultimul: regulile trebuie să le fixeze pe amândouă, base = "frame" și tool = "frame".
error-pose_within_reach = Acest braț atinge situări oricât de îndepărtate, fiindcă aici cuplele de translație nu au limite: scoateți out_of_reach din cases.
error-joint_row_length = Un rând conține câte o valoare pentru fiecare cuplă. Necesare: { $expected }; date: { $given }.
error-joint_rows_empty = Dați valorile cuplelor care ating situarea.

field-row = Rândul cu greșeala
field-name = Ce este greșit
field-mended = Rândul așa cum ar trebui să fie
field-verdict = Cele două tabele descriu
field-reason = deoarece
option-alpha_sign = α are semnul greșit
option-alpha_value = α are o valoare greșită
option-a_sign = a are semnul greșit
option-d_sign = d are semnul greșit
option-a_value = a are o valoare greșită
option-d_value = d are o valoare greșită
option-a_d_swapped = a și d au fost schimbate între ele
option-a_missing = a este zero, dar nu ar trebui să fie
option-a_not_zero = a nu este zero, dar ar trebui să fie
option-d_missing = lipsește un decalaj d
option-d_not_zero = d nu este zero, dar ar trebui să fie
option-angles_in_degrees = toate unghiurile în grade, deși se declară radiani
option-angles_in_radians = toate unghiurile în radiani, deși se declară grade
option-cell_in_degrees = un unghi în grade printre radiani
option-cell_in_radians = un unghi în radiani printre grade
option-cell_length_unit = o lungime în altă unitate
option-cell_parameter = este folosită altă cotă din figură
option-columns_early = a și α cu un rând prea sus
option-columns_late = a și α cu un rând prea jos
option-columns_exchanged = două coloane schimbate între ele
option-columns_reordered = coloane în altă ordine
option-convention = este declarată convenția greșită
option-fixed_row_missing = lipsește ultimul rând, fără variabilă
option-joint_fixed = o cuplă fără variabila ei
option-joint_moving = o variabilă unde nu se mișcă nimic
option-joint_type = cupla are alt tip decât cel corect
option-length_unit = toate lungimile în altă unitate
option-parameter_misnamed = un nume care nu este în figură
option-parameters_swapped = două cote schimbate între ele
option-row_extra = un rând în plus
option-row_missing = lipsește un rând
option-rows_swapped = două rânduri schimbate între ele
option-theta_offset = constanta adunată la variabila θ este greșită
option-d_offset = constanta adunată la variabila d este greșită
option-theta_value = constanta θ are o valoare greșită
option-turns_all_reversed = toate unghiurile cuplelor au sensul greșit
option-twists_all_reversed = toate valorile α au semnul greșit
option-twists_early = doar α cu un rând prea sus
option-twists_swapped = valorile α a două rânduri, schimbate între ele
option-twists_late = doar α cu un rând prea jos
option-variable_sign = o variabilă de cuplă are sensul greșit
option-same = același robot
option-different = roboți diferiți
option-axis_reversed = sistemele diferă: o axă z, sau o variabilă a unei cuple, este inversată
option-x_turned = sistemele diferă: o axă x este rotită, iar zeroul variabilei este în altă parte
option-origin_moved = sistemele diferă: o origine se află în altă parte, sau primul ori ultimul sistem stă altfel
option-other_convention = sistemele diferă: convenția este alta
option-twist = unghiul dintre două axe diferă
option-length = distanța dintre două axe diferă
option-offset = un decalaj de-a lungul unei axe, sau un unghi constant în jurul ei, diferă
given-table-with-mistake = Tabelul cu o greșeală ({ $convention ->
    [modified] convenția modificată
   *[standard] convenția standard
})
given-first-table = Primul tabel ({ $convention ->
    [modified] convenția modificată
   *[standard] convenția standard
})
given-second-table = Al doilea tabel ({ $convention ->
    [modified] convenția modificată
   *[standard] convenția standard
})

task-find-mistake = Acest tabel ar trebui să descrie robotul din figură, dar un rând are o greșeală. Care este rândul, ce este greșit și cum ar trebui să fie?
task-compare-tables = Descriu aceste două tabele același robot, oricum s-ar alege sistemele? Spuneți de ce.

feedback-mistake_found = Ați găsit greșeala, ați numit-o și ați corectat-o.
feedback-mistake_row_wrong = Greșeala este în alt rând.
feedback-mistake_name_wrong = Greșeala este de alt fel.
feedback-mistake_not_mended = Cu acest rând tabelul tot nu descrie robotul.
feedback-mistake_missing =
    { $what ->
        [row] Spuneți în ce rând este greșeala.
        [name] Spuneți ce este greșit.
       *[mended] Scrieți rândul așa cum ar trebui să fie.
    }
feedback-tables_right = Corect, și din motivul corect.
feedback-tables_same = Este același robot: doar sistemele au fost alese altfel.
feedback-tables_different = Sunt roboți diferiți: nicio alegere a sistemelor nu transformă un tabel în celălalt.
feedback-tables_reason_wrong = Verdictul este corect, dar nu din acest motiv.
feedback-tables_reason_missing = Verdictul este corect; spuneți și de ce.
error-row_unknown = Dați numărul unui rând, de la 1 la { $count }.
error-column_unknown = Dați numărul unei coloane, de la 1 la { $count }.
error-vector_length = Vectorul are { $expected } componente, nu { $given }.
error-joint_variable_in_number = { $name } este variabila unei cuple, iar aici se cere un număr: puneți valoarea ei.
error-no_mistake_does_harm = Niciuna dintre aceste greșeli nu schimbă acest robot după regulile lui.
error-frame_mistakes_not_shown = Sistemele de coordonate ale acestui robot nu pot arăta niciuna dintre aceste greșeli. Ce pot arăta: { $known }.
error-key_given_away = Această parte arată un tabel; un exercițiu care cere tabelul nu o poate avea.
error-not_plantable = Niciuna dintre greșelile cerute nu schimbă acest robot.

field-frame = Torsorii sunt scriși în
field-order = Ordinea dintre v și ω
field-screws = Torsori, câte un rând pentru fiecare cuplă
field-home = Situarea inițială M
option-space = sistemul fix (spațiu)
option-body = sistemul sculei în poziția zero (corp)
option-linear_first = v, ω: partea liniară întâi
option-angular_first = ω, v: partea unghiulară întâi

task-screws = Scrieți robotul ca produs de exponențiale: torsorii cuplelor 1 până la { $n } și situarea inițială M, lungimile în { unit-word }. Alegeți sistemul, poziția zero și sensul fiecărei axe în limitele regulilor.

feedback-screws_right = Torsorii și situarea inițială descriu acest robot.
feedback-screws_right_robot = Acest produs de exponențiale descrie robotul potrivit, dar nu respectă tot ce cere exercițiul.
feedback-screws_wrong = Acest produs de exponențiale nu descrie robotul, oricare ar fi sistemul, zeroul și sensurile alese.
feedback-screw_not_unit = Cupla { $joint }: ω al unei cuple de rotație este un versor.
feedback-screw_pitch = Cupla { $joint }: v are o componentă de-a lungul lui ω; o cuplă de rotație nu înaintează pe axa ei.
feedback-screw_joint_type = Cupla { $joint }: una de translație are ω = 0 și un versor v; una de rotație are ω de lungime 1.
feedback-screw_halves = v și ω sunt schimbate între ele: în cealaltă ordine rândurile ar fi corecte.
feedback-screw_moment_sign =
    { $joint ->
        [0] Toate v au semnul greșit
       *[other] Cupla { $joint }: v are semnul greșit
    }: v = −ω × p, cu p un punct oarecare al axei.
feedback-screw_other_frame = Aceștia sunt torsorii în celălalt sistem: spațiul și corpul au fost confundate.
feedback-screw_home_inverted = Situarea inițială este inversată.
feedback-screw_sign_or_home = Fie v are peste tot semnul greșit (v = −ω × p, cu p un punct oarecare al axei), fie situarea inițială este inversată.
feedback-screw_home = Torsorii sunt corecți; situarea inițială M nu este.
feedback-screw_not_rigid = Situarea inițială nu este o mișcare rigidă: coloanele nu sunt versori perpendiculari, sau formează un triedru stâng (determinant −1), sau ultimul rând nu este 0 0 0 1.
feedback-screw_length_unit = Lungimile sunt în altă unitate decât a robotului: în unitatea lui rândurile ar fi corecte.
feedback-screw_exchanged = Rândurile cuplei { $joint } și ale celei următoare sunt schimbate între ele.
feedback-screw_reversed = Rândurile sunt în ordine inversă: primul este al cuplei de lângă bază.
feedback-screws_relation_wrong = Axele cuplelor { $joint } și { $next } nu sunt așezate una față de alta ca în figură.
error-screw_count =
    Robotul are { $expected ->
        [one] { $expected } cuplă
        [few] { $expected } cuple
       *[other] { $expected } de cuple
    }, { $given ->
        [one] s-a dat { $given } torsor
        [few] s-au dat { $given } torsori
       *[other] s-au dat { $given } de torsori
    }.

error-screw_too_large = Un număr este prea mare pentru un robot; cel mai mare este { $limit }.

field-jacobian = Jacobianul, câte o coloană pentru fiecare cuplă
field-forces = Momentele și forțele din cuple
given-configuration = Configurația
given-wrench = Forța și momentul exercitate de sculă

task-jacobian =
    { $variables ->
        [own] Luați propriul tabel și propriile variabile ale cuplelor la aceste valori.
       *[given] Sunt date tabelul robotului și o configurație.
    } { $ask ->
        [jacobian] Scrieți jacobianul geometric al ultimei origini, lungimile în { unit-word }, pe radian.
        [forces] Ce momente și forțe din cuple, τ = Jᵀ(f, m), corespund forței și momentului din ultima origine, lungimile în { unit-word }?
       *[both] Scrieți jacobianul geometric al ultimei origini, lungimile în { unit-word }, pe radian, și momentele și forțele din cuple τ = Jᵀ(f, m).
    } { $frame ->
        [end] Toți vectorii sunt în axele ultimului sistem.
       *[base] Toți vectorii sunt în axele sistemului 0.
    }

feedback-jacobian_right = Totul este corect.
feedback-jacobian_follows_table = Aceasta rezultă din tabelul dumneavoastră și își primește punctele, deși tabelul nu este corect.
feedback-jacobian_needs_table = Jacobianul este cel al propriului tabel: predați și tabelul, cu toate cuplele.
feedback-jacobian_missing =
    { $what ->
        [jacobian] Lipsește jacobianul.
       *[forces] Lipsesc momentele și forțele din cuple.
    }
feedback-jacobian_wrong = Nu toate coloanele jacobianului sunt corecte.
feedback-forces_wrong = Nu toate momentele și forțele din cuple sunt corecte.
feedback-jacobian_next_axis =
    { $count ->
        [1] Coloana { $joint } folosește axa unei cuple vecine: vedeți ce z aparține fiecărei cuple în convenția dumneavoastră.
       *[other] Coloanele { $joints } folosesc axa unei cuple vecine: vedeți ce z aparține fiecărei cuple în convenția dumneavoastră.
    }
feedback-jacobian_point_swapped =
    { $count ->
        [1] Coloana { $joint }: partea liniară este z × (pₙ − p), nu z × (p − pₙ).
       *[other] Coloanele { $joints }: partea liniară este z × (pₙ − p), nu z × (p − pₙ).
    }
feedback-jacobian_prismatic =
    { $count ->
        [1] Coloana { $joint }: una de translație dă (z, 0), una de rotație (z × (pₙ − p), z).
       *[other] Coloanele { $joints }: una de translație dă (z, 0), una de rotație (z × (pₙ − p), z).
    }
feedback-jacobian_other_frame =
    { $count ->
        [0] Acesta este jacobianul în axele celuilalt sistem.
        [1] Coloana { $joint } este în axele celuilalt sistem.
       *[other] Coloanele { $joints } sunt în axele celuilalt sistem.
    }
feedback-jacobian_rows_exchanged = Rândurile liniare și cele unghiulare au fost schimbate între ele.
feedback-jacobian_spatial = Aceasta este viteza punctului din originea sistemului 0; se cere originea ultimului sistem.
feedback-forces_sign = Toate semnele sunt inversate: se cere τ = Jᵀ(f, m), cu forța și momentul date.
feedback-forces_other_frame = Forța și momentul au fost luate în axele celuilalt sistem.
feedback-forces_rows_exchanged = Forța și momentul au fost schimbate între ele.
feedback-forces_spatial = S-a presupus că forța acționează în originea sistemului 0.
error-row_order_missing = Spuneți ce rânduri stau întâi: (v, ω) sau (ω, v).
error-jacobian_empty = Dați jacobianul sau momentele și forțele din cuple.

error-wrench_missing = Momentele și forțele din cuple corespund unei forțe și unui moment: dați „wrench”.
