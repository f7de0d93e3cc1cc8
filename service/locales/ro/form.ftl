# Formularul web al studenților: ce spune fiecare pagină.

form-skip = Sari la conținut
form-nav-label = Pagini
form-nav-exercises = Exerciții
form-nav-playground = Atelier
form-language = Limbă
form-needs-script = Pagina are nevoie de JavaScript: cu el desenează robotul și verifică tabelul în timp ce scrieți.
form-unreachable = Serviciul nu poate fi contactat. Ce ați scris s-a păstrat; încercați din nou peste câteva clipe.
form-retry = Încearcă din nou
form-cancel = Renunță
form-close = Închide
form-named = { $name }: { $said }
form-loading = Se încarcă …

form-home-title = Exerciții
form-home-heading = Descrieți robotul. Orice alegere corectă a sistemelor de coordonate este acceptată.
form-home-lead = Tabele Denavit–Hartenberg cu un robot care se mișcă în timp ce scrieți și un verificator care demonstrează dacă tabelul descrie același mecanism.
form-home-exercises = Exerciții
form-home-subjects = Subiecte
form-home-more = Mai multe
form-home-playground = Orice tabel: situări, jacobieni, forme închise, conversii.
form-home-api = Interfață de programare
form-home-api-text = Același lucru prin HTTP, ca document OpenAPI.
form-home-best =
    Cel mai bine: { $points } din { $total ->
        [one] { $total } punct
        [few] { $total } puncte
       *[other] { $total } de puncte
    }
form-home-joints =
    { $joints ->
        [one] O cuplă
        [few] { $joints } cuple
       *[other] { $joints } de cuple
    }
form-home-trainer = Exersează alegerea sistemelor de coordonate

form-scene-role = vedere 3D
form-scene-label = Robot
form-scene-tools = Vedere
form-scene-view = Privește
form-scene-view-corner = Din colț
form-scene-view-front = Din față
form-scene-view-side = Din lateral
form-scene-view-top = De sus
form-scene-view-now = Vedere: { $view }
form-scene-turn-left = Rotește la stânga
form-scene-turn-right = Rotește la dreapta
form-scene-turn-up = Înclină în sus
form-scene-turn-down = Înclină în jos
form-scene-zoom-in = Mărește
form-scene-zoom-out = Micșorează
form-scene-reset = Arată tot
form-scene-keys = Tastele săgeți rotesc vederea, Shift și săgeți o deplasează, + și − o măresc și o micșorează, 0 arată tot.

form-joint = Cuplă
form-joint-revolute = rotație
form-joint-prismatic = translație
form-joint-fixed = fixă
form-joint-of-row = Tipul cuplei, rândul { $row }
form-joint-turn = Unghiul cuplei { $name }
form-joint-slide = Deplasarea cuplei { $name }
form-joint-value = { $name } în { unit-word }
form-joints-reset = Readu cuplele în poziția inițială

form-convention = Convenție
form-convention-standard = standard
form-convention-modified = modificată
form-convention-now-standard = Valorile rămân cum sunt și se citesc acum în convenția standard: a și α aparțin elementului i, cupla i se mișcă după axa z a sistemului i−1.
form-convention-now-modified = Valorile rămân cum sunt și se citesc acum în convenția modificată: a și α aparțin elementului i−1, cupla i se mișcă după axa z a sistemului i.
form-angle-unit = Unitatea unghiurilor
form-degrees = grade
form-radians = radiani
form-length-unit = Unitatea lungimilor
unit-word = { $unit ->
    [in] inci
   *[other] { $unit }
}
form-unit-now-deg = Numerele din coloanele de unghiuri se citesc acum în grade.
form-unit-now-rad = Numerele din coloanele de unghiuri se citesc acum în radiani.
form-unit-now-length = Numerele din coloanele de lungimi se citesc acum în { unit-word }.
form-unit-doubt-deg = { $value } rad înseamnă mai mult de o rotație completă. Unghiurile sunt în grade?
form-unit-doubt-rad = { $value }° este un unghi foarte mic. Unghiurile sunt în radiani?
form-unit-read-deg = Citește-le în grade
form-unit-read-rad = Citește-le în radiani
form-unit-convert = Convertește numerele
form-unit-converted = Numerele au fost convertite.
form-unit-converted-but =
    { $count ->
        [one] Numerele au fost convertite, cu excepția unei celule care nu este o simplă sumă: verificați-o.
        [few] Numerele au fost convertite, cu excepția a { $count } celule care nu sunt simple sume: verificați-le.
       *[other] Numerele au fost convertite, cu excepția a { $count } de celule care nu sunt simple sume: verificați-le.
    }

