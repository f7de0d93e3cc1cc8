error-text_markup = Ceci est du balisage, qu’aucun texte d’exercice ne peut contenir : { $found }. Écrivez L1 < L2 avec des espaces.
error-text_too_long = Le texte est trop long ; { $limit } caractères au plus sont admis.
error-text_control_character = Le texte contient le caractère de contrôle { $found }, qui ne se voit pas. Supprimez-le.
error-statement_not_text = L’énoncé n’est pas un texte en UTF-8.
error-draft_too_large = La définition est plus grande que ne peut l’être celle d’un robot : une table ou une liste a { $entries } entrées au plus, toutes ensemble { $values }, et { $deepest } niveaux d’imbrication au plus.
error-archive_too_large =
    L’archive est trop grande ; un exercice a { $limit ->
        [one] { $limit } octet
       *[other] { $limit } octets
    } au plus.
error-archive_not_zip = Ce n’est pas une archive zip lisible.
error-archive_too_many_files = L’archive contient { $count } fichiers ; le dossier d’un exercice en a { $limit } au plus.
error-archive_entry = { $name } ne fait pas partie d’un exercice : un dossier avec { $known } et des fichiers statement.<langue>.md, et rien d’autre.
error-archive_method = { $name } est chiffré ou compressé d’une manière qui n’est pas lue ici. Utilisez un zip ordinaire.
error-archive_file_too_large =
    { $name } est trop grand ; un fichier d’un exercice a { $limit ->
        [one] { $limit } octet
       *[other] { $limit } octets
    } au plus.
error-archive_no_exercise = L’archive ne contient pas d’exercice : un dossier avec { $known } est attendu.
error-source_form = Un exercice part de l’une de ces sources : { $known }.
error-drawing_too_many_axes = Il y a { $count } axes ; on peut en dessiner { $limit } au plus.
error-drawing_too_many_lengths = Il y a { $count } longueurs nommées ; { $limit } au plus sont possibles.
error-axis_not_before = { $before ->
    [0] Aucun axe n’est dessiné avant celui-ci : l’axe { $axis } ne peut servir de référence.
    [1] Seul l’axe 1 est dessiné avant celui-ci, pas l’axe { $axis }.
   *[other] L’axe { $axis } n’est pas parmi les { $before } axes dessinés avant celui-ci.
}
error-length_unknown = { $name } n’est pas encore une longueur de ce dessin. Ses longueurs : { $known }.
error-draft_too_many_rows = Le tableau a { $count } lignes ; dans un brouillon, il en a { $limit } au plus. Un plus long peut s’écrire comme dossier.
error-draft_without_table = L’exercice ne demande pas de tableau DH : il n’y a donc pas de tableaux à montrer. Ajoutez la partie « Tableau DH ».
error-publications_full = Ce service contient déjà autant d’exercices publiés qu’il en garde ({ $limit }). Téléchargez plutôt le dossier.
author-title = Créer un exercice
author-lead = Faites du bras de votre propre livre un exercice : dessinez-le, ou partez de ce que vous avez. L’exercice se teste pendant que vous écrivez.
author-card-start = Le robot
author-card-texts = Titre et énoncé
author-card-parts = Ce qui est demandé
author-card-policy = Ce qui est libre, ce qui est fixé
author-card-values = Valeurs
author-card-help = Aide et essais
author-card-figure = Figure
author-card-preview = Aperçu
author-card-trials = Essayez-le
author-card-take = Télécharger et publier
author-selftest = Autotest
author-start = Partir de
author-start-robot = Catalogue
author-start-axes = Dessin
author-start-table = Tableau DH
author-start-scm = Chaîne SCM
author-start-urdf = URDF
author-start-robot-hint = Un robot du catalogue, avec son tableau et ses cotes.
author-start-axes-hint = Placez les axes des articulations l’un après l’autre, depuis la base, le robot étant à zéro. Les longueurs nommées deviennent les cotes de la figure ; le tableau en découle.
author-start-table-hint = La solution telle que vous l’écririez : des nombres, ou des noms comme L1. Les longueurs en nombres reçoivent un nom d’elles-mêmes.
author-start-scm-hint = Une ligne par articulation : translations X Y Z et rotations A B C jusqu’à la suivante ; la variable figure dans sa cellule, q1, q2, …
author-start-urdf-hint = Un fichier avec une seule chaîne série. Seules les articulations sont lues, pas les maillages ; le tableau s’arrête à la dernière articulation mobile, sans l’outil qui la suit.
author-robot = Robot
author-begin = Commencer avec ce robot
author-started = L’exercice est prêt à être écrit.
author-urdf-file = Fichier URDF
author-scm-final = Transformation finale
author-axes = Axes des articulations
author-axis = { $number } · { $joint }
author-axis-add = Ajouter un axe
author-axis-added = Axe { $number } ajouté.
author-axis-remove = Supprimer l’axe { $number }
author-axis-removed = Axe { $number } supprimé.
author-axis-joint = Type de l’articulation { $number }
author-placed = Axe { $number } placé.
author-how = Comment
author-point = Un point de l’axe
author-point-at = aux coordonnées
author-point-on = sur un autre axe
author-point-from = décalé par rapport à un autre axe
author-point-axis = Axe
author-point-distance = Distance le long de l’axe
author-direction = Sa direction
author-direction-vector = vecteur au choix
author-direction-through = par un autre point
author-along = selon { $axis }
author-parallel = parallèle à l’axe { $axis }
author-opposite = opposée à l’axe { $axis }
author-perpendicular = perpendiculaire à l’axe { $axis }, vers…
author-across = perpendiculaire aux axes { $axis } et { $other }
author-lengths-named = Longueurs nommées
author-lengths-named-hint = Écrivez dans un champ ci-dessus un nom comme L1 ou a2, ou une somme comme L1 + L2, et donnez ici sa valeur.
author-lengths-none = Aucune longueur n’a encore de nom.
author-scene = Les axes dans l’espace
author-scene-hint = Cliquez sur un point de la grille ou d’un autre axe pour y mettre l’axe choisi, sur une flèche pour le tourner, sur un axe pour le choisir. Tout peut aussi se faire dans les champs ci-dessous.
author-scene-text = { $count ->
    [1] Un axe d’articulation
   *[other] { $count } axes d’articulation
}, avec les points et les directions sur lesquels on peut cliquer.
author-language = Langue du texte
author-title-of = Titre
author-statement = Énoncé
author-statement-hint = Markdown : paragraphes, listes, *emphase*, **gras**, `code`. *L1* est composé comme variable. Inutile de dire ce qui est demandé ou libre : le service l’ajoute dans la langue du lecteur.
author-statement-preview = Comme les étudiants le lisent
author-statement-none = Rien n’est écrit dans cette langue : ses lecteurs en voient une autre, et on le leur dit.
author-statement-waiting = Un instant…
author-points = points
author-points-of = Points pour { $part }
author-points-total =
    En tout : { $points ->
        [one] { $points } point
       *[other] { $points } points
    }.
