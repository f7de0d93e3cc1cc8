error-text_markup = Acesta este marcaj, pe care niciun text al unui exercițiu nu îl poate conține: { $found }. Scrieți L1 < L2 cu spații.
error-text_too_long =
    Textul este prea lung; sunt admise cel mult { $limit ->
        [one] { $limit } caracter
        [few] { $limit } caractere
       *[other] { $limit } de caractere
    }.
error-text_control_character = Textul conține caracterul de control { $found }, care nu se vede. Ștergeți-l.
error-statement_not_text = Enunțul nu este text în UTF-8.
error-draft_too_large =
    Definiția este mai mare decât poate fi cea a unui robot: un tabel sau o listă are cel mult { $entries ->
        [one] { $entries } intrare
        [few] { $entries } intrări
       *[other] { $entries } de intrări
    }, toate împreună { $values }, pe cel mult { $deepest ->
        [one] { $deepest } nivel
        [few] { $deepest } niveluri
       *[other] { $deepest } de niveluri
    }.
error-archive_too_large =
    Arhiva este prea mare; un exercițiu are cel mult { $limit ->
        [one] { $limit } octet
        [few] { $limit } octeți
       *[other] { $limit } de octeți
    }.
error-archive_not_zip = Aceasta nu este o arhivă zip care poate fi citită.
error-archive_too_many_files =
    Arhiva conține { $count ->
        [one] { $count } fișier
        [few] { $count } fișiere
       *[other] { $count } de fișiere
    }; dosarul unui exercițiu are cel mult { $limit }.
error-archive_entry = { $name } nu aparține unui exercițiu: un dosar cu { $known } și fișiere statement.<limbă>.md, și nimic altceva.
error-archive_method = { $name } este criptat sau comprimat într-un mod care nu se citește aici. Folosiți un zip obișnuit.
error-archive_file_too_large =
    { $name } este prea mare; un fișier al unui exercițiu are cel mult { $limit ->
        [one] { $limit } octet
        [few] { $limit } octeți
       *[other] { $limit } de octeți
    }.
error-archive_no_exercise = Arhiva nu conține niciun exercițiu: se așteaptă un dosar cu { $known }.
error-source_form = Un exercițiu se începe de la una dintre { $known }.
error-drawing_too_many_axes =
    Sunt { $count ->
        [one] { $count } axă
        [few] { $count } axe
       *[other] { $count } de axe
    }; se pot desena cel mult { $limit }.
error-drawing_too_many_lengths =
    Sunt { $count ->
        [one] { $count } lungime cu nume
        [few] { $count } lungimi cu nume
       *[other] { $count } de lungimi cu nume
    }; sunt posibile cel mult { $limit }.
error-axis_not_before =
    { $before ->
        [0] Înaintea acestei axe nu este desenată alta: axa { $axis } nu poate servi ca referință.
        [one] Înaintea acestei axe este desenată numai axa 1, nu și axa { $axis }.
        [few] Axa { $axis } nu este printre cele { $before } axe desenate înaintea acesteia.
       *[other] Axa { $axis } nu este printre cele { $before } de axe desenate înaintea acesteia.
    }
error-length_unknown = { $name } nu este încă o lungime a acestui desen. Lungimile lui: { $known }.
error-draft_too_many_rows =
    Tabelul are { $count ->
        [one] { $count } rând
        [few] { $count } rânduri
       *[other] { $count } de rânduri
    }; într-o ciornă are cel mult { $limit }. Unul mai lung se poate scrie ca dosar.
