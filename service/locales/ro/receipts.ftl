### Pagina care verifică un dosar de recipise.

receipts-title = Recipise
receipts-lead = Trageți aici fișierele predate de studenți sau lipiți textele lor: fiecare recipisă este verificată, iar notele devin un fișier pentru Moodle sau Canvas.
receipts-files = Fișiere cu recipise
receipts-paste = Sau textele lor, unul după altul
receipts-verify = Verifică
receipts-none = Încă nu există nicio recipisă.
receipts-found =
    { $all ->
        [1]
            { $valid ->
                [0] Recipisa nu este autentică.
               *[other] Recipisa este autentică.
            }
        [few] Autentice: { $valid } din { $all } recipise.
       *[other] Autentice: { $valid } din { $all } de recipise.
    }
receipts-save-csv = CSV
receipts-save-moodle = CSV pentru Moodle
receipts-save-canvas = CSV pentru Canvas
receipts-name = Nume
receipts-exercise = Exercițiu
receipts-points = Puncte
receipts-time = Ora
receipts-settings = Setări
receipts-said = Constatare
receipts-genuine = autentică
receipts-repeated = autentică, dar altă recipisă de aici are același răspuns
receipts-by-link = prin legătura unui profesor
receipts-answer = Răspuns
receipts-sign = Semnată de { $service }. Codul și textul de mai jos spun același lucru; { $page } le verifică.