form-table-caption = Tabel DH, convenția { $convention }
form-row-actions = Acțiuni
form-row-add = Adaugă un rând
form-row-added = Rândul { $row } a fost adăugat
form-row-remove = Șterge rândul { $row }
form-row-removed = Rândul { $row } a fost șters
form-row-up = Mută rândul { $row } mai sus
form-row-down = Mută rândul { $row } mai jos
form-row-moved = Rândul { $row } este acum rândul { $to }
form-row = rândul { $row }
form-column = coloana { $name }
form-row-cell = rândul { $row }, { $name }
form-cell-label = Rândul { $row }, { $name } [{ $unit }]
form-cell-empty = Goală: scrieți 0 dacă este zero.
form-refused = Nu a funcționat:
form-faults =
    { $count ->
        [one] O celulă trebuie corectată:
        [few] { $count } celule trebuie corectate:
       *[other] { $count } de celule trebuie corectate:
    }
form-undo = Anulează
form-undone = Anulat
form-redo = Refă
form-redone = Refăcut
form-symbols = Simboluri
form-symbol-insert = Inserează { $symbol }
form-keys = Săgețile sus și jos schimbă rândul · Alt și săgeată mută rândul · Alt+Enter adaugă unul · Alt+Delete îl șterge · Ctrl+Z anulează.
form-paste-title = Lipește un tabel
form-paste-label = Un tabel din foaie de calcul, LaTeX, Markdown, PDF, MATLAB sau Python
form-paste-order = Coloanele fără antet se citesc în ordinea: { $order }
form-paste-found =
    { $rows ->
        [one] S-a găsit un rând:
        [few] S-au găsit { $rows } rânduri:
       *[other] S-au găsit { $rows } de rânduri:
    }
form-paste-nothing = În acest text nu se recunoaște niciun tabel: fiecare rând are nevoie de cei patru parametri DH.
form-paste-preview = Ce s-a găsit
form-paste-apply = Folosește tabelul
form-pasted =
    { $rows ->
        [one] S-a lipit un rând.
        [few] S-au lipit { $rows } rânduri.
       *[other] S-au lipit { $rows } de rânduri.
    }

form-matrix-mode = Matricele ca
form-matrix-numbers = Numere
form-matrix-symbols = Simboluri
form-matrix-notation = Notație
form-matrix-short = scurtă
form-matrix-full = completă
form-matrix-none = Matricele apar de îndată ce fiecare rând poate fi citit.
form-matrix-name = Situarea sistemului { $to } în sistemul { $from }
form-copy = Copiază ca
form-copy-group = Copiază: { $what }
form-copied = Copiat ca { $format }
form-copy-failed = Browserul nu permite copierea

form-exercise-title = Exercițiu
form-exercise-task = Cerință
form-exercise-robot = Robotul
form-exercise-description = Descriere în cuvinte
form-exercise-answer = Răspunsul dumneavoastră
form-exercise-givens = Se dau
form-exercise-rules = Ce este liber și ce este fixat
form-figure-mode = Arată robotul ca
form-figure-drawing = Desen
form-figure-space = 3D
form-figure-alt = Desenul robotului: { $title }. Urmează o descriere în cuvinte.
form-figure-label = { $title } în spațiu
form-figure-move = Mișcă cuplele
form-figure-posture = Valorile se măsoară de la configurația din desen.
form-choose = Alegeți …
form-choose-missing = Alegeți una dintre variante.
form-points =
    { $points } din { $total ->
        [one] { $total } punct
        [few] { $total } puncte
       *[other] { $total } de puncte
    }
form-row-go = La rândul { $row }
form-row-heading = Rând
form-row-missing =
    { $after ->
        [0] înainte de 1
       *[other] după { $after }
    }
form-submit = Verifică răspunsul
form-submitting = Se verifică …
form-submit-hint = Ctrl+Enter face același lucru.
form-help = Dacă răspunsul este greșit, spune-mi
form-help-verdict = doar atât
form-help-row = ce rânduri sunt greșite
form-help-kind = ce este greșit în fiecare rând
form-help-repair = ce l-ar face corect

