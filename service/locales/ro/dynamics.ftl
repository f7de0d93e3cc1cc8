# Cum mișcă forțele un robot.

error-links_count = Lista elementelor are câte o intrare pentru fiecare rând al tabelului: { $expected }, nu { $given }.
error-mass_negative = O masă nu este negativă: { $mass } kg.
error-inertia_not_symmetric = O matrice de inerție este simetrică: elementul xy este egal cu yx.
error-inertia_negative = Un moment de inerție față de o axă nu este niciodată negativ. Această matrice are unul negativ față de o axă.
error-mass_matrix_singular = O cuplă nu mișcă nimic care să aibă masă, deci nicio forță nu îi determină accelerația. Dați elementelor masă și inerție.
