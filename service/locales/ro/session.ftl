### Lansări dintr-un curs și ce citește un student autentificat.

session-launch-title = Se deschide exercițiul
session-registration-title = Înregistrarea unei platforme de învățare
session-new-window = Deschide într-o fereastră nouă
session-registered = Framewise este înregistrat la { $issuer }. Un administrator Framewise activează înregistrarea; apoi se pot crea legături.
session-registered-again = Framewise este din nou înregistrat la { $issuer }; legăturile funcționează ca înainte.
session-tool-description = Exerciții de cinematica roboților: se acceptă orice alegere corectă a sistemelor de coordonate, iar tabelele greșite sunt explicate.
session-heading = Sesiunea dumneavoastră
session-signed-in = Autentificat ca { $name } · { $course }
session-attempts = Încercări: { $made }
session-attempts-of = Încercări: { $made } din { $allowed }
session-hand-in = Predă
session-hand-in-ready = Predă ce este gata
session-counting = { $counting ->
    [first] Contează prima încercare
   *[last] Contează ultima încercare
}
session-penalty = Fiecare încercare în plus costă { $percent } din totalul punctelor
session-closes = Se închide: { $when }
session-grade =
    Contează { $points } din { $total ->
        [one] { $total } punct
        [few] { $total } puncte
       *[other] { $total } de puncte
    }
session-gradebook = Pentru catalog: { $percent }
session-no-more = Acum nu se primesc încercări
session-back = Înapoi la curs
session-received = Încercarea { $attempt } a fost primită și păstrată. Rezultatul se arată mai târziu.
session-draft-other = Se afișează ce ați scris ultima dată. Există și o altă versiune a răspunsului, din { $when }.
session-draft-take = Arată cealaltă versiune
session-exercise-changed = Exercițiul a fost modificat după o încercare anterioară
session-attempt-then = Încercarea { $attempt } a fost făcută înainte ca exercițiul să fie modificat. Rezultatul ei se referă la exercițiul de atunci.
session-exercise-then = Vezi exercițiul așa cum era
session-opens = Se deschide: { $when }
session-late = Închis: încercările nu mai contează
session-handed-in = predat
session-attempts-kept = Se păstrează în cursul dumneavoastră.
session-attempts-latest = Aici apar ultimele { $count }.
session-ended = Nu mai sunteți autentificat: răspunsurile pe care le dați aici nu contează. Deschideți din nou exercițiul din cursul dumneavoastră; ce ați scris acolo este încă acolo.
session-elsewhere = Cursul dumneavoastră cere alt exercițiu: răspunsurile la acesta nu contează.
session-elsewhere-go = Deschide exercițiul din curs
session-launch-by-hand = Platformele de învățare îi trimit aici pe studenți; singură, această adresă nu arată nimic. Deschideți exercițiul din cursul dumneavoastră.
