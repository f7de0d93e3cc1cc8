# Le formulaire web des étudiants : ce que dit chaque page.

form-skip = Aller au contenu
form-nav-label = Pages
form-nav-exercises = Exercices
form-nav-playground = Atelier
form-language = Langue
form-needs-script = Cette page a besoin de JavaScript : il dessine le robot et vérifie le tableau pendant la saisie.
form-unreachable = Le service est injoignable. Votre saisie est conservée ; réessayez dans un instant.
form-retry = Réessayer
form-cancel = Annuler
form-close = Fermer
form-named = { $name } : { $said }
form-loading = Chargement…

form-home-title = Exercices
form-home-heading = Décrivez le robot. Tout choix valable de repères est accepté.
form-home-lead = Des tableaux de Denavit–Hartenberg, un robot qui bouge pendant la saisie et un correcteur qui prouve si votre tableau décrit le même mécanisme.
form-home-exercises = Exercices
form-home-subjects = Sujets
form-home-more = Autres pages
form-home-playground = Un tableau quelconque : poses, jacobiennes, formes littérales, conversions.
form-home-api = Interface de programmation
form-home-api-text = La même chose par HTTP, sous forme de document OpenAPI.
form-home-best =
    Meilleur essai : { $points ->
        [one] { $points } point
       *[other] { $points } points
    } sur { $total }
form-home-joints =
    { $joints ->
        [1] Une articulation
       *[other] { $joints } articulations
    }
form-home-trainer = S’exercer à placer les repères

form-scene-role = vue 3D
form-scene-label = Robot
form-scene-tools = Vue
form-scene-view = Regarder
form-scene-view-corner = De trois quarts
form-scene-view-front = De face
form-scene-view-side = De côté
form-scene-view-top = De dessus
form-scene-view-now = Vue : { $view }
form-scene-turn-left = Tourner à gauche
form-scene-turn-right = Tourner à droite
form-scene-turn-up = Incliner vers le haut
form-scene-turn-down = Incliner vers le bas
form-scene-zoom-in = Agrandir
form-scene-zoom-out = Réduire
form-scene-reset = Tout montrer
form-scene-keys = Les flèches tournent la vue, Maj et flèches la déplacent, + et − agrandissent et réduisent, 0 montre tout.

form-joint = Articulation
form-joint-revolute = rotoïde
form-joint-prismatic = prismatique
form-joint-fixed = fixe
form-joint-of-row = Type d’articulation, ligne { $row }
form-joint-turn = Angle articulaire { $name }
form-joint-slide = Déplacement articulaire { $name }
form-joint-value = { $name } en { unit-word }
form-joints-reset = Remettre les articulations en place

form-convention = Convention
form-convention-standard = standard
form-convention-modified = modifiée
form-convention-now-standard = Vos entrées restent telles quelles et se lisent maintenant dans la convention standard : a et α appartiennent au segment i, l’articulation i agit selon l’axe z du repère i−1.
form-convention-now-modified = Vos entrées restent telles quelles et se lisent maintenant dans la convention modifiée : a et α appartiennent au segment i−1, l’articulation i agit selon l’axe z du repère i.
form-angle-unit = Unité des angles
form-degrees = degrés
form-radians = radians
form-length-unit = Unité des longueurs
unit-word = { $unit ->
    [in] pouces
   *[other] { $unit }
}
form-unit-now-deg = Les nombres des colonnes d’angles se lisent maintenant en degrés.
form-unit-now-rad = Les nombres des colonnes d’angles se lisent maintenant en radians.
form-unit-now-length = Les nombres des colonnes de longueurs se lisent maintenant en { unit-word }.
form-unit-doubt-deg = { $value } rad, c’est plus d’un tour. Ces angles sont-ils en degrés ?
form-unit-doubt-rad = { $value }° est un très petit angle. Ces angles sont-ils en radians ?
form-unit-read-deg = Les lire en degrés
form-unit-read-rad = Les lire en radians
form-unit-convert = Convertir les nombres
form-unit-converted = Nombres convertis.
form-unit-converted-but =
    { $count ->
        [1] Nombres convertis, sauf dans une cellule qui n’est pas une simple somme : vérifiez-la.
       *[other] Nombres convertis, sauf dans { $count } cellules qui ne sont pas de simples sommes : vérifiez-les.
    }

