# Fichiers d’étudiants, correcteurs d’autres systèmes, paquets SCORM, reçus.

error-file_too_large =
    { $file } dépasse { $limit ->
        [one] { $limit } octet
       *[other] { $limit } octets
    } ; un tableau tient en quelques kilooctets.
error-file_missing = Il n’y a ni fichier ni dossier { $file }.
error-grade_path_needed = Il faut un fichier, un dossier ou une archive zip : l’entrée standard (-, ou aucun argument) n’est lue qu’avec --for.
error-options_without_effect = { $options } serait sans effet { $host ->
    [yes] avec --for
   *[no] sans --for
}.
error-marks_are_text = { $file } ne contiendrait pas une feuille de calcul : les notes sont écrites en texte, que lisent les tableurs. Donnez au fichier un nom en .csv.
error-file_unreadable = { $file } ne peut pas être lu : { $reason ->
    [empty] il est vide
    [binary] ce n’est pas un fichier de texte
    [columns] ses lignes ne se laissent pas diviser en colonnes ; enregistrez-le en CSV
    [UTF-16] il commence en UTF-16, mais ne l’est pas entièrement ; enregistrez-le en UTF-8
   *[other] { $reason }
}.
error-file_unusable = { $file } ne peut être ni lu ni écrit : { $reason }.
error-file_type_unknown = { $file } est d’un type qui n’est pas lu ici. Sont lus : { $known }.
error-file_without_table = { $file } ne contient aucun tableau DH. Un tableau a les colonnes theta, d, a et alpha.
error-files_too_many = { $file } contient plus de { $limit } fichiers.
error-rows_too_many = { $file } a plus de { $limit } lignes. Partagez-le en plusieurs fichiers.
error-columns_unknown = Aucune ligne de { $file } ne nomme les colonnes { $known }. Écrivez-les au-dessus du tableau.
error-columns_repeated = Les titres { $titles } de { $file } désignent la même colonne. Écrivez chaque colonne une seule fois ; le décalage d’une articulation se met dans sa cellule : q1 + 90.
error-units_differ = Les titres de { $file } nomment deux unités pour la même grandeur : { $units }. Écrivez tous les angles dans une même unité, et toutes les longueurs dans une même unité.
error-columns_differ_in_length = Les colonnes de { $file } n’ont pas la même longueur ; il faut une valeur par ligne dans chacune.
error-exercise_not_named = Il n’est pas dit à quel exercice ceci répond. Nommez-le, par exemple puma560.
error-artefact_unknown = Les productions de type { $type } ne sont pas évaluées ici. Types évalués : { $known }.
error-function_command_unknown = Cette commande n’est pas connue. Commandes connues : { $known }.
error-function_call_invalid = Le corps d’un appel contient `response`, `answer` et `params` (un objet). Ce n’est pas le cas en : { $places }.
error-callback_not_allowed = L’exploitant de ce service ne permet pas d’envoyer de retour à cette adresse.
error-version_not_supported = Cette version de l’API d’évaluation n’est pas prise en charge. Version prise en charge : { $supported }.

error-api_key_unknown = Il n’y a pas de clé { $id }.
error-key_file_unreadable = { $file } n’est pas un fichier de clés utilisable : { $reason }.
error-receipt_kid_unknown = { $file } ne contient pas de clé { $id }.
error-receipt_malformed = Ce n’est pas un reçu, ou pas un reçu entier. Copiez-le du premier caractère au dernier.
error-receipt_key_unknown = Le reçu a été signé avec une clé que ce service n’a pas. Demandez au service qui l’a délivré.
error-receipt_altered = Le reçu a été modifié après sa délivrance.

evaluation-right = Juste
evaluation-wrong = Pas encore juste
evaluation-readable = La réponse peut être notée.
evaluation-unreadable = La réponse ne peut pas être notée telle quelle ; cela ne compte pas comme un essai.

scorm-no-script = Cet exercice a besoin de JavaScript.
scorm-no-lms = Aucune plateforme d’apprentissage n’a été trouvée autour de cette page. Vous pouvez vous entraîner, mais aucune note ne sera enregistrée.

grade-summary = Réponses justes : { $right }, fausses : { $wrong }, impossibles à noter : { $ungraded }.
grade-left-out = Fichiers laissés de côté à cause de leur type : { $count } ({ $files }).