form-part-table = Tabel DH
form-part-schematic = Structură
form-part-link-matrices = Matricele elementelor
form-part-transform = Situarea ultimului sistem, în simboluri
form-part-pose = Situarea ultimului sistem, în numere
form-part-workspace = Spațiu de lucru
form-part-orientation = Orientare
form-part-rotation-check = Rotație sau nu
form-part-frame-chain = Lanț de sisteme
form-part-inverse-kinematics = Cinematica inversă
form-part-find-mistake = Găsiți greșeala
form-part-matrix-mistake = Găsiți greșeala într-o matrice
form-part-frame-mistake = Găsiți greșeala într-o figură
form-part-compare-tables = Două tabele
form-part-screws = Produs de exponențiale
form-part-jacobian = Jacobian și statică
form-part-jacobian-form = Jacobianul în formă închisă
form-part-singularities = Singularități
form-part-equations-of-motion = Ecuații de mișcare
form-part-wrong = De revăzut:
form-radius-inner = Raza interioară
form-radius-outer = Raza exterioară
form-matrix-cell = { $name }, rândul { $row }, coloana { $column }
form-schematic-joint = Cupla { $joint }
form-schematic-relation = Axa { $joint } față de axa { $next }
form-relation-coincident = coincidente
form-relation-parallel = paralele
form-relation-intersecting-perpendicular = concurente, perpendiculare
form-relation-intersecting-oblique = concurente, oblice
form-relation-skew-perpendicular = necoplanare, perpendiculare
form-relation-skew-oblique = necoplanare, oblice

form-own-heading = Robotul dumneavoastră
form-own-scene = Robotul dumneavoastră, așa cum îl descrie tabelul
form-own-empty = Robotul dumneavoastră crește aici cu fiecare rând care poate fi citit.
form-own-missing =
    { $count ->
        [one] O celulă este încă goală.
        [few] { $count } celule sunt încă goale.
       *[other] { $count } de celule sunt încă goale.
    }
form-own-unread =
    { $count ->
        [one] O celulă nu poate fi citită încă.
        [few] { $count } celule nu pot fi citite încă.
       *[other] { $count } de celule nu pot fi citite încă.
    }
form-own-last = Imaginea arată ultimul tabel care a putut fi citit.
form-own-values = Pentru desen, dați o valoare pentru: { $names }.
form-own-shown =
    { $joints ->
        [one] Desenat după tabel: o cuplă.
        [few] Desenat după tabel: { $joints } cuple.
       *[other] Desenat după tabel: { $joints } de cuple.
    }
form-own-description = Sistemele de coordonate ale tabelului, cu axele x, y și z.{ $count ->
    [0] {""}
   *[other] {" "}Cuple: { $joints }.
}
form-own-parameters = Valori pentru desen
form-joints = Cuple
form-matrices = Matrice

form-verdict-heading = Verdict
form-verdict-correct = Tabelul descrie acest robot.
form-verdict-wrong = Tabelul dumneavoastră nu este încă corect.
form-verdict-all = Tot ce ați predat este corect.
form-verdict-some = Încă nu totul este corect.
form-verdict-outdated = Între timp ați modificat răspunsul.
form-basis-proved = Demonstrat: identitatea are loc pentru toate valorile cuplelor.
form-basis-verified = Verificat pentru multe configurații.
form-links-caption = Ce este corect în fiecare rând
form-fact-twist = Torsiunea α
form-fact-length = Lungimea a
form-fact-offset = Decalajul
form-fact-joint = Tipul cuplei
form-finding-ok = corect
form-finding-wrong = greșit
form-finding-doubtful = poate greșit
form-finding-missing = lipsește
form-finding-unknown = nedecis
form-finding-hidden = –
form-repairs = Ce l-ar face corect
form-repair-or = sau
form-both-label = Robotul exercițiului și cel al dumneavoastră, mișcându-se împreună
form-both-text = Cei doi roboți se mișcă împreună: al dumneavoastră cu sistemele alese, cel al exercițiului în gri și portocaliu.
form-both-description = Sistemele dumneavoastră stau pe robotul exercițiului și amândoi urmează aceeași mișcare.
form-both-position = Momentul mișcării
form-play = Pornește
form-pause = Pauză

form-history-heading = Încercările dumneavoastră
form-history-restore = Readu în formular
form-history-restored = Încercarea este din nou în formular
form-history-kept = Se păstrează numai în acest browser.
form-history-clear = Șterge istoricul

form-missing-title = Nu există
form-missing-text = Această pagină nu există. Toate exercițiile sunt pe prima pagină.
form-missing-home = La exerciții
form-storage-blocked = Browserul nu păstrează nimic aici: ce scrieți se pierde când închideți sau reîncărcați pagina.
form-other-tab = Acest exercițiu este deschis și în altă filă, iar acolo tocmai s-a scris ceva. Se păstrează ce se scrie ultimul.
form-other-tab-take = Arată ce s-a scris acolo

