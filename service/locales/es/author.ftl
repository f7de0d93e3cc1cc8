error-text_markup = Esto es marcado, que ningún texto de un ejercicio puede contener: { $found }. Escriba L1 < L2 con espacios.
error-text_too_long = El texto es demasiado largo; se admiten como máximo { $limit } caracteres.
error-text_control_character = El texto contiene el carácter de control { $found }, que no se ve. Bórrelo.
error-statement_not_text = El enunciado no es texto en UTF-8.
error-draft_too_large = La definición es mayor de lo que puede ser la de un robot: una tabla o lista tiene como máximo { $entries } entradas, todas juntas { $values }, y se anidan como máximo { $deepest } niveles.
error-archive_too_large =
    El archivo comprimido es demasiado grande; un ejercicio ocupa como máximo { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-archive_not_zip = Esto no es un archivo zip legible.
error-archive_too_many_files = El archivo comprimido contiene { $count } archivos; la carpeta de un ejercicio tiene como máximo { $limit }.
error-archive_entry = { $name } no forma parte de un ejercicio: una carpeta con { $known } y archivos statement.<idioma>.md, y nada más.
error-archive_method = { $name } está cifrado o comprimido de una forma que aquí no se lee. Use un zip corriente.
error-archive_file_too_large =
    { $name } es demasiado grande; un archivo de un ejercicio tiene como máximo { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-archive_no_exercise = El archivo comprimido no contiene ningún ejercicio: se espera una carpeta con { $known }.
error-source_form = Un ejercicio parte de una de estas fuentes: { $known }.
error-drawing_too_many_axes = Hay { $count } ejes; se pueden dibujar como máximo { $limit }.
error-drawing_too_many_lengths = Hay { $count } longitudes con nombre; son posibles como máximo { $limit }.
error-axis_not_before = { $before ->
    [0] Antes de este eje no hay ninguno dibujado: el eje { $axis } no puede servir de referencia.
    [one] Antes de este eje solo está dibujado el eje 1, no el eje { $axis }.
   *[other] El eje { $axis } no está entre los { $before } ejes dibujados antes de este.
}
error-length_unknown = { $name } aún no es una longitud de este dibujo. Sus longitudes: { $known }.
error-draft_too_many_rows = La tabla tiene { $count } filas; en un borrador tiene como máximo { $limit }. Una más larga puede escribirse como carpeta.
error-draft_without_table = El ejercicio no pide ninguna tabla DH, así que no hay tablas que mostrar. Añada la parte «Tabla DH».
error-publications_full = Este servicio está lleno: guarda como máximo { $limit } ejercicios publicados. Descargue en su lugar la carpeta.
author-title = Crear un ejercicio
author-lead = Convierta el brazo de su propio libro en un ejercicio: dibújelo o parta de lo que tiene. El ejercicio se comprueba mientras lo escribe.
author-card-start = El robot
author-card-texts = Título y enunciado
author-card-parts = Qué se pide
author-card-policy = Qué es libre y qué está fijado
author-card-values = Valores
author-card-help = Ayuda e intentos
author-card-figure = Figura
author-card-preview = Vista previa
author-card-trials = Pruébelo
author-card-take = Descargar y publicar
author-selftest = Autoprueba
author-start = Partir de
author-start-robot = Catálogo
author-start-axes = Dibujo
author-start-table = Tabla DH
author-start-scm = Cadena SCM
author-start-urdf = URDF
author-start-robot-hint = Un robot del catálogo, con su tabla y sus dimensiones.
author-start-axes-hint = Coloque los ejes de las articulaciones uno tras otro, desde la base, con el robot en cero. Las longitudes con nombre son las cotas de la figura; la tabla se obtiene sola.
author-start-table-hint = La solución tal como usted la escribiría: números o nombres como L1. Las longitudes numéricas reciben nombre solas.
author-start-scm-hint = Una fila por articulación: traslaciones X Y Z y giros A B C hasta la siguiente; la variable va en su celda como q1, q2, …
author-start-urdf-hint = Un archivo con una sola cadena en serie. Solo se leen las articulaciones, no las mallas; la tabla termina en la última articulación móvil, sin la herramienta que la sigue.
author-robot = Robot
author-begin = Empezar con este robot
author-started = El ejercicio está listo para escribirse.
author-urdf-file = Archivo URDF
author-scm-final = Transformación final
author-axes = Ejes de las articulaciones
author-axis = { $number } · { $joint }
author-axis-add = Añadir un eje
author-axis-added = Eje { $number } añadido.
author-axis-remove = Quitar el eje { $number }
author-axis-removed = Eje { $number } quitado.
author-axis-joint = Tipo de la articulación { $number }
author-placed = Eje { $number } colocado.
author-how = Cómo
author-point = Un punto del eje
author-point-at = en las coordenadas
author-point-on = sobre otro eje
author-point-from = desplazado respecto de otro eje
author-point-axis = Eje
author-point-distance = Distancia a lo largo
author-direction = Su dirección
author-direction-vector = vector a elegir
author-direction-through = por otro punto
author-along = según { $axis }
author-parallel = paralela al eje { $axis }
author-opposite = opuesta al eje { $axis }
author-perpendicular = perpendicular al eje { $axis }, hacia…
author-across = perpendicular a los ejes { $axis } y { $other }
author-lengths-named = Longitudes con nombre
author-lengths-named-hint = Escriba en cualquier campo de arriba un nombre como L1 o a2, también sumas como L1 + L2, y dé aquí su valor.
author-lengths-none = Ninguna longitud tiene nombre todavía.
author-scene = Los ejes en el espacio
author-scene-hint = Haga clic en un punto de la cuadrícula o de otro eje para llevar allí el eje elegido, en una flecha para girarlo, en un eje para elegirlo. Todo puede hacerse también en los campos de abajo.
author-scene-text = { $count ->
    [one] Un eje de articulación
   *[other] { $count } ejes de articulación
}, con los puntos y direcciones en que se puede hacer clic.
author-language = Idioma del texto
author-title-of = Título
author-statement = Enunciado
author-statement-hint = Markdown: párrafos, listas, *énfasis*, **negrita**, `código`. *L1* se compone como variable. Lo que se pide y lo que es libre no hace falta decirlo: el servicio lo añade en el idioma del lector.
author-statement-preview = Como lo leen los estudiantes
author-statement-none = No hay nada escrito en este idioma: a sus lectores se les muestra otro, y se les dice.
author-statement-waiting = Un momento…
author-points = puntos
author-points-of = Puntos por { $part }
author-points-total =
    En total: { $points ->
        [one] { $points } punto
       *[other] { $points } puntos
    }.
author-rule-convention = Convención
author-rule-convention-any = cualquiera
author-rule-convention-standard = estándar
author-rule-convention-modified = modificada
author-rule-base = Sistema 0
author-rule-base-free = en cualquier sitio
author-rule-base-axis = z como en la solución
author-rule-base-origin = origen como en la solución
author-rule-base-frame = exactamente como en la solución
author-rule-tool = Último sistema
author-rule-tool-free = en cualquier sitio
author-rule-tool-point = origen en el punto marcado
author-rule-tool-axis = z sobre el último eje
author-rule-tool-frame = exactamente como en la solución
author-rule-zero = Cero de las variables
author-rule-zero-free = libre
author-rule-zero-figure = como en la figura
author-rule-direction = Sentido positivo
author-rule-direction-free = libre
author-rule-direction-figure = como en la figura
author-tolerance-length = Tolerancia, como fracción del tamaño del robot
author-tolerance-angle = Tolerancia de ángulos, rad
author-policy-admits = De las { $choices } formas en que los libros escribirían la tabla de este robot, se { $admitted ->
    [one] acepta una
   *[other] aceptan { $admitted }
}. Los sistemas entre articulaciones son libres en todo caso.
author-values-hint = Cada estudiante recibe valores propios donde se da un intervalo; en los demás casos vale el habitual.
author-values-none = La tabla no tiene dimensiones con nombre.
author-value = Valor habitual
author-drawn = sorteado para cada estudiante
author-draw-from = { $name } desde
author-draw-to = { $name } hasta
author-draw-step = { $name } con paso
author-draw-from-short = desde
author-draw-to-short = hasta
author-draw-step-short = paso
author-aliases = Otros nombres
author-help-most = Lo máximo que se dice de una tabla errónea
author-help-ladder = poco al principio, más con cada intento
author-attempts = Intentos
author-access = Qué pueden usar los estudiantes mientras trabajan
author-access-hint = A los estudiantes que llegan por un enlace de un curso, el propio servicio les niega lo que está desactivado.
author-access-catalogue = el catálogo de robots
author-access-playground = el taller
author-access-matrices = las matrices de una tabla
author-access-trainer = la práctica de sistemas de referencia
author-view-azimuth = Vista: giro alrededor de la vertical
author-view-elevation = Vista: altura
author-posture = Configuración en la figura
author-marks = Puntos marcados
author-marks-hint = Hacen falta si las reglas fijan el último sistema en un punto.
author-mark-end = marcar el último origen como P
author-lengths = Cotas dibujadas de otro modo
author-lengths-hint = Dé a una cota pequeña otra longitud en la figura para que se lea bien; la figura dice que no está a escala. Vacío: tal cual.
author-saved = guardado en este navegador
author-other-tab = Esta página también está abierta en otra pestaña, y allí se acaba de modificar el borrador. Solo se conserva el borrador que se modifica en último lugar.
author-test-waiting = Cambiado; las pruebas se ejecutan en un momento.
author-test-refused = Las pruebas se ejecutan en cuanto se corrijan los errores señalados arriba.
author-test-running = Probando: respuestas correctas con otros sistemas, errores, cada parte…
author-test-passed = Se superaron las { $passed } comprobaciones.
author-test-failed = { $failed ->
    [one] Falló una comprobación
   *[other] Fallaron { $failed } comprobaciones
}; { $passed } superadas.
author-test-warnings = Conviene saber:
author-try = Probarlo como estudiante
author-right = Mostrar diez respuestas correctas distintas
author-right-shown = { $wrong ->
    [0] Se aceptan las { $count }; la primera es su solución.
   *[other] Se rechazan { $wrong } de { $count }.
}
author-wrong = Mostrar las respuestas erróneas más comunes y sus puntos
author-wrong-hint = Las más probables primero: qué se le diría a un estudiante y qué vale aún la respuesta completa. Añada sus propias palabras donde quiera.
author-wrong-marks =
    { $points } de { $most ->
        [one] { $most } punto
       *[other] { $most } puntos
    }, tabla { $score } %
author-wrong-refused = se rechaza, no cuesta ningún intento
author-wrong-untold = No se propone ninguna corrección ({ $name }).
author-wrong-tested = el ejercicio se prueba con este error
author-own-words = Sus propias palabras, tras las nuestras
author-id = Nombre de la carpeta
author-download = Descargar la carpeta
author-downloaded = El archivo zip contiene una carpeta para git y para «framewise exercises check».
author-publish = Publicar en este servicio
author-publish-closed = Este servicio no admite ejercicios desde esta página: descargue la carpeta y entréguela a quien administra el servicio.
author-published = Publicado. Esta versión queda así para siempre; todo cambio crea otra.
author-open = Abrir el ejercicio
author-insert = Insertarlo en el curso
author-lti-hint = Si es su plataforma la que crea el enlace, añada este parámetro personalizado:
author-link = Copiar un enlace al borrador
author-link-copied = La dirección contiene ahora todo el borrador y está copiada.
author-import = Abrir una carpeta (zip)
author-import-hint = Como se descarga aquí o como la tiene en git.
author-imported = El ejercicio está abierto.

## What a definition may say beside

author-add = Añadir: { $name }
author-remove = Quitar { $name }
author-usual = valor habitual
author-dimension-handle = Cota { $name }: arrástrela o use las flechas; con Retroceso la coloca el propio servicio
author-dimension-hint = Arrastre el nombre de una cota hasta donde se lea bien.
author-dimension-moved = { $name } desplazada.
author-dimension-free = { $name } se coloca de nuevo automáticamente.
author-draw-without = sin
author-part-keys = { $part }: qué se da y qué se pide
author-part-not-beside = No junto con «{ $part }»: una parte muestra la respuesta de la otra.
author-needs = Necesarias en toda respuesta correcta
author-needs-hint = Las reglas deben garantizarlo: fije la base o la herramienta; si no, una elección de sistemas puede dejar fuera la cota.
author-rungs = Lo máximo que se dice
author-rung = en el intento { $number }
author-rung-more = Un peldaño más
author-rung-less = Un peldaño menos
author-weights = Lo que cuestan los errores
author-weights-hint = Pesos relativos: un error de peso 2 cuesta el doble que uno de peso 1. Si un campo está vacío, vale el peso habitual.
author-weight-joint = articulación que falta; si es de otro tipo, el doble
author-weight-twist = una torsión α
author-weight-length = una longitud a
author-weight-offset = un desplazamiento d, o θ de una prismática
author-weight-rule = una regla que no se cumple
author-weight-sign = solo el signo, como fracción
author-weight-row = un error con nombre en una fila, como máximo
author-weight-table = uno en toda la tabla, como máximo
author-samples = Respuestas suyas para las pruebas
author-samples-hint = La autoprueba las juzga y avisa si el veredicto no es el que usted espera. Pruebe una respuesta como estudiante para guardarla aquí.
author-sample = Ejemplo
author-sample-key = la solución
author-sample-name = Qué muestra
author-sample-expect = Se espera
author-sample-correct = correcta
author-sample-incorrect = incorrecta
author-sample-invalid = rechazada
author-sample-feedback = Códigos que contiene el veredicto
author-sample-keep = Guardar esta respuesta como ejemplo
author-sample-kept = Guardada entre los ejemplos.
author-figure-more = Todo lo demás de la figura
author-figure-upright = Cómo está el sistema 0 en la figura, grados
author-figure-roll = alabeo
author-figure-pitch = cabeceo
author-figure-yaw = guiñada
author-figure-width = Anchura del papel
author-figure-points = Puntos con nombre
author-figure-joints = Cuerpos de las articulaciones
author-figure-name = Nombre
author-figure-at = en el punto
author-figure-label = número en el extremo
author-figure-scale = tamaño
author-figure-reach = longitud del eje
author-figure-links = Eslabones
author-figure-links-hint = Una cadena de puntos en cada línea: O0 O1 P
author-figure-marks = Todos los puntos marcados
author-figure-ground = Suelo
author-figure-normal = dirección que se aleja de él, x y z
author-figure-gripper = Pinza
author-figure-away = alejándose del punto
author-figure-jaws = dedos uno al lado del otro según x y z
author-figure-dimension = Cota
author-figure-value = longitud, si no es el nombre
author-figure-offset = desplazada hacia, x y z
author-figure-distance = cuánto
author-figure-distance-along = cuánto a lo largo de él
author-figure-form = Cómo
author-figure-frame = en un sistema de la solución
author-figure-between = entre dos puntos
author-figure-by = desplazado
author-figure-joint = a lo largo del eje de una articulación
author-figure-coordinates = coordenadas
author-figure-ratio = en la fracción
author-figure-from = desde el punto
author-key-joints = Valores articulares
author-key-turns = Ángulos sorteados para cada estudiante
author-key-slides = Desplazamientos sorteados para cada estudiante
author-key-tolerance = Tolerancia
author-key-point = Punto marcado
author-key-from = Distancia desde
author-key-limits = Límites articulares
author-key-mistakes = Errores que se pueden introducir
author-key-known = Pose conocida
author-key-asked = Se pide: la pose
author-key-ask = Qué se pide
author-key-frame = En los ejes de
author-key-axes = Orden de los ejes
author-key-turning = Se gira en torno a
author-key-asked_axes = Orden de los ejes que se pide
author-key-asked_turning = Se pide: giro en torno a
author-key-wrench = Fuerza y momento que ejerce la herramienta
author-key-cases = Poses que se pueden pedir
author-key-solutions = Soluciones que se piden
author-key-reach = Qué se debe alcanzar
author-key-given = Se da como
author-key-angles = Ángulos
author-key-middle = Ángulo intermedio sorteado entre
author-choice-jacobian = la jacobiana
author-choice-forces = los pares y fuerzas articulares
author-choice-base = el sistema 0
author-choice-end = el último sistema
author-choice-reached = alcanzable
author-choice-out_of_reach = fuera de alcance
author-choice-all = todas
author-choice-one = una
author-choice-pose = posición y orientación
author-choice-position = solo la posición
author-choice-matrix = matriz de rotación
author-choice-quaternion = cuaternión
author-choice-axis_angle = eje y ángulo
author-choice-angles = tres ángulos
author-choice-every_triple = todas las ternas de ángulos
author-choice-current = los ejes del sistema móvil
author-choice-fixed = ejes fijos
author-choice-axis = el eje de la articulación 1
author-key-one-joint = { $name } sorteada aparte
author-version = Versión: auméntela cuando cambien las respuestas correctas o los valores
author-variants = Juegos de valores para todos los estudiantes
author-key-motion = Movimiento que cuenta
author-choice-twist = velocidad lineal y angular
author-choice-translation = solo la velocidad lineal
author-key-links = Eslabones del brazo
author-key-gravity = Aceleración de la gravedad, en el sistema 0
author-key-weights = Símbolos y sus valores
author-key-matrix = Matriz que se muestra
author-choice-mass = la matriz de masas M
author-choice-coriolis = una matriz C
author-choice-skew = que Ṁ − 2C es antisimétrica
author-choice-velocity = solo C q̇
author-choice-gravity = el término gravitatorio g
author-choice-link = de un eslabón
author-choice-transform = de todo el brazo
author-body = Eslabón { $number }
author-body-mass = masa
author-body-centre = centro de masas
author-body-moments = momentos de inercia
author-quantity-name = Nombre de una magnitud
author-quantity-value = valor
author-quantity-draw = sorteado para cada estudiante
