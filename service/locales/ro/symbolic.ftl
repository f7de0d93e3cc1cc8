# Forme închise.

error-form_too_large =
    Forma dezvoltată cere peste { $limit ->
        [one] { $limit } produs
        [few] { $limit } produse
       *[other] { $limit } de produse
    } de termeni. Cereți mai puține rânduri.
error-closed_form_too_large =
    Scrisă în întregime, o matrice are peste { $limit ->
        [one] { $limit } operație
        [few] { $limit } operații
       *[other] { $limit } de operații
    }. Cereți mai puține rânduri sau o funcție (python, c, matlab și altele), care calculează o singură dată ce se repetă.
error-closed_form_too_deep = Un element are prea multe niveluri de imbricare pentru un arbore JSON. Cereți text sau LaTeX.
error-computation_out_of_time = Calculul durează peste { $seconds } s. Cereți mai puține rânduri, părți sau formate ori, în locul formulelor, numere la valori date ale variabilelor cuplelor.
error-computation_out_of_memory = Calculul cere peste { $megabytes } MiB de memorie. Cereți mai puține rânduri, părți sau formate ori, în locul formulelor, numere la valori date ale variabilelor cuplelor.
error-computation_aborted = Calculul a fost întrerupt din cauza unei probleme a serverului, nu a cererii dumneavoastră. Încercați din nou peste câteva clipe.