form-row-play = Arată rândul { $row } în imagine
form-film = Rândul pas cu pas
form-film-hint = Puneți cursorul într-o celulă sau apăsați numărul unui rând: se vede cum cele patru numere duc sistemul i−1 în sistemul i.
form-film-none = Rândul { $row } nu poate fi arătat încă: completați-l, împreună cu rândurile dinaintea lui.
form-film-play = Redă rândul
form-film-back = Un pas înapoi
form-film-forward = Un pas înainte
form-film-row-before = Rândul anterior
form-film-row-after = Rândul următor
form-film-start = Rândul { $row }: se pornește din sistemul { $frame }.
form-film-turn = Rândul { $row }, { $number } din 4: rotație în jurul axei { $axis } cu { $letter } = { $value }.
form-film-slide = Rândul { $row }, { $number } din 4: translație de-a lungul axei { $axis } cu { $letter } = { $value }.
form-scene-enlarge = Ecran complet
form-scene-record = Salvează ca imagine
form-scene-recorded = Imagine salvată
form-own-rows =
    { $rows ->
        [one] Desenat până acum: un rând.
        [few] Desenate până acum: { $rows } rânduri.
       *[other] Desenate până acum: { $rows } de rânduri.
    }

form-matrix-text = Ca text
form-matrix-text-label = { $name } ca text: LaTeX, MATLAB, Python sau celule dintr-o foaie de calcul
form-matrix-text-unread = În acest text nu se recunoaște nicio matrice 4×4.
form-name-unknown =
    { $known ->
        [none] { $name } nu este o cotă a acestui robot; niciuna nu are nume.
       *[other] { $name } nu este o cotă a acestui robot. Cotele lui: { $names }.
    }

form-nav-lesson = Prima lecție
form-term = Ce înseamnă „{ $term }”?
form-convention-what = Ce sunt acestea?
form-exercise-write = Atașați câte un sistem de coordonate fiecărui element și scrieți tabelul DH al acestui robot.

form-why = De ce este corect fiecare rând
form-why-row = Rândul { $row }: poziția axelor z{ $before } și z{ $row }: { $relation }; de aceea α = { $alpha } și a = { $a }; de-a lungul lui z, sistemele sunt la distanța d = { $d }.
form-second-table = Un al doilea tabel valid
form-second-other-convention = Este scris în convenția { $convention }.
form-second-axis-reversed = O axă z are sensul opus sau o variabilă de cuplă se măsoară în sens opus.
form-second-x-turned = O axă x este orientată altfel, deci variabila cuplei ei este zero în altă poziție.
form-second-origin-moved = O origine se află în alt punct al axei sale.
form-second-none = Regulile acestui exercițiu nu lasă alt tabel.

form-ghost-label = Robotul dumneavoastră, transparent, peste cel al exercițiului
form-ghost-text = Robotul exercițiului este gri și portocaliu, al dumneavoastră roșu transparent. Amândoi fac aceeași mișcare. Sistemul marcat { $row }, cel al rândului { $row }, este primul care se desprinde de robotul exercițiului.
form-ghost-description = Robotul dumneavoastră coincide cu cel al exercițiului înainte de sistemul { $row }, care este marcat: acolo se despart.
form-ghost-later = În acest moment se verifică atât de multe răspunsuri, încât încă nu s-a desenat unde se desprinde robotul dumneavoastră de cel al exercițiului.
form-ghost-draw = Desenează acum
form-ghost-none = Robotul dumneavoastră nu poate fi desenat peste cel al exercițiului.
form-new = Nou
form-new-done = Un tabel nou, gol.