form-table-caption = Tableau DH, convention { $convention }
form-row-actions = Actions
form-row-add = Ajouter une ligne
form-row-added = Ligne { $row } ajoutée
form-row-remove = Supprimer la ligne { $row }
form-row-removed = Ligne { $row } supprimée
form-row-up = Monter la ligne { $row }
form-row-down = Descendre la ligne { $row }
form-row-moved = La ligne { $row } est maintenant la ligne { $to }
form-row = ligne { $row }
form-column = colonne { $name }
form-row-cell = ligne { $row }, { $name }
form-cell-label = Ligne { $row }, { $name } [{ $unit }]
form-cell-empty = Vide : écrivez 0 si c’est zéro.
form-refused = Cela n’a pas fonctionné :
form-faults =
    { $count ->
        [1] Une cellule est à revoir :
       *[other] { $count } cellules sont à revoir :
    }
form-undo = Annuler la dernière action
form-undone = Annulé
form-redo = Rétablir
form-redone = Rétabli
form-symbols = Symboles
form-symbol-insert = Insérer { $symbol }
form-keys = Flèches haut et bas : changer de ligne · Alt et flèche : déplacer la ligne · Alt+Entrée : en ajouter une · Alt+Suppr : la supprimer · Ctrl+Z : annuler.
form-paste-title = Coller un tableau
form-paste-label = Un tableau issu d’un tableur, de LaTeX, de Markdown, d’un PDF, de MATLAB ou de Python
form-paste-order = Sans en-têtes, les colonnes se lisent dans l’ordre : { $order }
form-paste-found =
    { $rows ->
        [1] Une ligne trouvée :
       *[other] { $rows } lignes trouvées :
    }
form-paste-nothing = Aucun tableau n’est reconnu dans ce texte : chaque ligne doit contenir les quatre paramètres DH.
form-paste-preview = Ce qui a été trouvé
form-paste-apply = Utiliser ce tableau
form-pasted =
    { $rows ->
        [1] Une ligne collée.
       *[other] { $rows } lignes collées.
    }

form-matrix-mode = Matrices en
form-matrix-numbers = Nombres
form-matrix-symbols = Symboles
form-matrix-notation = Notation
form-matrix-short = abrégée
form-matrix-full = complète
form-matrix-none = Les matrices apparaissent dès que chaque ligne peut être lue.
form-matrix-name = Pose du repère { $to } dans le repère { $from }
form-copy = Copier en
form-copy-group = Copier : { $what }
form-copied = Copié en { $format }
form-copy-failed = Le navigateur ne permet pas de copier

form-exercise-title = Exercice
form-exercise-task = Énoncé
form-exercise-robot = Le robot
form-exercise-description = Description textuelle
form-exercise-answer = Votre réponse
form-exercise-givens = Données
form-exercise-rules = Ce qui est libre et ce qui est fixé
form-figure-mode = Montrer le robot en
form-figure-drawing = Dessin
form-figure-space = 3D
form-figure-alt = Dessin du robot : { $title }. Une description textuelle suit.
form-figure-label = { $title } dans l’espace
form-figure-move = Bouger les articulations
form-figure-posture = Compté à partir de la configuration du dessin.
form-choose = Choisir…
form-choose-missing = Choisissez une option.
form-points =
    { $points ->
        [one] { $points } point
       *[other] { $points } points
    } sur { $total }
form-row-go = Voir la ligne { $row }
form-row-heading = Ligne
form-row-missing =
    { $after ->
        [0] avant la 1
       *[other] après la { $after }
    }
form-submit = Vérifier ma réponse
form-submitting = Vérification…
form-submit-hint = Ctrl+Entrée fait de même.
form-help = Si la réponse est fausse, me dire
form-help-verdict = seulement cela
form-help-row = quelles lignes sont fausses
form-help-kind = ce qui est faux dans chaque ligne
form-help-repair = ce qui la rendrait juste

