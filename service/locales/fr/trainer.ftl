# L’entraînement aux repères.

trainer-title = Entraînement aux repères
trainer-heading = Placez les repères
trainer-lead = Pour chaque repère, choisissez la direction de z, l’origine et la direction de x. Chaque règle est vérifiée au fur et à mesure, et le tableau DH découle de vos repères.
trainer-back = Retour à l’exercice
trainer-frames = Repères
trainer-table = Le tableau qui en découle
trainer-scene = Axes et repères
trainer-click = Cliquez un point ou une flèche pour choisir ; les listes font de même.
trainer-clear = Effacer ce repère
trainer-next = Repère suivant
trainer-complete = Tous les repères respectent la convention : le tableau est complet.
trainer-unfinished = Une ligne apparaît dès que ses deux repères sont complets et n’enfreignent aucune règle.
trainer-status =
    { $broken ->
        [0] Aucune règle enfreinte jusqu’ici.
        [one] Une règle est enfreinte.
       *[other] { $broken } règles sont enfreintes.
    }
trainer-open = Ouvrir le tableau dans l’atelier
trainer-step = Repère { $frame } : { $state }
trainer-state-open = inachevé
trainer-state-whole = complet
trainer-state-broken = enfreint une règle
trainer-part-z = Direction de z, repère { $frame }
trainer-part-origin = Origine, repère { $frame }
trainer-part-x = Direction de x, repère { $frame }
trainer-opposite = opposé :
trainer-candidate-foot = sur l’axe { $axis }, au pied de la normale à l’axe { $other }
trainer-candidate-intersection = où les axes { $axis } et { $other } se rencontrent
trainer-candidate-level = sur l’axe { $axis }, au niveau de l’origine du repère { $frame }
trainer-candidate-axis_point = sur l’axe { $axis }, là où l’articulation est dessinée
trainer-candidate-base = comme dans le repère de base donné
trainer-candidate-tool = comme dans le repère d’outil donné
trainer-candidate-coordinates =
    { $axis ->
        [1] le long de x des coordonnées
        [2] le long de y des coordonnées
        [3] le long de z des coordonnées
       *[other] l’origine des coordonnées
    }
trainer-candidate-axis = le long de l’axe { $axis }
trainer-candidate-normal = le long de la normale aux axes { $axis } et { $other }
trainer-candidate-frame_x = le long de x du repère { $frame }
trainer-candidate-across = perpendiculaire à l’axe { $axis }
