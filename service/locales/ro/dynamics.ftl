# Cum mișcă forțele un robot.

error-links_count = Lista elementelor are câte o intrare pentru fiecare rând al tabelului: { $expected }, nu { $given }.
error-mass_negative = O masă nu este negativă: { $mass } kg.
error-inertia_not_symmetric = O matrice de inerție este simetrică: elementul xy este egal cu yx.
error-inertia_negative = Un moment de inerție față de o axă nu este niciodată negativ. Această matrice are unul negativ față de o axă.
error-mass_matrix_singular = O cuplă nu mișcă nimic care să aibă masă, deci nicio forță nu îi determină accelerația. Dați elementelor masă și inerție.
error-links_missing = Indicați masa elementelor: links, câte o intrare pentru fiecare rând al tabelului.
error-name_of_rate = { $name } este numele vitezei unei cuple în formele literale. Dați parametrului alt nume.
error-body_varies = Masa unui element și locul ei nu depind de variabilele cuplelor: acestea apar numai în tabel.
error-dynamics_not_finite = Masele, lungimile sau vitezele sunt atât de mari, încât rezultatul nu este un număr.
