# Valori ale cuplelor, situări, torsori și tabele numerice.

error-target_unanswered = Calculul s-a oprit după { $seconds } s, cu { $answered } dintre ținte rezolvate. Cereți-o pe aceasta și pe cele următoare într-o altă cerere.
error-joints_wrong_length =
    { $expected ->
        [one] Tabelul are o cuplă, dar s-a dat o configurație cu { $given ->
            [one] o valoare
            [few] { $given } valori
           *[other] { $given } de valori
        }.
        [few] Tabelul are { $expected } cuple, dar s-a dat o configurație cu { $given ->
            [one] o valoare
            [few] { $given } valori
           *[other] { $given } de valori
        }.
       *[other] Tabelul are { $expected } de cuple, dar s-a dat o configurație cu { $given ->
            [one] o valoare
            [few] { $given } valori
           *[other] { $given } de valori
        }.
    }
error-joints_malformed = Valorile cuplelor sunt numere: o configurație [q1, …, qn] sau o listă de configurații de aceeași lungime.
error-joint_not_finite = Valoarea cuplei { $joint } nu este un număr finit.
error-result_not_finite = Rezultatul este prea mare pentru un număr în dublă precizie. Lungimile și valorile cuplelor trebuie să fie mai mici.
error-entry_not_finite = { $cell } nu este un număr finit.
error-value_undefined = Pentru acești parametri expresia nu are o valoare finită.

error-pose_not_numbers = O situare este o matrice 4×4 de numere.
error-pose_wrong_shape = O situare este o matrice 4×4 de numere; aceasta este { $shape }.
error-pose_not_finite = Acest element nu este un număr finit.
error-pose_in_one_row = Șaisprezece numere într-o singură listă nu sunt o situare: scrieți patru rânduri a câte patru numere, [[…], […], […], [0, 0, 0, 1]].
error-inertia_in_one_row = O inerție nu se scrie într-o singură listă: scrieți trei rânduri a câte trei numere, [[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]], cu Ixy = −∫ x y dm.
error-pose_bottom_row = Ultimul rând al unei situări este 0, 0, 0, 1.
error-pose_not_orthonormal = Partea de rotație nu este ortonormată (abatere { $error }): coloanele ei trebuie să fie versori perpendiculari, cu toleranța { $tolerance }. Dați mai multe zecimale sau, în cinematica inversă, o toleranță (`tolerance`).
error-pose_left_handed = Partea de rotație formează un triedru stâng: determinantul ei este −1, adică o reflexie. Trebuie să fie +1.

error-notation_wrong_length =
    { $expected ->
        [one] { $what } cere un număr: { $names }.
        [few] { $what } cere { $expected } numere: { $names }.
       *[other] { $what } cere { $expected } de numere: { $names }.
    }
error-notation_not_finite = { $name } din { $what } nu este un număr finit.
error-quaternion_length = Un cuaternion de lungime zero sau prea mare nu descrie o orientare. Dați un cuaternion unitar.
error-axis_length = O axă de lungime zero sau prea mare nu are direcție. Dați un versor.

error-screw_not_finite = Un torsor cinematic este format din șase numere finite.
error-screw_not_unit = Partea unghiulară a torsorului unei cuple de rotație și partea liniară a torsorului unei cuple de translație trebuie să aibă lungimea 1.
error-screw_has_pitch = Acest torsor are pasul { $pitch } pe radian. O cuplă fie se rotește, fie se translatează.
error-screw_of_other_type = Torsorul { $joint } nu este de tipul declarat: o cuplă de rotație are parte unghiulară, una de translație nu are.
error-tree_after_unknown = Rândul { $row } urmează sistemul { $given }: trebuie să urmeze baza (0) sau un rând anterior. Lanțurile închise nu sunt admise.
error-frame_unknown = Nu există sistemul { $given }; ultimul este { $count }.
