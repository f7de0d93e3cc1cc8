### Accesos desde un curso y lo que lee un estudiante con sesión iniciada.

session-launch-title = Abriendo el ejercicio
session-registration-title = Registro de una plataforma de aprendizaje
session-new-window = Abrir en una ventana nueva
session-registered = Framewise está registrado en { $issuer }. Un administrador de Framewise activa el registro; después se pueden crear enlaces.
session-registered-again = Framewise está registrado de nuevo en { $issuer }; los enlaces funcionan como antes.
session-tool-description = Ejercicios de cinemática de robots: se acepta toda elección válida de sistemas de referencia y se explican las tablas erróneas.
session-heading = Su sesión
session-signed-in = Sesión iniciada como { $name } · { $course }
session-attempts = Intentos: { $made }
session-attempts-of = Intentos: { $made } de { $allowed }
session-hand-in = Entregar
session-hand-in-ready = Entregar lo que está listo
session-counting = { $counting ->
    [first] Cuenta el primer intento
   *[last] Cuenta el último intento
}
session-penalty = Cada intento adicional cuesta un { $percent } del total de puntos
session-closes = Se cierra: { $when }
session-grade =
    Cuentan { $points } de { $total ->
        [one] { $total } punto
       *[other] { $total } puntos
    }
session-gradebook = Para el libro de calificaciones: { $percent }
session-no-more = Ahora no se admiten intentos
session-back = Volver al curso
session-received = El intento { $attempt } se ha recibido y guardado. El resultado se mostrará más adelante.
session-draft-other = Se muestra lo último que escribió. Hay otra versión de su respuesta, del { $when }.
session-draft-take = Mostrar la otra versión
session-exercise-changed = El ejercicio se ha modificado después de un intento anterior
session-attempt-then = El intento { $attempt } se hizo antes de que se modificara el ejercicio. Su resultado corresponde al ejercicio tal como era entonces.
session-exercise-then = Ver el ejercicio tal como era
session-opens = Se abre: { $when }
session-late = Cerrado: los intentos ya no cuentan
session-handed-in = entregado
session-attempts-kept = Se guardan en su curso.
session-attempts-latest = Aquí aparecen los últimos { $count }.
session-ended = Su sesión ha terminado: las respuestas que dé aquí no cuentan. Vuelva a abrir el ejercicio desde su curso; lo que escribió allí sigue allí.
session-elsewhere = Su curso pide otro ejercicio: las respuestas a este no cuentan.
session-elsewhere-go = Abrir el ejercicio del curso
session-launch-by-hand = Las plataformas de aprendizaje envían aquí a los estudiantes; por sí sola, esta dirección no muestra nada. Abra el ejercicio desde su curso.
