# L’entraînement aux repères.

trainer-title = Entraînement aux repères
trainer-heading = Placez les repères
trainer-lead = Repère après repère, dans l’ordre où on l’enseigne : tous les axes z, les perpendiculaires communes, les origines, tous les axes x. Chaque étape est vérifiée à la fin ; on lit ensuite le tableau DH.
trainer-back = Retour à l’exercice
trainer-frames = Repères
trainer-table = Le tableau qui en découle
trainer-scene = Axes et repères
trainer-click = Cliquez sur une flèche ou un point, ou faites-le glisser, pour le choisir ; les listes font de même.
trainer-complete = Tous les repères respectent la convention : le tableau est complet.
trainer-unfinished = Une ligne apparaît dès que ses deux repères sont complets et n’enfreignent aucune règle.
trainer-status =
    { $broken ->
        [0] Aucune règle enfreinte jusqu’ici.
        [1] Une règle est enfreinte.
       *[other] { $broken } règles sont enfreintes.
    }
trainer-step = Repère { $frame } : { $state }
trainer-state-open = inachevé
trainer-state-whole = complet
trainer-state-broken = enfreint une règle
trainer-part-z = Direction de z, repère { $frame }
trainer-part-origin = Origine, repère { $frame }
trainer-part-x = Direction de x, repère { $frame }
trainer-opposite = opposé :
trainer-candidate-foot = sur l’axe { $axis }, au pied de la perpendiculaire à l’axe { $other }
trainer-candidate-intersection = où les axes { $axis } et { $other } se rencontrent
trainer-candidate-level = sur l’axe { $axis }, au niveau de l’origine du repère { $frame }
trainer-candidate-axis_point = sur l’axe { $axis }, là où l’articulation est dessinée
trainer-candidate-base = comme dans le repère de base donné
trainer-candidate-tool = comme dans le repère d’outil donné
trainer-candidate-coordinates =
    { $axis ->
        [1] le long de X des coordonnées de la figure
        [2] le long de Y des coordonnées de la figure
        [3] le long de Z des coordonnées de la figure
       *[other] l’origine des coordonnées de la figure
    }
trainer-candidate-axis = le long de l’axe { $axis }
trainer-candidate-normal = le long de la perpendiculaire aux axes { $axis } et { $other }
trainer-candidate-frame_x = le long de x du repère { $frame }
trainer-candidate-across = perpendiculaire à l’axe { $axis }

trainer-step-z = Axes z
trainer-step-normals = Perpendiculaires communes
trainer-step-origin = Origines
trainer-step-x = Axes x
trainer-step-read = Lecture
trainer-task-z = Choisissez pour chaque repère la direction de z. Elle suit l’axe d’une articulation ; laquelle, cela dépend de la convention.
trainer-task-normals = Les perpendiculaires communes aux axes voisins sont tracées. Les origines et les axes x en découlent.
trainer-task-origin = Choisissez l’origine de chaque repère. Les perpendiculaires communes sont tracées.
trainer-task-x = Choisissez pour chaque repère la direction de x. Elle suit la perpendiculaire commune vers l’axe z suivant ou, si les axes se coupent, elle est perpendiculaire aux deux axes z.
trainer-normal-skew = Les axes { $axis } et { $other } ne sont pas coplanaires : ils ont une seule perpendiculaire commune, qui est tracée.
trainer-normal-meet = Les axes { $axis } et { $other } se coupent : x est perpendiculaire aux deux, et l’origine est au point d’intersection.
trainer-normal-parallel = Les axes { $axis } et { $other } sont parallèles ou confondus : toute perpendiculaire commune convient ; choisissez celle qui annule d.
trainer-check = Vérifier cette étape
trainer-onward = Continuer
trainer-restart = Recommencer
trainer-step-done = Cette étape est juste.
trainer-why-z =
    Chaque z est porté par l’axe de son articulation : { $convention ->
        [standard] z du repère i−1 par l’axe i, car la ligne i tourne de θ et avance de d par rapport à z du repère i−1.
       *[modified] z du repère i par l’axe i, car la ligne i se termine par θ et d par rapport à z du repère i.
    }
trainer-why-origin = Chaque origine est là où la perpendiculaire commune rencontre son axe, car a se mesure à partir de là le long de x.
trainer-why-x = Chaque x est porté par une perpendiculaire commune ou perpendiculaire aux deux axes, car a et α se mesurent le long et autour de lui.
trainer-open-choice = Rien n’est encore choisi pour le repère { $frame }.
trainer-point-missed = L’origine du repère { $frame } doit être au point marqué { $point }.
trainer-read = Appuyez sur le numéro d’une ligne : l’image montre comment ses quatre nombres mènent d’un repère au suivant.
trainer-take = Reporter le tableau dans l’exercice