form-progress = Progres
form-progress-open = de făcut
form-progress-typed = neverificat încă
form-part-missing = nepredat
form-part-empty = Aici nu este scris încă nimic.
form-submit-part = Verifică această parte
form-points-for = Un tabel greșit primește puncte pentru torsiunile, lungimile și decalajele corecte pe care un tabel de zerouri nu le-ar avea. Cel mai mult costă o cuplă care lipsește sau are tipul greșit, cel mai puțin un semn greșit.
form-help-steps = câte o indicație
form-help-principle = Principiul.
form-help-worked = Un pas rezolvat, pe alt robot.
form-help-next = Pentru următoarea indicație, modificați răspunsul și verificați-l din nou.
form-principle-twist = Torsiunea α duce o axă z în următoarea, privită de-a lungul axei x, care este perpendiculară pe amândouă. Axele z paralele au 0° sau 180°, cele perpendiculare 90° sau −90°; mâna dreaptă, cu degetul mare după x, dă semnul.
form-principle-length = Lungimea a este distanța dintre două axe z vecine, măsurată pe perpendiculara lor comună, care este axa x. Este 0 dacă și numai dacă cele două drepte se intersectează.
form-principle-offset = Decalajul d este distanța de-a lungul unei axe z între picioarele a două perpendiculare comune: cea de la axa dinainte și cea spre axa următoare. Între axe paralele puteți alege unde stă perpendiculara, dar o singură dată.
form-principle-joint = O cuplă de rotație se rotește în jurul axei sale z: variabila este θ. O cuplă de translație alunecă de-a lungul ei: variabila este d. Fiecare cuplă are un rând, în ordine de la bază la sculă.
form-worked-twist = Un umăr a cărui primă axă este verticală, iar a doua orizontală: cele două axe z sunt perpendiculare. Cu x spre dumneavoastră, mâna dreaptă rotește axa z verticală peste cea orizontală cu −90° sau 90°, după sensul ales pentru z; deci α = −90° sau 90°, niciodată 0.
form-worked-length = Două elemente într-un plan, de 0,4 m și 0,3 m: ambele axe sunt verticale, la 0,4 m una de alta. Perpendiculara lor comună este primul element, deci a = 0,4 m. La o încheietură ale cărei axe se intersectează într-un punct, fiecare a este 0.
form-worked-offset = Un umăr se află la 0,2 m lateral de prima axă, verticală, iar a doua axă este orizontală. De-a lungul celei de-a doua axe sunt 0,2 m între piciorul perpendicularei de la prima și cel al perpendicularei spre a treia: d = 0,2 m, în rândul celei de-a doua cuple.
form-worked-joint = Un portal își mișcă căruciorul pe o șină și rotește prehensorul de sub el. Șina este o cuplă de translație: rândul ei are variabila în d și un număr în θ. Prehensorul este o cuplă de rotație: variabila în θ și un număr în d.
form-home-author = Creează un exercițiu
form-home-author-text = Pentru profesori: faceți din brațul din cartea dumneavoastră un exercițiu, într-un sfert de oră.

form-matrices-withheld = Matricele apar aici când părțile care le cer sunt corecte.
form-sharing = Pentru profesori: legături și pachete
form-sharing-text = O legătură poartă aceste setări, semnate: cine vine prin ea nu le poate schimba, iar serviciul însuși le impune. Un pachet SCORM intră într-un curs fără administrator; nota lui vine din browserul studentului, dar recipisa din comentarii nu poate fi falsificată.
form-sharing-may = Studenții pot folosi
form-sharing-catalogue = catalogul de roboți
form-sharing-playground = atelierul
form-sharing-matrices = matricele propriului tabel
form-sharing-trainer = exersarea sistemelor de coordonate
form-sharing-help = Ce li se spune despre un răspuns greșit
form-sharing-attempts = Încercări
form-sharing-link = Creează o legătură
form-sharing-receipts = Verifică recipise
form-receipt = Obține o recipisă
form-receipt-text = Recipisa spune ce a obținut acest răspuns și este semnată de acest serviciu. Predați-o profesorului: ca text, ca un cod QR sau ca pagină tipărită.
form-receipt-name = Numele dumneavoastră, așa cum apare la curs
form-receipt-as-text = Recipisa ca text
form-receipt-copy = Copiază textul
form-receipt-qr = Recipisa ca un cod QR
form-receipt-pdf = Pagină de tipărit (PDF)

form-part-frames = Sisteme de coordonate
form-frames-hint = Lungimi în { unit-word }. O direcție poate avea orice lungime.
form-frames-scene = Robotul cu sistemele dumneavoastră
form-frames-drawn = Sunt desenate { $drawn } din { $all } sisteme.
form-frames-frame = Sistemul { $frame }
form-frames-z = z arată
form-frames-origin = Originea
form-frames-x = x arată
form-frames-z-of = axa z a sistemului { $frame }
form-frames-origin-of = originea sistemului { $frame }
form-frames-x-of = axa x a sistemului { $frame }
form-frames-ends = unde se află primul și ultimul sistem
form-frames-typed = scris …
form-frames-at-joint = la corpul cuplei { $joint }
form-frames-at-point = în { $name }
form-frames-at-ground = unde este fixat robotul
form-frames-along = de-a lungul axei cuplei { $joint }
form-frames-against = în sens opus axei cuplei { $joint }
form-answer-empty = Nu s-a predat nimic. Exercițiul cere: { $parts }.