author-rule-convention = Convention
author-rule-convention-any = l’une ou l’autre
author-rule-convention-standard = standard
author-rule-convention-modified = modifiée
author-rule-base = Repère 0
author-rule-base-free = n’importe où
author-rule-base-axis = z comme dans la solution
author-rule-base-origin = origine comme dans la solution
author-rule-base-frame = exactement comme dans la solution
author-rule-tool = Dernier repère
author-rule-tool-free = n’importe où
author-rule-tool-point = origine au point marqué
author-rule-tool-axis = z sur le dernier axe
author-rule-tool-frame = exactement comme dans la solution
author-rule-zero = Zéro des variables
author-rule-zero-free = libre
author-rule-zero-figure = comme sur la figure
author-rule-direction = Sens positif
author-rule-direction-free = libre
author-rule-direction-figure = comme sur la figure
author-tolerance-length = Tolérance, en fraction de la taille du robot
author-tolerance-angle = Tolérance des angles, rad
author-policy-admits = Des { $choices } façons dont les manuels écriraient le tableau de ce robot, { $admitted ->
    [1] une est acceptée
   *[other] { $admitted } sont acceptées
}. Les repères entre les articulations sont libres dans tous les cas.
author-values-hint = Chaque étudiant a ses propres valeurs là où un intervalle est donné ; ailleurs, c’est la valeur usuelle.
author-values-none = Le tableau n’a pas de cotes nommées.
author-value = Valeur usuelle
author-drawn = tirée au sort pour chaque étudiant
author-draw-from = { $name } de
author-draw-to = { $name } à
author-draw-step = { $name } par pas de
author-draw-from-short = de
author-draw-to-short = à
author-draw-step-short = pas
author-aliases = Autres noms
author-help-most = Ce qu’on dit au plus aux étudiants d’un tableau faux
author-help-ladder = peu au début, davantage à chaque essai
author-attempts = Essais
author-access = Ce que les étudiants peuvent utiliser pendant qu’ils travaillent
author-access-hint = Aux étudiants venus par un lien de cours, le service refuse lui-même ce qui est désactivé.
author-access-catalogue = le catalogue de robots
author-access-playground = l’atelier
author-access-matrices = les matrices d’un tableau
author-access-trainer = l’entraînement aux repères
author-view-azimuth = Vue : rotation autour de la verticale
author-view-elevation = Vue : hauteur
author-posture = Configuration sur la figure
author-marks = Points marqués
author-marks-hint = Nécessaires si les règles fixent le dernier repère en un point.
author-mark-end = marquer la dernière origine comme P
author-lengths = Cotes dessinées autrement
author-lengths-hint = Donnez à une petite cote une autre longueur sur la figure pour qu’elle se lise bien ; la figure dit qu’elle n’est pas à l’échelle. Vide : telle quelle.
author-saved = gardé dans ce navigateur
author-other-tab = Cette page est aussi ouverte dans un autre onglet, où le brouillon vient d’être modifié. Seul le brouillon modifié en dernier est conservé.
author-test-waiting = Modifié ; les tests tourneront dans un instant.
author-test-refused = Les tests tourneront dès que les erreurs signalées plus haut seront corrigées.
author-test-running = Tests en cours : bonnes réponses avec d’autres repères, erreurs, chaque partie…
author-test-passed = Les { $passed } vérifications ont réussi.
author-test-failed = { $failed ->
    [1] Une vérification a échoué
   *[other] { $failed } vérifications ont échoué
}, { $passed } ont réussi.
author-test-warnings = Bon à savoir :
author-try = L’essayer comme un étudiant
author-right = Montrer dix bonnes réponses différentes
author-right-shown = { $wrong ->
    [0] Les { $count } sont acceptées ; la première est votre solution.
   *[other] { $wrong } sur { $count } sont refusées.
}
author-wrong = Montrer les réponses fausses les plus courantes et leurs points
author-wrong-hint = Les plus probables d’abord : ce qu’un étudiant lirait, et ce que la réponse entière vaut encore. Ajoutez vos propres mots où vous voulez.
author-wrong-marks =
    { $points ->
        [one] { $points } point
       *[other] { $points } points
    } sur { $most }, tableau { $score } %
