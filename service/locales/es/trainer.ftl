# El entrenador de sistemas de referencia.

trainer-title = Entrenador de sistemas
trainer-heading = Asigne los sistemas de referencia
trainer-lead = Para cada sistema elija la dirección de z, el origen y la dirección de x. Cada regla se comprueba sobre la marcha, y la tabla DH se deduce de sus sistemas.
trainer-back = Volver al ejercicio
trainer-frames = Sistemas de referencia
trainer-table = La tabla que resulta
trainer-scene = Ejes y sistemas
trainer-click = Pulse un punto o una flecha para elegir; las listas hacen lo mismo.
trainer-clear = Vaciar este sistema
trainer-next = Sistema siguiente
trainer-complete = Todos los sistemas cumplen la convención: la tabla está completa.
trainer-unfinished = Una fila aparece en cuanto sus dos sistemas están completos y no incumplen ninguna regla.
trainer-status =
    { $broken ->
        [0] Ninguna regla incumplida hasta ahora.
        [one] Se incumple una regla.
       *[other] Se incumplen { $broken } reglas.
    }
trainer-open = Abrir la tabla en el taller
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
        [1] a lo largo de x de las coordenadas
        [2] a lo largo de y de las coordenadas
        [3] a lo largo de z de las coordenadas
       *[other] el origen de las coordenadas
    }
trainer-candidate-axis = a lo largo del eje { $axis }
trainer-candidate-normal = a lo largo de la normal de los ejes { $axis } y { $other }
trainer-candidate-frame_x = a lo largo de x del sistema { $frame }
trainer-candidate-across = perpendicular al eje { $axis }
