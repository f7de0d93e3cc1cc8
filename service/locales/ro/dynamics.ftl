# Cum mișcă forțele un robot.

error-links_count = Lista elementelor are câte o intrare pentru fiecare rând al tabelului: { $expected }, nu { $given }.
error-mass_negative = O masă nu poate fi negativă: { $mass } kg.
error-inertia_not_symmetric = Un tensor de inerție este simetric: elementul xy este egal cu yx.
error-inertia_negative = Un moment de inerție față de o axă nu este niciodată negativ. Acest tensor are unul negativ față de o anumită axă.
error-dynamics_without_joints = Nimic nu se mișcă: ecuațiile de mișcare au nevoie de un rând de rotație sau de translație.
error-mass_matrix_singular = O cuplă nu mișcă nimic care să aibă masă, deci nicio forță nu îi determină accelerația. Dați elementelor masă și inerție.
error-links_missing = Indicați masa elementelor: links, câte o intrare pentru fiecare rând al tabelului.
error-name_of_rate = { $name } este numele vitezei unei cuple în formele închise. Dați parametrului alt nume.
error-body_varies = Masa unui element și locul ei în acesta nu depind de variabilele cuplelor: acestea apar numai în tabel.
error-dynamics_not_finite = Masele, lungimile sau vitezele sunt atât de mari, încât rezultatul nu este un număr.

task-equations-of-motion =
    Sunt date tabelul robotului și corpul care se mișcă împreună cu fiecare sistem i. Scrieți termenii ceruți din M q̈ + C q̇ + g = τ ca funcții de q1, q2, …, de vitezele lor dq1, dq2, … și de simbolurile date; lungimi în { unit-word }, pe radian. { $skew ->
        [yes] Este corectă orice matrice C care dă C q̇ corect; în plus, Ṁ − 2C trebuie să fie antisimetrică.
       *[no] Este corectă orice matrice C care dă C q̇ corect.
    }
given-link-weights = Elementele: masă, centru în sistemul i, momente față de el [kg { $unit }²]
given-gravity-vector = Accelerația gravitațională în sistemul 0 [{ $unit }/s²]
given-weights = Valorile simbolurilor
field-mass = Matricea de inerție M
field-coriolis = Matricea C
field-velocity = Termenii Coriolis și centrifugi C q̇
field-gravity = Termenii gravitaționali g
feedback-motion_right = Acestea sunt ecuațiile de mișcare.
feedback-motion_mass_wrong = Nu toate elementele lui M sunt corecte.
feedback-motion_coriolis_wrong = Nu toate rândurile lui C q̇ sunt corecte.
feedback-motion_velocity_wrong = Nu toți termenii Coriolis și centrifugi sunt corecți.
feedback-motion_skew_wrong = Cu această C, Ṁ − 2C nu este antisimetrică. Simbolurile lui Christoffel dau o matrice C cu care este.
feedback-motion_gravity_wrong = Nu toate elementele lui g sunt corecte.
feedback-motion_missing =
    { $what ->
        [mass] Lipsește matricea de inerție.
        [coriolis] Lipsește matricea C.
        [skew] Fără matricea C nu există Ṁ − 2C.
        [velocity] Lipsesc termenii Coriolis și centrifugi.
       *[gravity] Lipsesc termenii gravitaționali.
    }
feedback-motion_asymmetric = O matrice de inerție este simetrică; aceasta nu este.
feedback-motion_point_masses = Aceasta este M a unor mase punctiforme: lipsesc momentele de inerție proprii ale elementelor.
feedback-motion_gravity_sign = Acest g are semnul opus: g este ce trebuie să facă cuplele împotriva gravitației, gradientul energiei potențiale.
feedback-motion_velocity_sign = Acest C q̇ are semnul opus.
feedback-motion_coupling_once = Fiecare produs q̇j q̇k a două cuple diferite apare de două ori în C q̇, ca jk și ca kj; aici este numărat o singură dată.
feedback-motion_mass_rate = Acesta este Ṁ q̇. Trebuie scăzut gradientul energiei cinetice, ½ ∂(q̇ᵀM q̇)/∂q.
error-motion_row_count = Matricea are câte un rând pentru fiecare cuplă: { $expected }, nu { $given }.
error-motion_empty = Scrieți cel puțin una dintre matricele sau rândurile cerute.
error-motion_cell = Aici se scrie un număr sau o expresie; pentru o poziție sau pentru momente de inerție, trei.