form-part-table = Tableau DH
form-part-schematic = Structure
form-part-link-matrices = Matrices de passage
form-part-transform = Pose du dernier repère, sous forme littérale
form-part-pose = Pose du dernier repère, sous forme numérique
form-part-workspace = Espace de travail
form-part-orientation = Orientation
form-part-rotation-check = Rotation ou non
form-part-frame-chain = Chaîne de repères
form-part-inverse-kinematics = Modèle géométrique inverse
form-part-find-mistake = Trouver l’erreur
form-part-matrix-mistake = Trouver l’erreur dans une matrice
form-part-frame-mistake = Trouver l’erreur dans une figure
form-part-compare-tables = Deux tableaux
form-part-screws = Produit d’exponentielles
form-part-jacobian = Jacobienne et statique
form-part-jacobian-form = Jacobienne sous forme littérale
form-part-singularities = Singularités
form-part-equations-of-motion = Équations du mouvement
form-part-wrong = À revoir :
form-radius-inner = Rayon intérieur
form-radius-outer = Rayon extérieur
form-matrix-cell = { $name }, ligne { $row }, colonne { $column }
form-schematic-joint = Articulation { $joint }
form-schematic-relation = Axe { $joint } par rapport à l’axe { $next }
form-relation-coincident = confondus
form-relation-parallel = parallèles
form-relation-intersecting-perpendicular = concourants, perpendiculaires
form-relation-intersecting-oblique = concourants, obliques
form-relation-skew-perpendicular = non coplanaires, orthogonaux
form-relation-skew-oblique = non coplanaires, obliques

form-own-heading = Votre robot
form-own-scene = Votre robot, tel que le décrit votre tableau
form-own-empty = Votre robot grandit ici avec chaque ligne lisible.
form-own-missing =
    { $count ->
        [1] Une cellule est encore vide.
       *[other] { $count } cellules sont encore vides.
    }
form-own-unread =
    { $count ->
        [1] Une cellule est encore illisible.
       *[other] { $count } cellules sont encore illisibles.
    }
form-own-last = L’image montre le dernier tableau lisible.
form-own-values = Pour dessiner votre robot, donnez une valeur à : { $names }.
form-own-shown =
    { $joints ->
        [1] Dessiné d’après votre tableau : une articulation.
       *[other] Dessiné d’après votre tableau : { $joints } articulations.
    }
form-own-description = Les repères de votre tableau avec leurs axes x, y et z.{ $count ->
    [0] {""}
   *[other] {" "}Articulations : { $joints }.
}
form-own-parameters = Valeurs pour le dessin
form-joints = Articulations
form-matrices = Matrices

form-verdict-heading = Verdict
form-verdict-correct = Votre tableau décrit ce robot.
form-verdict-wrong = Votre tableau n’est pas encore juste.
form-verdict-all = Tout ce que vous avez rendu est juste.
form-verdict-some = Tout n’est pas encore juste.
form-verdict-outdated = Vous avez modifié votre réponse depuis.
form-basis-proved = Prouvé : l’identité vaut pour toutes les valeurs articulaires.
form-basis-verified = Vérifié sur de nombreuses configurations.
form-links-caption = Ce qui est juste dans chaque ligne
form-fact-twist = Torsion α
form-fact-length = Longueur a
form-fact-offset = Décalage
form-fact-joint = Type d’articulation
form-finding-ok = juste
form-finding-wrong = faux
form-finding-doubtful = peut-être faux
form-finding-missing = manquant
form-finding-unknown = indécis
form-finding-hidden = –
form-repairs = Ce qui le rendrait juste
form-repair-or = ou
form-both-label = Le robot de l’exercice et le vôtre, en mouvement commun
form-both-text = Les deux robots bougent ensemble : le vôtre avec vos repères, celui de l’exercice en gris et orange.
form-both-description = Vos repères sont posés sur le robot de l’exercice ; tous deux suivent le même mouvement.
form-both-position = Instant du mouvement
form-play = Lancer
form-pause = Pause

form-history-heading = Vos essais
form-history-restore = Reprendre dans le formulaire
form-history-restored = L’essai est de nouveau dans le formulaire
form-history-kept = Conservés dans ce navigateur seulement.
form-history-clear = Effacer l’historique

form-missing-title = Introuvable
form-missing-text = Cette page n’existe pas. Tous les exercices sont sur la première page.
form-missing-home = Aller aux exercices
form-storage-blocked = Le navigateur ne conserve rien ici : votre saisie est perdue si vous fermez ou rechargez cette page.
form-other-tab = Cet exercice est aussi ouvert dans un autre onglet, où l’on vient de saisir quelque chose. C’est la dernière saisie qui reste.
form-other-tab-take = Montrer cette saisie

