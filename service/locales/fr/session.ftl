### Lancements depuis un cours, et ce que lit un étudiant connecté.

session-launch-title = Ouverture de l’exercice
session-registration-title = Enregistrement d’une plateforme d’apprentissage
session-new-window = Ouvrir dans une nouvelle fenêtre
session-registered = Framewise est enregistré auprès de { $issuer }. Un administrateur de Framewise active l’enregistrement ; des liens peuvent ensuite être créés.
session-registered-again = Framewise est de nouveau enregistré auprès de { $issuer } ; les liens fonctionnent comme avant.
session-tool-description = Exercices de cinématique des robots : tout choix valable de repères est accepté, et les tableaux faux sont expliqués.
session-heading = Votre session
session-signed-in = Connecté en tant que { $name } · { $course }
session-attempts = Essais : { $made }
session-attempts-of = Essais : { $made } sur { $allowed }
session-hand-in = Rendre
session-hand-in-ready = Rendre ce qui est prêt
session-counting = { $counting ->
    [first] Le premier essai compte
   *[last] Le dernier essai compte
}
session-penalty = Chaque essai supplémentaire coûte { $percent } du total des points
session-closes = Fermeture : { $when }
session-grade =
    Pris en compte : { $points ->
        [one] { $points } point
       *[other] { $points } points
    } sur { $total }
session-gradebook = Pour le carnet de notes : { $percent }
session-no-more = Aucun essai n’est accepté maintenant
session-back = Retour au cours
session-received = L’essai { $attempt } est reçu et conservé. Le résultat sera montré plus tard.
session-draft-other = Votre dernière saisie est affichée. Il existe une autre version de votre réponse, du { $when }.
session-draft-take = Montrer l’autre version
session-exercise-changed = L’exercice a été modifié depuis un essai précédent
session-attempt-then = L’essai { $attempt } a été fait avant la modification de l’exercice. Son résultat se rapporte à l’exercice tel qu’il était alors.
session-exercise-then = Voir l’exercice tel qu’il était
session-opens = Ouverture : { $when }
session-late = Fermé : les essais ne comptent plus
session-handed-in = rendu
session-attempts-kept = Conservés dans votre cours.
session-attempts-latest = Les { $count } derniers figurent ici.
session-ended = Vous n’êtes plus connecté : les réponses que vous donnez ici ne comptent pas. Rouvrez l’exercice depuis votre cours ; votre saisie s’y trouve toujours.
session-elsewhere = Votre cours demande un autre exercice : les réponses à celui-ci ne comptent pas.
session-elsewhere-go = Ouvrir l’exercice du cours
session-launch-by-hand = Les plateformes d’apprentissage envoient ici les étudiants ; seule, cette adresse ne montre rien. Ouvrez l’exercice depuis votre cours.