error-draft_without_table = Exercițiul nu cere niciun tabel DH, deci nu există tabele de arătat. Adăugați partea „Tabel DH”.
error-publications_full = Sunt publicate deja toate exercițiile pe care le păstrează acest serviciu ({ $limit }). Descărcați dosarul.
author-title = Creează un exercițiu
author-lead = Faceți din brațul din cartea dumneavoastră un exercițiu: desenați-l sau porniți de la ce aveți. Exercițiul se testează în timp ce scrieți.
author-card-start = Robotul
author-card-texts = Titlu și enunț
author-card-parts = Ce se cere
author-card-policy = Ce este liber și ce este fixat
author-card-values = Valori
author-card-help = Ajutor și încercări
author-card-figure = Figura
author-card-preview = Previzualizare
author-card-trials = Încercați-l
author-card-take = Descărcare și publicare
author-selftest = Autotest
author-start = Pornire de la
author-start-robot = Catalog
author-start-axes = Desen
author-start-table = Tabel DH
author-start-scm = Lanț SCM
author-start-urdf = URDF
author-start-robot-hint = Un robot din catalog, cu tabelul și cotele lui.
author-start-axes-hint = Așezați axele cuplelor una după alta, de la bază, cu robotul în zero. Lungimile cu nume devin cotele figurii; tabelul rezultă singur.
author-start-table-hint = Rezolvarea așa cum ați scrie-o: numere sau nume precum L1. Lungimile numerice primesc singure nume.
author-start-scm-hint = Un rând pentru fiecare cuplă: translații X Y Z și rotiri A B C până la următoarea; variabila stă în celula ei, q1, q2, …
author-start-urdf-hint = Un fișier cu un singur lanț serial. Se citesc doar cuplele, nu și plasele; tabelul se termină la ultima cuplă mobilă, fără scula care urmează.
author-robot = Robot
author-begin = Începe cu acest robot
author-started = Exercițiul este gata de scris.
author-urdf-file = Fișier URDF
author-scm-final = Transformarea finală
author-axes = Axele cuplelor
author-axis = { $number } · { $joint }
author-axis-add = Adaugă o axă
author-axis-added = Axa { $number } a fost adăugată.
author-axis-remove = Șterge axa { $number }
author-axis-removed = Axa { $number } a fost ștearsă.
author-axis-joint = Tipul cuplei { $number }
author-placed = Axa { $number } a fost așezată.
author-how = Cum
author-point = Un punct al axei
author-point-at = dat prin coordonate
author-point-on = pe altă axă
author-point-from = deplasat față de altă axă
author-point-axis = Axa
author-point-distance = Distanța de-a lungul ei
author-direction = Direcția ei
author-direction-vector = vector la alegere
author-direction-through = printr-un alt punct
author-along = de-a lungul lui { $axis }
author-parallel = paralelă cu axa { $axis }
author-opposite = opusă axei { $axis }
author-perpendicular = perpendiculară pe axa { $axis }, spre …
author-across = perpendiculară pe axele { $axis } și { $other }
author-lengths-named = Lungimi cu nume
author-lengths-named-hint = Scrieți în orice câmp de mai sus un nume precum L1 sau a2, și sume precum L1 + L2, și dați aici valoarea.
author-lengths-none = Nicio lungime nu are încă nume.
author-scene = Axele în spațiu
author-scene-hint = Faceți clic pe un punct al grilei sau al altei axe ca să puneți acolo axa aleasă, pe o săgeată ca să o rotiți, pe o axă ca să o alegeți. Totul se poate face și în câmpurile de mai jos.
author-scene-text = { $count ->
    [one] O axă de cuplă
    [few] { $count } axe de cuplă
   *[other] { $count } de axe de cuplă
}, cu punctele și direcțiile pe care se poate face clic.
author-language = Limba textului
author-title-of = Titlu
author-statement = Enunț
author-statement-hint = Markdown: paragrafe, liste, *accent*, **aldin**, `cod`. *L1* se culege ca variabilă. Ce se cere și ce este liber nu trebuie spus: serviciul le adaugă în limba cititorului.
author-statement-preview = Cum îl citesc studenții
author-statement-none = Încă nu există text în această limbă: cine o citește vede textul în altă limbă și este înștiințat.
author-statement-waiting = O clipă …
author-points = puncte
author-points-of = Puncte pentru { $part }
author-points-total =
    În total: { $points ->
        [one] { $points } punct
        [few] { $points } puncte
       *[other] { $points } de puncte
    }.
