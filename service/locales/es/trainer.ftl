# El entrenador de sistemas de referencia.

trainer-title = Práctica de sistemas de referencia
trainer-heading = Asigne los sistemas de referencia
trainer-lead = Sistema a sistema, en el orden en que se enseña: todos los ejes z, las normales comunes, los orígenes, todos los ejes x. Cada paso se comprueba al final; después se lee la tabla DH.
trainer-back = Volver al ejercicio
trainer-frames = Sistemas de referencia
trainer-table = La tabla que resulta
trainer-scene = Ejes y sistemas
trainer-click = Haga clic en una flecha o un punto, o arrástrelo, para elegirlo; las listas hacen lo mismo.
trainer-complete = Todos los sistemas cumplen la convención: la tabla está completa.
trainer-unfinished = Una fila aparece en cuanto sus dos sistemas están completos y no incumplen ninguna regla.
trainer-status =
    { $broken ->
        [0] Ninguna regla incumplida hasta ahora.
        [one] Se incumple una regla.
       *[other] Se incumplen { $broken } reglas.
    }
trainer-step = Sistema { $frame }: { $state }
trainer-state-open = sin terminar
trainer-state-whole = completo
trainer-state-broken = incumple una regla
trainer-part-z = Dirección de z, sistema { $frame }
trainer-part-origin = Origen, sistema { $frame }
trainer-part-x = Dirección de x, sistema { $frame }
trainer-opposite = opuesto:
trainer-candidate-foot = sobre el eje { $axis }, al pie de la normal al eje { $other }
trainer-candidate-intersection = donde se cortan los ejes { $axis } y { $other }
trainer-candidate-level = sobre el eje { $axis }, a la altura del origen del sistema { $frame }
trainer-candidate-axis_point = sobre el eje { $axis }, donde está dibujada la articulación
trainer-candidate-base = como en el sistema de base dado
trainer-candidate-tool = como en el sistema de herramienta dado
trainer-candidate-coordinates =
    { $axis ->
        [1] a lo largo de X de las coordenadas de la figura
        [2] a lo largo de Y de las coordenadas de la figura
        [3] a lo largo de Z de las coordenadas de la figura
       *[other] el origen de las coordenadas de la figura
    }
trainer-candidate-axis = a lo largo del eje { $axis }
trainer-candidate-normal = a lo largo de la normal de los ejes { $axis } y { $other }
trainer-candidate-frame_x = a lo largo de x del sistema { $frame }
trainer-candidate-across = perpendicular al eje { $axis }

trainer-step-z = Ejes z
trainer-step-normals = Normales comunes
trainer-step-origin = Orígenes
trainer-step-x = Ejes x
trainer-step-read = Lectura
trainer-task-z = Elija para cada sistema la dirección de z. Está sobre el eje de una articulación; cuál, depende de la convención.
trainer-task-normals = Las normales comunes de los ejes vecinos están dibujadas. De ellas se deducen los orígenes y los ejes x.
trainer-task-origin = Elija el origen de cada sistema. Las normales comunes están dibujadas.
trainer-task-x = Elija para cada sistema la dirección de x. Sigue la normal común hacia el siguiente eje z o, donde se cortan, es perpendicular a los dos ejes z.
trainer-normal-skew = Los ejes { $axis } y { $other } se cruzan: tienen una sola normal común, que está dibujada.
trainer-normal-meet = Los ejes { $axis } y { $other } se cortan: x es perpendicular a ambos y el origen está en el punto de corte.
trainer-normal-parallel = Los ejes { $axis } y { $other } son paralelos o coinciden: sirve cualquier normal común; elija la que anula d.
trainer-check = Comprobar este paso
trainer-onward = Continuar
trainer-restart = Empezar de nuevo
trainer-step-done = Este paso es correcto.
trainer-why-z =
    Cada z está a lo largo del eje de la articulación que le corresponde: { $convention ->
        [standard] z del sistema i−1 a lo largo del eje i, porque la fila i gira θ y avanza d respecto a z del sistema i−1.
       *[modified] z del sistema i a lo largo del eje i, porque la fila i termina con θ y d respecto a z del sistema i.
    }
trainer-why-origin = Cada origen está donde la normal común corta su eje, porque desde allí se mide a a lo largo de x.
trainer-why-x = Cada x va por una normal común o es perpendicular a ambos ejes, porque a y α se miden a lo largo y alrededor de él.
trainer-open-choice = Aún no se ha elegido nada para el sistema { $frame }.
trainer-point-missed = El origen del sistema { $frame } debe estar en el punto marcado { $point }.
trainer-read = Pulse el número de una fila: la imagen muestra cómo sus cuatro números llevan un sistema al siguiente.
trainer-take = Llevar la tabla al ejercicio