author-wrong-refused = refusée, ne coûte aucun essai
author-wrong-untold = Aucune correction n’est proposée ({ $name }).
author-wrong-tested = l’exercice se teste avec cette erreur
author-own-words = Vos propres mots, après les nôtres
author-id = Nom du dossier
author-download = Télécharger le dossier
author-downloaded = L’archive contient un dossier pour git et pour « framewise exercises check ».
author-publish = Publier sur ce service
author-publish-closed = Ce service n’accepte pas d’exercices depuis cette page : téléchargez le dossier et remettez-le à la personne qui gère le service.
author-published = Publié. Cette version reste telle quelle pour toujours ; toute modification en crée une autre.
author-open = Ouvrir l’exercice
author-insert = L’insérer dans le cours
author-lti-hint = Dans un lien créé par votre plateforme elle-même, donnez ceci comme paramètre personnalisé :
author-link = Copier un lien vers le brouillon
author-link-copied = L’adresse contient maintenant tout le brouillon, et elle est copiée.
author-import = Ouvrir un dossier (zip)
author-import-hint = Tel qu’il se télécharge ici, ou tel que vous l’avez dans git.
author-imported = L’exercice est ouvert.

## What a definition may say beside

author-add = Ajouter : { $name }
author-remove = Retirer { $name }
author-usual = par défaut
author-dimension-handle = Cote { $name } : faites-la glisser ou utilisez les flèches ; avec Retour arrière, le service la place lui-même
author-dimension-hint = Faites glisser le nom d’une cote là où il se lit bien.
author-dimension-moved = { $name } déplacée.
author-dimension-free = { $name } est de nouveau placée automatiquement.
author-draw-without = sans
author-part-keys = { $part } : ce qui est donné et demandé
author-part-not-beside = Pas avec « { $part } » : une partie montre la réponse de l’autre.
author-needs = Nécessaires dans toute réponse juste
author-needs-hint = Les règles doivent le garantir : fixez la base ou l’outil, sinon un choix de repères peut faire disparaître la cote.
author-rungs = Ce qui est dit au plus
author-rung = à l’essai { $number }
author-rung-more = Un échelon de plus
author-rung-less = Un échelon de moins
author-weights = Ce que coûtent les erreurs
author-weights-hint = Poids relatifs : une erreur de poids 2 coûte deux fois plus qu’une de poids 1. Si un champ est vide, le poids habituel s’applique.
author-weight-joint = articulation manquante ; de mauvais type, le double
author-weight-twist = une torsion α
author-weight-length = une longueur a
author-weight-offset = un décalage d, ou θ d’une prismatique
author-weight-rule = une règle non respectée
author-weight-sign = le signe seul, en fraction
author-weight-row = une erreur nommée dans une ligne, au plus
author-weight-table = une dans tout le tableau, au plus
author-samples = Vos propres réponses pour les tests
author-samples-hint = L’autotest les juge et signale tout verdict autre que celui que vous attendez. Essayez une réponse comme un étudiant pour la garder ici.
author-sample = Exemple
author-sample-key = la solution
author-sample-name = Ce qu’il montre
author-sample-expect = Attendu
author-sample-correct = juste
author-sample-incorrect = faux
author-sample-invalid = refusé
author-sample-feedback = Codes contenus dans le verdict
author-sample-keep = Garder cette réponse comme exemple
author-sample-kept = Gardée parmi les exemples.
author-figure-more = Tout le reste de la figure
author-figure-upright = Orientation du repère 0 dans la figure, degrés
author-figure-roll = roulis
author-figure-pitch = tangage
author-figure-yaw = lacet
author-figure-width = Largeur du papier
author-figure-points = Points nommés
author-figure-joints = Corps des articulations
author-figure-name = Nom
author-figure-at = au point
author-figure-label = numéro à l’extrémité
author-figure-scale = taille
author-figure-reach = longueur de l’axe
author-figure-links = Segments
author-figure-links-hint = Une chaîne de points par ligne : O0 O1 P
author-figure-marks = Tous les points marqués
author-figure-ground = Bâti
author-figure-normal = direction qui s’en éloigne, x y z
author-figure-gripper = Pince
author-figure-away = en s’éloignant du point
author-figure-jaws = mors côte à côte suivant x y z
author-figure-dimension = Cote
author-figure-value = longueur, si ce n’est le nom
author-figure-offset = déplacée vers, x y z
author-figure-distance = de combien
author-figure-distance-along = de combien le long
author-figure-form = Comment
author-figure-frame = dans un repère de la solution
author-figure-between = entre deux points
author-figure-by = déplacé
author-figure-joint = le long de l’axe d’une articulation
author-figure-coordinates = coordonnées
author-figure-ratio = à la fraction
author-figure-from = depuis le point
author-key-joints = Valeurs articulaires
author-key-turns = Angles tirés au sort pour chaque étudiant
author-key-slides = Translations tirées au sort pour chaque étudiant
author-key-tolerance = Tolérance
author-key-point = Point marqué
author-key-from = Distance mesurée depuis
author-key-limits = Limites articulaires
author-key-mistakes = Erreurs qui peuvent être introduites
author-key-known = Pose connue
author-key-asked = Demandé : la pose
author-key-ask = Ce qui est demandé
author-key-frame = Dans les axes de
author-key-axes = Ordre des axes
author-key-turning = Rotations autour de
author-key-asked_axes = Ordre des axes demandé
author-key-asked_turning = Demandé : rotations autour de
author-key-wrench = Force et moment exercés par l’outil
author-key-cases = Poses qui peuvent être demandées
author-key-solutions = Solutions demandées
author-key-reach = Ce qui doit être atteint
author-key-given = Donné comme
author-key-angles = Angles
author-key-middle = Angle du milieu tiré entre
author-choice-jacobian = la jacobienne
author-choice-forces = les couples et forces articulaires
author-choice-base = le repère 0
author-choice-end = le dernier repère
author-choice-reached = atteignable
author-choice-out_of_reach = hors d’atteinte
author-choice-all = toutes
author-choice-one = une
author-choice-pose = position et orientation
author-choice-position = la position seule
author-choice-matrix = matrice de rotation
author-choice-quaternion = quaternion
author-choice-axis_angle = axe et angle
author-choice-angles = trois angles
author-choice-every_triple = tous les triplets d’angles
author-choice-current = les axes du repère mobile
author-choice-fixed = les axes fixes
author-choice-axis = l’axe de l’articulation 1
author-key-one-joint = { $name } tirée à part
author-version = Version : augmentez-la quand les réponses justes ou les valeurs changent
author-variants = Jeux de valeurs pour l’ensemble des étudiants
author-key-motion = Mouvement pris en compte
author-choice-twist = vitesses linéaire et angulaire
author-choice-translation = la vitesse linéaire seule
author-key-links = Segments du bras
author-key-gravity = Accélération de la pesanteur, dans le repère 0
author-key-weights = Symboles et leurs valeurs
author-key-matrix = Matrice montrée
author-choice-mass = la matrice d’inertie M
author-choice-coriolis = une matrice C
author-choice-skew = que Ṁ − 2C est antisymétrique
author-choice-velocity = C q̇ seul
author-choice-gravity = les termes de pesanteur g
author-choice-link = d’un segment
author-choice-transform = de tout le bras
author-body = Segment { $number }
author-body-mass = masse
author-body-centre = centre de masse
author-body-moments = moments d’inertie
author-quantity-name = Nom d’une grandeur
author-quantity-value = valeur
author-quantity-draw = tirée au sort pour chaque étudiant