author-rule-convention = Convenția
author-rule-convention-any = oricare
author-rule-convention-standard = standard
author-rule-convention-modified = modificată
author-rule-base = Sistemul 0
author-rule-base-free = oriunde
author-rule-base-axis = z ca în rezolvare
author-rule-base-origin = originea ca în rezolvare
author-rule-base-frame = exact ca în rezolvare
author-rule-tool = Ultimul sistem
author-rule-tool-free = oriunde
author-rule-tool-point = originea în punctul marcat
author-rule-tool-axis = z pe ultima axă
author-rule-tool-frame = exact ca în rezolvare
author-rule-zero = Zeroul variabilelor
author-rule-zero-free = liber
author-rule-zero-figure = ca în figură
author-rule-direction = Sensul pozitiv
author-rule-direction-free = liber
author-rule-direction-figure = ca în figură
author-tolerance-length = Toleranța, ca fracție din mărimea robotului
author-tolerance-angle = Toleranța unghiurilor, rad
author-policy-admits =
    Din cele { $choices ->
        [one] { $choices } mod
        [few] { $choices } moduri
       *[other] { $choices } de moduri
    } în care manualele ar scrie tabelul acestui robot, { $admitted ->
    [one] unul este acceptat
    [few] { $admitted } sunt acceptate
   *[other] { $admitted } de moduri sunt acceptate
}. Sistemele dintre cuple sunt libere în orice caz.
author-values-hint = Fiecare student primește valori proprii unde se dă un interval; în rest este valabilă cea obișnuită.
author-values-none = Tabelul nu are cote cu nume.
author-value = Valoarea obișnuită
author-drawn = trasă la sorți pentru fiecare student
author-draw-from = { $name } de la
author-draw-to = { $name } până la
author-draw-step = { $name } cu pasul
author-draw-from-short = de la
author-draw-to-short = până la
author-draw-step-short = pas
author-aliases = Alte nume
author-help-most = Cât se spune cel mult despre un tabel greșit
author-help-ladder = puțin la început, mai mult cu fiecare încercare
author-attempts = Încercări
author-access = Ce pot folosi studenții în timp ce lucrează
author-access-hint = Studenților veniți printr-o legătură dintr-un curs, serviciul însuși le refuză ce este oprit.
author-access-catalogue = catalogul de roboți
author-access-playground = atelierul
author-access-matrices = matricele unui tabel
author-access-trainer = exersarea sistemelor de coordonate
author-view-azimuth = Vedere: rotire în jurul verticalei
author-view-elevation = Vedere: înălțime
author-posture = Configurația din figură
author-marks = Puncte marcate
author-marks-hint = Sunt necesare dacă regulile țin ultimul sistem într-un punct.
author-mark-end = marchează ultima origine ca P
author-lengths = Cote desenate altfel
author-lengths-hint = Dați unei cote mici altă lungime în figură, ca să se citească bine; figura spune că nu este la scară. Gol: așa cum este.
author-saved = păstrat în acest browser
author-other-tab = Această pagină este deschisă și într-o altă filă, iar ciorna tocmai a fost modificată acolo. Se păstrează numai ciorna modificată ultima dată.
author-test-waiting = Schimbat; testele rulează imediat.
author-test-refused = Testele rulează de îndată ce greșelile semnalate mai sus sunt corectate.
author-test-running = Se testează: răspunsuri corecte cu alte sisteme, greșeli, fiecare parte …
author-test-passed =
    { $passed ->
        [one] Singura verificare a trecut.
        [few] Toate cele { $passed } verificări au trecut.
       *[other] Toate cele { $passed } de verificări au trecut.
    }
author-test-failed = { $failed ->
    [one] O verificare a eșuat
    [few] { $failed } verificări au eșuat
   *[other] { $failed } de verificări au eșuat
}; { $passed } au trecut.
author-test-warnings = Bine de știut:
author-try = Încearcă ca student
author-right = Arată zece răspunsuri corecte diferite
author-right-shown = { $wrong ->
    [0] Toate cele { $count } sunt acceptate; prima este rezolvarea dumneavoastră.
   *[other] { $wrong } din { $count } sunt respinse.
}
author-wrong = Arată cele mai frecvente răspunsuri greșite și punctele lor
author-wrong-hint = Cele mai probabile întâi: ce i s-ar spune unui student și cât mai valorează tot răspunsul. Adăugați cuvintele dumneavoastră unde doriți.
author-wrong-marks =
    { $points } din { $most ->
        [one] { $most } punct
        [few] { $most } puncte
       *[other] { $most } de puncte
    }, tabelul { $score } %
