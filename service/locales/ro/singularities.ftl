field-conditions = Condiții de singularitate
field-lost = O mișcare pierdută

task-singularities =
    Este dat tabelul robotului. În ce configurații pierde brațul o mișcare: { $motion ->
        [translation] unde are jacobianul vitezei ultimei origini un rang mai mic decât cel obișnuit?
       *[twist] unde are jacobianul un rang mai mic decât cel obișnuit?
    } Scrieți câte o condiție pe rând: o funcție care se anulează acolo (sin(q3)) sau o ecuație (q3 = 0, π). Contează mulțimea, oricum ar fi scrisă.{ $lost ->
        [yes] {" "}Pentru configurația dată, scrieți un vector λ ≠ 0 în axele sistemului 0 cu λ · J q̇ = 0 orice ar face cuplele, în ultima origine, lungimile în { unit-word }: mișcarea pierdută.
       *[no] {""}
    }

feedback-singularities_right = Condițiile sunt îndeplinite exact acolo unde brațul este singular și nu lipsește nimic.
feedback-singularities_missing = Familii de singularități găsite: { $found } din { $count }.
feedback-singularity_missing_at = Niciuna dintre condițiile dumneavoastră nu este îndeplinită în această configurație singulară: { $at }.
feedback-singularity_invented = Condiția { $condition } este îndeplinită și acolo unde brațul nu este singular.
feedback-singularity_invented_at = Condiția { $condition } este îndeplinită în { $at }, unde brațul nu este singular.
feedback-singularity_rounded = Condiția { $condition } se apropie de o singularitate, dar nu îndeajuns: calculați cu mai multe zecimale.
feedback-singularity_sine_for_cosine = Condiția { $condition } este cea a unei singularități, decalată cu un sfert de rotație: sinusul și cosinusul au fost schimbate între ele.
feedback-singularity_half = Dintr-o familie s-a găsit doar o parte: gândiți-vă și la cealaltă soluție a ecuației (q = π pe lângă q = 0, brațul pliat pe lângă cel întins).
feedback-singularity_everywhere = Condiția { $condition } este îndeplinită mereu.
feedback-singularity_nowhere = Condiția { $condition } nu este îndeplinită niciodată și nu spune nimic.
feedback-conditions_missing = Lipsesc condițiile.
feedback-lost_motion_missing = Lipsește mișcarea pierdută.
feedback-lost_motion_wrong = Vectorul nu este o mișcare care se pierde aici.
feedback-lost_motion_is_kept = Cu acest vector brațul încă se mișcă: λᵀJ nu este zero.
feedback-lost_motion_zero = λ = 0 ar fi bun oriunde: dați un vector diferit de 0.
feedback-lost_motion_never = Brațul nu se mișcă astfel în nicio configurație: nu aici se pierde mișcarea.
error-conditions_empty = Dați condiții sau o mișcare pierdută.
error-condition_not_equation = { $text } nu este o condiție: scrieți o funcție care se anulează sau o ecuație cu un singur semn =.
error-condition_angle_nonlinear = Un unghi al unei cuple în afara sinusului, cosinusului și tangentei poate sta numai într-o ecuație ca q2 + q3 = π/2.
error-conditions_too_many =
    Celula conține peste { $limit ->
        [one] { $limit } condiție
        [few] { $limit } condiții
       *[other] { $limit } de condiții
    }.
error-condition_period = Ceea ce se adună de k ori trebuie să fie o rotație completă împărțită la un număr întreg: 2π, π, π/2…
error-singularities_no_families = Nicio condiție nu poate spune unde este singular acest braț: nu este niciodată sau numai în familii de dimensiune mai mică. Alegeți cealaltă mișcare sau alt robot.
error-not_singular = Brațul nu este singular în această configurație.