form-row-play = Montrer la ligne { $row } dans l’image
form-film = La ligne pas à pas
form-film-hint = Placez le curseur dans une cellule ou appuyez sur le numéro d’une ligne : on voit comment ses quatre nombres mènent du repère i−1 au repère i.
form-film-none = La ligne { $row } ne peut pas encore être montrée : complétez-la, ainsi que les précédentes.
form-film-play = Animer la ligne
form-film-back = Un pas en arrière
form-film-forward = Un pas en avant
form-film-row-before = Ligne précédente
form-film-row-after = Ligne suivante
form-film-start = Ligne { $row } : on part du repère { $frame }.
form-film-turn = Ligne { $row }, { $number } sur 4 : rotation de { $letter } = { $value } autour de { $axis }.
form-film-slide = Ligne { $row }, { $number } sur 4 : translation de { $letter } = { $value } le long de { $axis }.
form-scene-enlarge = Plein écran
form-scene-record = Enregistrer comme image
form-scene-recorded = Image enregistrée
form-own-rows =
    { $rows ->
        [1] Tracé jusqu’ici : une ligne.
       *[other] Tracé jusqu’ici : { $rows } lignes.
    }

form-matrix-text = Sous forme de texte
form-matrix-text-label = { $name } sous forme de texte : LaTeX, MATLAB, Python ou cellules d’un tableur
form-matrix-text-unread = Aucune matrice 4×4 n’est reconnue dans ce texte.
form-name-unknown =
    { $known ->
        [none] { $name } n’est pas une cote de ce robot ; aucune n’a de nom.
       *[other] { $name } n’est pas une cote de ce robot. Ses cotes : { $names }.
    }

form-nav-lesson = Première leçon
form-term = Que signifie « { $term } » ?
form-convention-what = De quoi s’agit-il ?
form-exercise-write = Attachez un repère à chaque segment et écrivez le tableau DH de ce robot.

form-why = Pourquoi chaque ligne est juste
form-why-row = Ligne { $row } : position des axes z{ $before } et z{ $row } : { $relation } ; donc α = { $alpha } et a = { $a } ; le long de z, les repères sont distants de d = { $d }.
form-second-table = Un deuxième tableau valide
form-second-other-convention = Il est écrit dans la convention { $convention }.
form-second-axis-reversed = Un axe z est de sens opposé, ou une variable articulaire est comptée en sens opposé.
form-second-x-turned = Un axe x est orienté autrement ; la variable de son articulation est donc nulle ailleurs.
form-second-origin-moved = Une origine est placée ailleurs sur son axe.
form-second-none = Les règles de cet exercice ne laissent aucun autre tableau.

form-ghost-label = Votre robot, en transparence sur celui de l’exercice
form-ghost-text = Le robot de l’exercice est en gris et orange, le vôtre en rouge transparent. Les deux font le même mouvement. Le repère marqué { $row }, celui de la ligne { $row }, est le premier qui s’écarte du robot de l’exercice.
form-ghost-description = Votre robot coïncide avec celui de l’exercice avant le repère { $row }, qui est marqué : là, ils se séparent.
form-ghost-later = Tant de réponses sont vérifiées en ce moment que l’image de l’endroit où votre robot s’écarte de celui de l’exercice n’a pas encore été dessinée.
form-ghost-draw = La dessiner maintenant
form-ghost-none = Votre robot ne peut pas être dessiné sur celui de l’exercice.
form-new = Nouveau
form-new-done = Un nouveau tableau, vide.

