### Ce spune autorului verificarea unui exercițiu.

check-counts = { $exercise }: { $passed ->
    [one] { $passed } verificare reușită
    [few] { $passed } verificări reușite
   *[other] { $passed } de verificări reușite
}, { $failed ->
    [one] { $failed } nereușită
    [few] { $failed } nereușite
   *[other] { $failed } nereușite
}, { $warnings ->
    [one] { $warnings } avertisment
    [few] { $warnings } avertismente
   *[other] { $warnings } de avertismente
}
check-structure = Sămânța { $seed } schimbă structura robotului.
check-drawn_structure = Tragerea la sorți poate da { $name } = { $value }, ceea ce schimbă structura robotului. Excludeți această valoare (without) sau alegeți alt interval.
check-figure = Sămânța { $seed }: figura nu poate fi desenată ({ $reason }).
check-right = Un tabel corect este respins: { $table }
check-certificate = Certificatul unui tabel corect nu se verifică: { $table }
check-harmless = Un tabel greșit este acceptat: { $table }
check-mistake = Greșeala { $mistake } nu este explicată în { $table }
check-part = Sămânța { $seed }: un răspuns corect la partea { $part } este respins.
check-follow_through = Sămânța { $seed }: ce decurge dintr-un tabel greșit nu aduce puncte la partea { $part }.
check-wrong_part = Sămânța { $seed }: un răspuns greșit la partea { $part } nu este explicat ca { $mistake }, ci ca { $told }.
check-invalid = Un tabel scris greșit este notat: { $name }.
check-sample = Exemplul „{ $name }” nu este judecat cum se aștepta; verdictul este: { $told }.
check-rounded = Un tabel corect rotunjit la { $digits } cifre este respins cu regula sculei { $rule }: { $table }
check-tool_rule = Un tabel corect este respins cu regula sculei { $rule }: { $table }
check-crash = Sămânța { $seed }: notarea eșuează: { $reason }
check-unneeded = Niciun răspuns corect nu are nevoie de { $name }: studentul poate alege sisteme de coordonate în care nu apare. { $rules ->
    [none] Nicio regulă nu schimbă acest lucru: scoateți-o din enunț.
   *[other] Dacă răspunsul trebuie să o conțină, este suficientă oricare dintre aceste reguli: { $rules }. Altfel, scoateți-o din enunț.
}
check-alike = Unii studenți pot schimba între ele numerele lui { $name } și { $other } fără să se observe: diferă cu cel mult 1 %. Alegeți valori sau intervale mai îndepărtate.
check-taken_by_slide = În rândul cuplei { $joint }, { $name } sub d este variabila cuplei, nu cota. Cine alege sisteme de coordonate în care cota apare acolo nu o poate scrie. Dați-i alt nume.
check-taken_by_short_form = Acolo unde răspunsul este o formulă, { $name } este un cosinus sau un sinus, nu cota. Dați-i alt nume.
check-no_joints = Robotul nu are nicio cuplă: nu este nimic de descris. Puneți una într-un rând al tabelului.
check-nothing_earned = Niciun tabel greșit nu primește puncte: nimic din ce descrie greșit un tabel de zerouri la acest robot nu are pondere. Schimbați ponderile sau fixați mai multe reguli.
check-asked_as_shown = Partea { $kind } arată chiar ceea ce cere. Cereți altceva sau arătați-l în altă formă.
check-gravity_not_down = În figură, accelerația gravitațională din partea { $kind } nu este îndreptată în jos. Rotiți sistemul 0 cu upright sau schimbați gravity.
check-frames_coincide = În figura părții { $kind }, două sisteme de coordonate au aceeași origine, fiindcă o cuplă de translație dintre ele este desenată la zero. Dați-i altă valoare în posture.
check-limits_ambiguous = Răspunsul la partea { $kind } depinde de sensul în care crește variabila unei cuple cu limite, iar sensul se alege liber. Fixați sensurile (figure) sau alegeți limite pentru care sensul nu contează.
warm-counts = { $exercise }: seturi de valori verificate și desenate: { $values }, figuri: { $figures }, forme închise: { $forms }, eșecuri: { $failed }, { $seconds } s
error-nothing_to_warm = Nu există niciun exercițiu și niciun curs cu legături numit { $name }.
error-variants_set = Numărul de variante pentru { $name } este stabilit în exercițiu sau în regulile legăturilor cursului. Omiteți --variants.
