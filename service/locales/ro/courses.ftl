### Cursuri, încercări păstrate și lansări dintr-o platformă de învățare: ce se refuză și de ce.

problem-title-401 = Nu sunteți autentificat
problem-title-403 = Acces nepermis
problem-title-409 = Nu este posibil acum

## Stocare

error-storage_folder = Dosarul de date { $folder } nu poate fi folosit: { $reason }. Puneți în FRAMEWISE_DATA_FOLDER un dosar în care se poate scrie sau FRAMEWISE_STORAGE pe off.
error-storage_address = FRAMEWISE_DATABASE_URL nu numește o bază de date PostgreSQL. Are forma postgresql://utilizator:parolă@server/bază.
error-storage_unusable = Baza de date { $location } nu poate fi folosită: { $reason }.
error-storage_unavailable = Baza de date nu răspunde acum. Ce a fost confirmat până acum este în siguranță. Trimiteți din nou peste câteva secunde.
error-storage_missing = Nu există nicio bază de date la { $location }. FRAMEWISE_DATA_FOLDER sau FRAMEWISE_DATABASE_URL trebuie să indice baza de date a serviciului.
error-schema_newer = Datele au fost scrise de o versiune mai nouă a programului (schema { $found }; această versiune cunoaște { $known }). Instalați versiunea mai nouă.
error-storage_not_empty = O copie de siguranță se restaurează numai într-o bază de date goală; relația { $table } are deja rânduri.
error-backup_unreadable = { $file } nu poate fi citit sau scris ca o copie de siguranță: { $reason }.

## Încercări

error-record_unknown = { $kind ->
    [attempt] Nu există această încercare în acest curs.
    [person] Nu există această persoană în acest curs.
    [anybody] Nu există această persoană aici.
    [several] Mai multe pseudonime încep așa. Indicați mai multe caractere; un export îl arată întreg.
    [link] Nu există această legătură în acest curs.
    [platform] Nu există această platformă.
    [course] Nu există acest curs.
   *[other] Nu există această înregistrare în acest curs.
}
error-attempts_not_open = Încercările se primesc începând cu data de { TIME($opens) } UTC.
error-attempts_closed = Exercițiul s-a închis la data de { TIME($closes) } UTC.
error-attempts_used = { $allowed ->
    [one] Singura încercare permisă de acest exercițiu a fost făcută.
    [few] Toate cele { $allowed } încercări permise de acest exercițiu au fost făcute.
   *[other] Toate cele { $allowed } de încercări permise de acest exercițiu au fost făcute.
}
error-exercise_changed = Exercițiul a fost modificat după ce ați deschis această pagină și nu s-a predat nimic. Reîncărcați pagina: ce ați scris este în continuare acolo.
error-settings_changed = Modificările nu au fost salvate: altcineva a salvat alte reguli după ce ați deschis această pagină. Reîncărcați pagina și consultați-le.
error-regrading_outdated = Nu s-a aplicat nimic: exercițiul sau regulile legăturii s-au schimbat de când au fost calculate aceste note sau s-au aplicat altele. Notați din nou.
error-scores_unsent = { $count ->
    [one] Nu s-a șters nimic: catalogul nu a primit { $count } notă a acestui curs. Vedeți ce o reține; pentru a o pierde, adăugați --with-unsent.
    [few] Nu s-a șters nimic: catalogul nu a primit { $count } note ale acestui curs. Vedeți ce le reține; pentru a le pierde, adăugați --with-unsent.
   *[other] Nu s-a șters nimic: catalogul nu a primit { $count } de note ale acestui curs. Vedeți ce le reține; pentru a le pierde, adăugați --with-unsent.
}
error-setting_invalid = { $name } poate fi: { $known }.
error-closes_before_opening = Exercițiul s-ar închide înainte de a se deschide.
error-session_expired = Nu mai sunteți autentificat. Ce ați scris este încă aici: deschideți din nou exercițiul din cursul dumneavoastră.
error-administrator_unknown = Această pagină se deschide cu o adresă pe care o afișează framewise lti administer. Adresa funcționează o singură dată, în următoarele zece minute; sesiunea durează două ore.
error-code_used = Această adresă a fost deja folosită. Deschideți din nou exercițiul din cursul dumneavoastră.
error-staff_only = Aici au acces doar cadrele didactice ale cursului.
error-publishing_closed =
    { $who ->
        [staff] Aici pot publica exerciții doar cadrele didactice venite dintr-un curs sau cine are o cheie cu dreptul publish.
        [key] Aici se pot publica exerciții doar cu o cheie cu dreptul publish.
       *[nobody] Pe acest serviciu nimeni nu poate publica exerciții.
    }
error-link_without_exercise = Pentru această legătură nu s-a ales încă un exercițiu. Un profesor îl alege deschizând legătura.
error-invitation_used = Această adresă de înregistrare a fost deja folosită sau este prea veche. Cereți una nouă.
error-storage_off = Această instalare nu păstrează cursuri: stocarea ei este oprită.
error-posted_form_too_large =
    Formularul depășește { $limit ->
        [one] { $limit } octet
        [few] { $limit } octeți
       *[other] { $limit } de octeți
    }.
error-form_invalid = Corpul nu este un formular (application/x-www-form-urlencoded).
