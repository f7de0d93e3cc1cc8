### La page qui vérifie un dossier de reçus.

receipts-title = Reçus
receipts-lead = Déposez les fichiers rendus par vos étudiants ou collez leurs textes : chaque reçu est vérifié, et les notes deviennent un fichier pour Moodle ou Canvas.
receipts-files = Fichiers de reçus
receipts-paste = Ou leurs textes, l’un après l’autre
receipts-verify = Vérifier
receipts-none = Il n’y a pas encore de reçu.
receipts-found =
    { $all ->
        [1]
            { $valid ->
                [0] Le reçu n’est pas authentique.
               *[other] Le reçu est authentique.
            }
       *[other] Authentiques : { $valid } sur { $all } reçus.
    }
receipts-save-csv = CSV
receipts-save-moodle = CSV pour Moodle
receipts-save-canvas = CSV pour Canvas
receipts-name = Nom
receipts-exercise = Exercice
receipts-points = Points
receipts-time = Heure
receipts-settings = Réglages
receipts-said = Résultat
receipts-genuine = authentique
receipts-repeated = authentique, mais un autre de ces reçus porte la même réponse
receipts-by-link = par le lien d’un enseignant
receipts-answer = Réponse
receipts-sign = Signé par { $service }. Le code et le texte ci-dessous disent la même chose ; { $page } les vérifie.