author-wrong-refused = refuzat, nu costă nicio încercare
author-wrong-untold = Nu se sugerează nicio corectură ({ $name }).
author-wrong-tested = exercițiul se testează cu această greșeală
author-own-words = Cuvintele dumneavoastră, după ale noastre
author-id = Numele dosarului
author-download = Descarcă dosarul
author-downloaded = Arhiva conține un dosar pentru git și pentru „framewise exercises check”.
author-publish = Publică pe acest serviciu
author-publish-closed = Acest serviciu nu primește exerciții din această pagină: descărcați dosarul și dați-l celui care administrează serviciul.
author-published = Publicat. Această versiune rămâne așa pentru totdeauna; o modificare creează alta.
author-open = Deschide exercițiul
author-insert = Inserează-l în curs
author-lti-hint = Într-o legătură creată de platforma dumneavoastră, adăugați acest parametru personalizat:
author-link = Copiază o legătură spre ciornă
author-link-copied = Adresa conține acum toată ciorna și este copiată.
author-import = Deschide un dosar (zip)
author-import-hint = Așa cum se descarcă de aici sau cum îl aveți în git.
author-imported = Exercițiul este deschis.

## What a definition may say beside

author-add = Adaugă: { $name }
author-remove = Șterge { $name }
author-usual = valoarea obișnuită
author-dimension-handle = Cota { $name }: trageți-o sau folosiți săgețile; cu Backspace o așază din nou serviciul
author-dimension-hint = Trageți numele unei cote acolo unde se citește bine.
author-dimension-moved = { $name } mutată.
author-dimension-free = { $name } este așezată din nou automat.
author-draw-without = fără
author-part-keys = { $part }: ce se dă și ce se cere
author-part-not-beside = Nu împreună cu „{ $part }”: o parte arată răspunsul celeilalte.
author-needs = Necesare în orice răspuns corect
author-needs-hint = Regulile trebuie să asigure aceasta: fixați baza sau scula, altfel o alegere de sisteme lasă cota pe dinafară.
author-rungs = Se spune cel mult
author-rung = la încercarea { $number }
author-rung-more = Încă o treaptă
author-rung-less = O treaptă mai puțin
author-weights = Cât costă greșelile
author-weights-hint = Ponderi relative: o greșeală cu ponderea 2 costă de două ori cât una cu ponderea 1. Dacă un câmp rămâne gol, este valabilă ponderea obișnuită.
author-weight-joint = cuplă lipsă; de alt tip, dublul
author-weight-twist = o torsiune α
author-weight-length = o lungime a
author-weight-offset = un decalaj d sau θ al unei cuple de translație
author-weight-rule = o regulă nerespectată
author-weight-sign = doar semnul, ca fracție
author-weight-row = o greșeală numită într-un rând, cel mult
author-weight-table = una în tot tabelul, cel mult
author-samples = Răspunsuri proprii pentru teste
author-samples-hint = Autotestul le judecă și spune unde verdictul este altul decât vă așteptați. Încercați un răspuns ca student pentru a-l păstra aici.
author-sample = Exemplu
author-sample-key = rezolvarea
author-sample-name = Ce arată
author-sample-expect = Se așteaptă
author-sample-correct = corect
author-sample-incorrect = greșit
author-sample-invalid = refuzat
author-sample-feedback = Coduri pe care le conține verdictul
author-sample-keep = Păstrează acest răspuns ca exemplu
author-sample-kept = Păstrat printre exemple.
author-figure-more = Toate celelalte detalii ale figurii
author-figure-upright = Cum stă sistemul 0 în figură, grade
author-figure-roll = ruliu
author-figure-pitch = tangaj
author-figure-yaw = girație
author-figure-width = Lățimea hârtiei
author-figure-points = Puncte cu nume
author-figure-joints = Corpurile cuplelor
author-figure-name = Nume
author-figure-at = în punctul
author-figure-label = numărul la capătul
author-figure-scale = mărime
author-figure-reach = lungimea axei
author-figure-links = Elemente
author-figure-links-hint = Un lanț de puncte pe fiecare linie: O0 O1 P
author-figure-marks = Toate punctele marcate
author-figure-ground = Baza fixă
author-figure-normal = direcția dinspre ea, x y z
author-figure-gripper = Prehensor
author-figure-away = dinspre punctul
author-figure-jaws = fălcile una lângă alta după x y z
author-figure-dimension = Cotă
author-figure-value = lungimea, dacă nu e numele
author-figure-offset = mutată spre, x y z
author-figure-distance = cât
author-figure-distance-along = cât de-a lungul ei
author-figure-form = Cum
author-figure-frame = într-un sistem al rezolvării
author-figure-between = între două puncte
author-figure-by = deplasat
author-figure-joint = de-a lungul axei unei cuple
author-figure-coordinates = coordonate
author-figure-ratio = la fracția
author-figure-from = din punctul
author-key-joints = Valorile cuplelor
author-key-turns = Unghiuri trase la sorți pentru fiecare student
author-key-slides = Deplasări trase la sorți pentru fiecare student
author-key-tolerance = Toleranță
author-key-point = Punct marcat
author-key-from = Distanța de la
author-key-limits = Limitele cuplelor
author-key-mistakes = Greșeli care pot fi strecurate
author-key-known = Situare cunoscută
author-key-asked = Se cere: situarea
author-key-ask = Ce se cere
author-key-frame = În axele
author-key-axes = Ordinea axelor
author-key-turning = Rotire în jurul
author-key-asked_axes = Ordinea axelor cerută
author-key-asked_turning = Se cere: rotire în jurul
author-key-wrench = Forța și momentul exercitate de sculă
author-key-cases = Situări care pot fi cerute
author-key-solutions = Soluții cerute
author-key-reach = Ce trebuie atins
author-key-given = Se dă ca
author-key-angles = Unghiuri
author-key-middle = Unghiul din mijloc tras la sorți între
author-choice-jacobian = jacobianul
author-choice-forces = momentele și forțele din cuple
author-choice-base = sistemului 0
author-choice-end = ultimului sistem
author-choice-reached = accesibilă
author-choice-out_of_reach = inaccesibilă
author-choice-all = toate
author-choice-one = una
author-choice-pose = poziția și orientarea
author-choice-position = doar poziția
author-choice-matrix = matrice de rotație
author-choice-quaternion = cuaternion
author-choice-axis_angle = axă și unghi
author-choice-angles = trei unghiuri
author-choice-every_triple = toate tripletele de unghiuri
author-choice-current = axelor sistemului mobil
author-choice-fixed = unor axe fixe
author-choice-axis = axa cuplei 1
author-key-one-joint = { $name } trasă la sorți separat
author-version = Versiunea: măriți-o când se schimbă răspunsurile corecte sau valorile
author-variants = Seturi de valori pentru toți studenții
author-key-motion = Mișcarea care contează
author-choice-twist = viteza liniară și cea unghiulară
author-choice-translation = doar viteza liniară
author-key-links = Elementele brațului
author-key-gravity = Accelerația gravitațională, în sistemul 0
author-key-weights = Simboluri și valorile lor
author-key-matrix = Matricea arătată
author-choice-mass = matricea de inerție M
author-choice-coriolis = o matrice C
author-choice-skew = că Ṁ − 2C este antisimetrică
author-choice-velocity = numai C q̇
author-choice-gravity = termenul gravitațional g
author-choice-link = a unui element
author-choice-transform = a întregului braț
author-body = Elementul { $number }
author-body-mass = masă
author-body-centre = centrul de masă
author-body-moments = momente de inerție
author-quantity-name = Numele unei mărimi
author-quantity-value = valoare
author-quantity-draw = trasă la sorți pentru fiecare student
