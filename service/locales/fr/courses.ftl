### Cours, essais conservés et lancements depuis une plateforme d’apprentissage : ce qui est refusé, et pourquoi.

problem-title-401 = Vous n’êtes pas connecté
problem-title-403 = Accès réservé
problem-title-409 = Impossible pour l’instant

## Stockage

error-storage_folder = Le dossier de données { $folder } est inutilisable : { $reason }. Indiquez dans FRAMEWISE_DATA_FOLDER un dossier accessible en écriture, ou mettez FRAMEWISE_STORAGE à off.
error-storage_address = FRAMEWISE_DATABASE_URL ne désigne pas une base PostgreSQL. La forme attendue est postgresql://utilisateur:motdepasse@serveur/base.
error-storage_unusable = La base de données { $location } est inutilisable : { $reason }.
error-storage_unavailable = La base de données ne répond pas pour l’instant. Ce qui a déjà été confirmé est en sécurité. Renvoyez ceci dans quelques secondes.
error-storage_missing = Il n’y a pas de base de données à l’emplacement { $location }. FRAMEWISE_DATA_FOLDER ou FRAMEWISE_DATABASE_URL doit indiquer celle du service.
error-schema_newer = Les données ont été écrites par une version plus récente du programme (schéma { $found } ; cette version connaît { $known }). Installez la version plus récente.
error-storage_not_empty = Une sauvegarde n’est restaurée que dans une base vide ; la relation { $table } contient déjà des lignes.
error-backup_unreadable = { $file } ne peut être ni lu ni écrit comme sauvegarde : { $reason }.

## Essais

error-record_unknown = { $kind ->
    [attempt] Cet essai n’existe pas dans ce cours.
    [person] Cette personne n’existe pas dans ce cours.
    [anybody] Cette personne n’existe pas ici.
    [several] Plusieurs pseudonymes commencent ainsi. Donnez plus de caractères ; une exportation le montre en entier.
    [link] Ce lien n’existe pas dans ce cours.
    [platform] Cette plateforme n’existe pas.
    [course] Ce cours n’existe pas.
   *[other] Cet enregistrement n’existe pas dans ce cours.
}
error-attempts_not_open = Les essais sont acceptés à partir du { TIME($opens) } UTC.
error-attempts_closed = L’exercice a fermé le { TIME($closes) } UTC.
error-attempts_used = { $allowed ->
    [1] Le seul essai que permet cet exercice a été fait.
   *[other] Les { $allowed } essais que permet cet exercice ont tous été faits.
}
error-exercise_changed = L’exercice a été modifié après l’ouverture de cette page, et rien n’a été rendu. Rechargez la page : ce que vous avez saisi est toujours là.
error-settings_changed = Vos modifications n’ont pas été enregistrées : quelqu’un d’autre a enregistré d’autres règles depuis l’ouverture de cette page. Rechargez la page et consultez-les.
error-regrading_outdated = Rien n’a été appliqué : l’exercice ou les règles du lien ont changé depuis le calcul de ces notes, ou d’autres notes ont été appliquées. Notez à nouveau.
error-scores_unsent = { $count ->
    [one] Rien n’a été supprimé : le carnet de notes n’a pas reçu { $count } note de ce cours. Voyez ce qui la retient ; pour la perdre, ajoutez --with-unsent.
   *[other] Rien n’a été supprimé : le carnet de notes n’a pas reçu { $count } notes de ce cours. Voyez ce qui les retient ; pour les perdre, ajoutez --with-unsent.
}
error-setting_invalid = { $name } peut valoir : { $known }.
error-closes_before_opening = L’exercice fermerait avant d’ouvrir.
error-session_expired = Vous n’êtes plus connecté. Ce que vous avez saisi est toujours là : rouvrez l’exercice depuis votre cours.
error-administrator_unknown = Cette page s’ouvre avec une adresse qu’affiche framewise lti administer. L’adresse fonctionne une seule fois, dans les dix minutes ; la session dure deux heures.
error-code_used = Cette adresse a déjà servi. Rouvrez l’exercice depuis votre cours.
error-staff_only = Ceci est réservé à l’équipe enseignante du cours.
error-publishing_closed =
    { $who ->
        [staff] Ici, seules les personnes venues d’un cours en tant qu’enseignants, ou munies d’une clé de portée publish, peuvent publier des exercices.
        [key] Ici, des exercices ne peuvent être publiés qu’avec une clé de portée publish.
       *[nobody] Personne ne peut publier d’exercices sur ce service.
    }
error-link_without_exercise = Aucun exercice n’a encore été choisi pour ce lien. Un enseignant le choisit en ouvrant le lien.
error-invitation_used = Cette adresse d’enregistrement a déjà servi ou est trop ancienne. Demandez-en une nouvelle.
error-storage_off = Cette installation ne conserve pas de cours : son stockage est désactivé.
error-posted_form_too_large =
    Le formulaire dépasse { $limit ->
        [one] { $limit } octet
       *[other] { $limit } octets
    }.
error-form_invalid = Le corps n’est pas un formulaire (application/x-www-form-urlencoded).