form-progress = Progression
form-progress-open = à faire
form-progress-typed = pas encore vérifié
form-part-missing = non rendu
form-part-empty = Rien n’a encore été saisi ici.
form-submit-part = Vérifier cette partie
form-points-for = Un tableau faux gagne des points pour les torsions, longueurs et décalages justes qu’un tableau de zéros n’aurait pas. Une articulation manquante ou du mauvais type coûte le plus, un signe faux le moins.
form-help-steps = une indication à la fois
form-help-principle = Le principe.
form-help-worked = Une étape traitée, sur un autre robot.
form-help-next = Pour obtenir l’indication suivante, modifiez votre réponse et vérifiez-la de nouveau.
form-principle-twist = La torsion α amène un axe z sur le suivant, vue le long de l’axe x, perpendiculaire aux deux. Entre deux axes z parallèles, elle vaut 0° ou 180° ; entre deux axes perpendiculaires, 90° ou −90° ; la main droite, le pouce selon x, donne le signe.
form-principle-length = La longueur a est la distance entre deux axes z voisins le long de leur perpendiculaire commune, qui est l’axe x. Elle vaut 0 si et seulement si les deux droites se coupent.
form-principle-offset = Le décalage d est la distance, le long d’un axe z, entre deux pieds : là où arrive la perpendiculaire commune depuis l’axe précédent, et là où part celle vers l’axe suivant. Si des axes voisins sont parallèles, vous choisissez où passe la perpendiculaire, mais une seule fois.
form-principle-joint = Une articulation rotoïde tourne autour de son axe z : sa variable est θ. Une articulation prismatique glisse le long de son axe : sa variable est d. Chaque articulation a une ligne, de la base à l’outil.
form-worked-twist = Une épaule dont le premier axe est vertical et le deuxième horizontal : les deux axes z sont perpendiculaires. Avec x vers vous, la main droite amène le z vertical sur l’horizontal par −90° ou 90°, selon le sens donné à z ; donc α = −90° ou 90°, jamais 0.
form-worked-length = Deux segments dans un plan, longs de 0,4 m et 0,3 m : les deux axes sont verticaux, à 0,4 m l’un de l’autre. Leur perpendiculaire commune est le premier segment, donc a = 0,4 m. Dans un poignet dont les axes se coupent en un point, chaque a vaut 0.
form-worked-offset = Une épaule se trouve à 0,2 m à côté du premier axe, vertical, et le deuxième axe est horizontal. Le long du deuxième axe, il y a 0,2 m entre le pied de la perpendiculaire venant du premier et celui de la perpendiculaire vers le troisième : d = 0,2 m, dans la ligne de la deuxième articulation.
form-worked-joint = Un portique déplace son chariot le long d’un rail et fait tourner la pince suspendue au-dessous. Le rail est une articulation prismatique : sa ligne a la variable en d et un nombre en θ. La pince est une articulation rotoïde : sa ligne a la variable en θ et un nombre en d.
form-home-author = Créer un exercice
form-home-author-text = Pour les enseignants : faites du bras de votre propre livre un exercice, en un quart d’heure.

form-matrices-withheld = Les matrices apparaissent ici dès que les parties qui les demandent sont justes.
form-sharing = Pour les enseignants : liens et paquets
form-sharing-text = Un lien porte ces réglages sous forme signée : les étudiants qui le suivent ne peuvent pas les changer, et le service les fait respecter lui-même. Un paquet SCORM s’ajoute à un cours sans l’aide d’un administrateur ; sa note vient du navigateur de l’étudiant, mais le reçu dans ses commentaires ne peut pas être falsifié.
form-sharing-may = Les étudiants peuvent utiliser
form-sharing-catalogue = le catalogue de robots
form-sharing-playground = l’atelier
form-sharing-matrices = les matrices de leur propre tableau
form-sharing-trainer = l’entraînement aux repères
form-sharing-help = Ce qui leur est dit d’une réponse fausse
form-sharing-attempts = Essais
form-sharing-link = Créer un lien
form-sharing-receipts = Vérifier des reçus
form-receipt = Obtenir un reçu
form-receipt-text = Un reçu dit ce que cette réponse a rapporté ; ce service le signe. Remettez-le à votre enseignant sous forme de texte, de code QR ou de page imprimée.
form-receipt-name = Votre nom, tel que le cours le connaît
form-receipt-as-text = Reçu sous forme de texte
form-receipt-copy = Copier le texte
form-receipt-qr = Reçu sous forme de code QR
form-receipt-pdf = Page à imprimer (PDF)

form-part-frames = Repères
form-frames-hint = Longueurs en { unit-word }. Une direction peut avoir n’importe quelle longueur.
form-frames-scene = Le robot avec vos repères
form-frames-drawn = Repères dessinés : { $drawn } sur { $all }.
form-frames-frame = Repère { $frame }
form-frames-z = z pointe
form-frames-origin = Origine
form-frames-x = x pointe
form-frames-z-of = z du repère { $frame }
form-frames-origin-of = origine du repère { $frame }
form-frames-x-of = x du repère { $frame }
form-frames-ends = la place du premier et du dernier repère
form-frames-typed = saisi…
form-frames-at-joint = au corps de l’articulation { $joint }
form-frames-at-point = en { $name }
form-frames-at-ground = là où le robot est fixé
form-frames-along = le long de l’axe de l’articulation { $joint }
form-frames-against = à l’opposé de l’axe de l’articulation { $joint }
form-answer-empty = Rien n’a été rendu. L’exercice demande : { $parts }.
