# El formulario web de los estudiantes: lo que dice cada página.

form-skip = Ir al contenido
form-nav-label = Páginas
form-nav-exercises = Ejercicios
form-nav-playground = Taller
form-language = Idioma
form-needs-script = Esta página necesita JavaScript: con él dibuja el robot y comprueba la tabla mientras se escribe.
form-unreachable = No se puede contactar con el servicio. Lo escrito se conserva; vuelva a intentarlo en un momento.
form-retry = Reintentar
form-cancel = Cancelar
form-close = Cerrar
form-named = { $name }: { $said }
form-loading = Cargando…

form-home-title = Ejercicios
form-home-heading = Describa el robot. Vale cualquier elección correcta de sistemas de referencia.
form-home-lead = Tablas de Denavit–Hartenberg con un robot que se mueve mientras se escribe y un corrector que demuestra si la tabla describe el mismo mecanismo.
form-home-exercises = Ejercicios
form-home-subjects = Temas
form-home-more = Más
form-home-playground = Cualquier tabla: poses, jacobianas, formas cerradas, conversiones.
form-home-api = Interfaz de programación
form-home-api-text = Lo mismo por HTTP, como documento OpenAPI.
form-home-best =
    Mejor intento: { $points } de { $total ->
        [one] { $total } punto
       *[other] { $total } puntos
    }
form-home-joints =
    { $joints ->
        [one] Una articulación
       *[other] { $joints } articulaciones
    }
form-home-trainer = Practicar la asignación de sistemas

form-scene-role = vista 3D
form-scene-label = Robot
form-scene-tools = Vista
form-scene-view = Mirar
form-scene-view-corner = Desde una esquina
form-scene-view-front = De frente
form-scene-view-side = De lado
form-scene-view-top = Desde arriba
form-scene-view-now = Vista: { $view }
form-scene-turn-left = Girar a la izquierda
form-scene-turn-right = Girar a la derecha
form-scene-turn-up = Inclinar hacia arriba
form-scene-turn-down = Inclinar hacia abajo
form-scene-zoom-in = Ampliar
form-scene-zoom-out = Reducir
form-scene-reset = Mostrar todo
form-scene-keys = Las flechas giran la vista, Mayús con flechas la desplaza, + y − amplían y reducen, 0 lo muestra todo.

form-joint = Articulación
form-joint-revolute = rotación
form-joint-prismatic = prismática
form-joint-fixed = fija
form-joint-of-row = Tipo de articulación, fila { $row }
form-joint-turn = Ángulo de la articulación { $name }
form-joint-slide = Desplazamiento de la articulación { $name }
form-joint-value = { $name } en { unit-word }
form-joints-reset = Restablecer las articulaciones

form-convention = Convención
form-convention-standard = estándar
form-convention-modified = modificada
form-convention-now-standard = Sus valores quedan como están y se leen ahora en la convención estándar: a y α pertenecen al eslabón i, la articulación i se mueve según el eje z del sistema i−1.
form-convention-now-modified = Sus valores quedan como están y se leen ahora en la convención modificada: a y α pertenecen al eslabón i−1, la articulación i se mueve según el eje z del sistema i.
form-angle-unit = Unidad de los ángulos
form-degrees = grados
form-radians = radianes
form-length-unit = Unidad de las longitudes
unit-word = { $unit ->
    [in] pulgadas
   *[other] { $unit }
}
form-unit-now-deg = Los números de las columnas de ángulos se leen ahora en grados.
form-unit-now-rad = Los números de las columnas de ángulos se leen ahora en radianes.
form-unit-now-length = Los números de las columnas de longitudes se leen ahora en { unit-word }.
form-unit-doubt-deg = { $value } rad es más de una vuelta. ¿Están estos ángulos en grados?
form-unit-doubt-rad = { $value }° es un ángulo muy pequeño. ¿Están estos ángulos en radianes?
form-unit-read-deg = Leerlos en grados
form-unit-read-rad = Leerlos en radianes
form-unit-convert = Convertir los números
form-unit-converted = Números convertidos.
form-unit-converted-but =
    { $count ->
        [one] Números convertidos, salvo en una celda que no es una simple suma: revísela.
       *[other] Números convertidos, salvo en { $count } celdas que no son simples sumas: revíselas.
    }

form-table-caption = Tabla DH, convención { $convention }
form-row-actions = Acciones
form-row-add = Añadir una fila
form-row-added = Fila { $row } añadida
form-row-remove = Quitar la fila { $row }
form-row-removed = Fila { $row } quitada
form-row-up = Subir la fila { $row }
form-row-down = Bajar la fila { $row }
form-row-moved = La fila { $row } es ahora la fila { $to }
form-row = fila { $row }
form-column = columna { $name }
form-row-cell = fila { $row }, { $name }
form-cell-label = Fila { $row }, { $name } [{ $unit }]
form-cell-empty = Vacía: escriba 0 si es cero.
form-refused = No ha sido posible:
form-faults =
    { $count ->
        [one] Hay que revisar una celda:
       *[other] Hay que revisar { $count } celdas:
    }
form-undo = Deshacer
form-undone = Deshecho
form-redo = Rehacer
form-redone = Rehecho
form-symbols = Símbolos
form-symbol-insert = Insertar { $symbol }
form-keys = Flechas arriba y abajo cambian de fila · Alt con flecha mueve la fila · Alt+Intro añade una · Alt+Supr la quita · Ctrl+Z deshace.
form-paste-title = Pegar una tabla
form-paste-label = Una tabla de una hoja de cálculo, LaTeX, Markdown, PDF, MATLAB o Python
form-paste-order = Las columnas sin encabezado se leen en este orden: { $order }
form-paste-found =
    { $rows ->
        [one] Se ha encontrado una fila:
       *[other] Se han encontrado { $rows } filas:
    }
form-paste-nothing = No se reconoce ninguna tabla en este texto: cada fila necesita los cuatro parámetros DH.
form-paste-preview = Lo que se ha encontrado
form-paste-apply = Usar esta tabla
form-pasted =
    { $rows ->
        [one] Se ha pegado una fila.
       *[other] Se han pegado { $rows } filas.
    }

form-matrix-mode = Matrices como
form-matrix-numbers = Números
form-matrix-symbols = Símbolos
form-matrix-notation = Notación
form-matrix-short = abreviada
form-matrix-full = completa
form-matrix-none = Las matrices aparecen en cuanto se puedan leer todas las filas.
form-matrix-name = Pose del sistema { $to } en el sistema { $from }
form-copy = Copiar como
form-copy-group = Copiar: { $what }
form-copied = Copiado como { $format }
form-copy-failed = El navegador no permite copiar

form-exercise-title = Ejercicio
form-exercise-task = Enunciado
form-exercise-robot = El robot
form-exercise-description = Descripción con palabras
form-exercise-answer = Su respuesta
form-exercise-givens = Datos
form-exercise-rules = Qué es libre y qué está fijado
form-figure-mode = Mostrar el robot en
form-figure-drawing = Dibujo
form-figure-space = 3D
form-figure-alt = Dibujo del robot: { $title }. Sigue una descripción con palabras.
form-figure-label = { $title } en el espacio
form-figure-move = Mover las articulaciones
form-figure-posture = Medido desde la configuración del dibujo.
form-choose = Elija…
form-choose-missing = Elija una opción.
form-points =
    { $points } de { $total ->
        [one] { $total } punto
       *[other] { $total } puntos
    }
form-row-go = Ir a la fila { $row }
form-row-heading = Fila
form-row-missing =
    { $after ->
        [0] antes de la 1
       *[other] tras la { $after }
    }
form-submit = Comprobar mi respuesta
form-submitting = Comprobando…
form-submit-hint = Ctrl+Intro hace lo mismo.
form-help = Si la respuesta es errónea, dígame
form-help-verdict = solo eso
form-help-row = qué filas están mal
form-help-kind = qué está mal en cada fila
form-help-repair = qué la haría correcta

form-part-table = Tabla DH
form-part-schematic = Estructura
form-part-link-matrices = Matrices de los eslabones
form-part-transform = Pose del último sistema, en símbolos
form-part-pose = Pose del último sistema, en números
form-part-workspace = Espacio de trabajo
form-part-orientation = Orientación
form-part-rotation-check = Rotación o no
form-part-frame-chain = Cadena de sistemas
form-part-inverse-kinematics = Cinemática inversa
form-part-find-mistake = Hallar el error
form-part-matrix-mistake = Hallar el error en una matriz
form-part-frame-mistake = Hallar el error en una figura
form-part-compare-tables = Dos tablas
form-part-screws = Producto de exponenciales
form-part-jacobian = Jacobiana y estática
form-part-jacobian-form = Jacobiana en forma cerrada
form-part-singularities = Singularidades
form-part-equations-of-motion = Ecuaciones de movimiento
form-part-wrong = Por revisar:
form-radius-inner = Radio interior
form-radius-outer = Radio exterior
form-matrix-cell = { $name }, fila { $row }, columna { $column }
form-schematic-joint = Articulación { $joint }
form-schematic-relation = Eje { $joint } respecto al eje { $next }
form-relation-coincident = coincidentes
form-relation-parallel = paralelos
form-relation-intersecting-perpendicular = secantes, perpendiculares
form-relation-intersecting-oblique = secantes, oblicuos
form-relation-skew-perpendicular = cruzados, perpendiculares
form-relation-skew-oblique = cruzados, oblicuos

form-own-heading = Su robot
form-own-scene = Su robot, tal como lo describe su tabla
form-own-empty = Su robot crece aquí con cada fila que se puede leer.
form-own-missing =
    { $count ->
        [one] Aún queda una celda vacía.
       *[other] Aún quedan { $count } celdas vacías.
    }
form-own-unread =
    { $count ->
        [one] Una celda aún no se puede leer.
       *[other] { $count } celdas aún no se pueden leer.
    }
form-own-last = La imagen muestra la última tabla que se pudo leer.
form-own-values = Para dibujar su robot, dé un valor a: { $names }.
form-own-shown =
    { $joints ->
        [one] Dibujado según su tabla: una articulación.
       *[other] Dibujado según su tabla: { $joints } articulaciones.
    }
form-own-description = Los sistemas de su tabla con sus ejes x, y, z.{ $count ->
    [0] {""}
   *[other] {" "}Articulaciones: { $joints }.
}
form-own-parameters = Valores para el dibujo
form-joints = Articulaciones
form-matrices = Matrices

form-verdict-heading = Veredicto
form-verdict-correct = Su tabla describe este robot.
form-verdict-wrong = Su tabla aún no es correcta.
form-verdict-all = Todo lo que ha entregado está bien.
form-verdict-some = Aún no está todo bien.
form-verdict-outdated = Desde entonces ha cambiado su respuesta.
form-basis-proved = Demostrado: la identidad vale para todos los valores articulares.
form-basis-verified = Verificado en muchas configuraciones.
form-links-caption = Lo que está bien en cada fila
form-fact-twist = Torsión α
form-fact-length = Longitud a
form-fact-offset = Desplazamiento
form-fact-joint = Tipo de articulación
form-finding-ok = correcto
form-finding-wrong = erróneo
form-finding-doubtful = quizá erróneo
form-finding-missing = falta
form-finding-unknown = sin decidir
form-finding-hidden = –
form-repairs = Lo que la haría correcta
form-repair-or = o
form-both-label = El robot del ejercicio y el suyo, moviéndose juntos
form-both-text = Los dos robots se mueven juntos: el suyo con sus sistemas, el del ejercicio en gris y naranja.
form-both-description = Sus sistemas están colocados sobre el robot del ejercicio y ambos siguen el mismo movimiento.
form-both-position = Instante del movimiento
form-play = Iniciar
form-pause = Pausa

form-history-heading = Sus intentos
form-history-restore = Recuperar en el formulario
form-history-restored = El intento está de nuevo en el formulario
form-history-kept = Se guardan solo en este navegador.
form-history-clear = Borrar el historial

form-missing-title = No encontrado
form-missing-text = Esta página no existe. Todos los ejercicios están en la primera página.
form-missing-home = Ir a los ejercicios
form-storage-blocked = El navegador no guarda nada aquí: lo que escriba se pierde al cerrar o recargar esta página.
form-other-tab = Este ejercicio está abierto también en otra pestaña, y allí se acaba de escribir algo. Queda lo último que se escriba.
form-other-tab-take = Mostrar lo escrito allí

form-row-play = Reproducir la fila { $row } en la imagen
form-film = La fila paso a paso
form-film-hint = Sitúe el cursor en una celda o pulse el número de una fila: se muestra cómo sus cuatro números llevan el sistema i−1 al sistema i.
form-film-none = La fila { $row } aún no se puede mostrar: complétela, y también las anteriores.
form-film-play = Reproducir la fila
form-film-back = Un paso atrás
form-film-forward = Un paso adelante
form-film-row-before = Fila anterior
form-film-row-after = Fila siguiente
form-film-start = Fila { $row }: parte del sistema { $frame }.
form-film-turn = Fila { $row }, { $number } de 4: giro de { $letter } = { $value } alrededor de { $axis }.
form-film-slide = Fila { $row }, { $number } de 4: traslación de { $letter } = { $value } a lo largo de { $axis }.
form-scene-enlarge = Pantalla completa
form-scene-record = Guardar como imagen
form-scene-recorded = Imagen guardada
form-own-rows =
    { $rows ->
        [one] Dibujado hasta ahora: una fila.
       *[other] Dibujado hasta ahora: { $rows } filas.
    }

form-matrix-text = Como texto
form-matrix-text-label = { $name } como texto: LaTeX, MATLAB, Python o celdas de una hoja de cálculo
form-matrix-text-unread = No se reconoce ninguna matriz 4×4 en este texto.
form-name-unknown =
    { $known ->
        [none] { $name } no es una dimensión de este robot; ninguna tiene nombre.
       *[other] { $name } no es una dimensión de este robot. Sus dimensiones: { $names }.
    }

form-nav-lesson = Primera lección
form-term = ¿Qué significa «{ $term }»?
form-convention-what = ¿Qué son?
form-exercise-write = Fije un sistema de referencia a cada eslabón y escriba la tabla DH de este robot.

form-why = Por qué es correcta cada fila
form-why-row = Fila { $row }: posición de los ejes z{ $before } y z{ $row }: { $relation }; por eso α = { $alpha } y a = { $a }; a lo largo de z, los sistemas distan d = { $d }.
form-second-table = Otra tabla válida
form-second-other-convention = Está escrita en la convención { $convention }.
form-second-axis-reversed = Un eje z apunta en sentido contrario, o una variable articular crece en sentido contrario.
form-second-x-turned = Un eje x apunta hacia otro lado, de modo que la variable de su articulación vale cero en otra posición.
form-second-origin-moved = Un origen está en otro punto de su eje.
form-second-none = Las reglas de este ejercicio no dejan otra tabla.

form-ghost-label = Su robot, transparente, sobre el del ejercicio
form-ghost-text = El robot del ejercicio es gris y naranja; el suyo, rojo transparente. Los dos hacen el mismo movimiento. El sistema marcado { $row }, el de la fila { $row }, es el primero que se separa del robot del ejercicio.
form-ghost-description = Su robot coincide con el del ejercicio antes del sistema { $row }, que está marcado: allí se separan.
form-ghost-later = En este momento se comprueban tantas respuestas que aún no se ha dibujado dónde se separa su robot del robot del ejercicio.
form-ghost-draw = Dibujarlo ahora
form-ghost-none = Su robot no se puede dibujar sobre el del ejercicio.
form-new = Nueva
form-new-done = Una tabla nueva, vacía.

form-progress = Progreso
form-progress-open = sin responder
form-progress-typed = sin comprobar
form-part-missing = sin entregar
form-part-empty = Aquí todavía no hay nada escrito.
form-submit-part = Comprobar esta parte
form-points-for = Una tabla incorrecta recibe puntos por las torsiones, longitudes y desplazamientos correctos que una tabla de ceros no tendría. Lo que más cuesta es una articulación que falta o de tipo equivocado; lo que menos, un signo equivocado.
form-help-steps = una pista cada vez
form-help-principle = El principio.
form-help-worked = Un paso resuelto, en otro robot.
form-help-next = Para obtener la pista siguiente, cambie su respuesta y vuelva a comprobarla.
form-principle-twist = La torsión α lleva un eje z al siguiente, vista según el eje x, que es perpendicular a ambos. Entre ejes z paralelos vale 0° o 180°; entre perpendiculares, 90° o −90°; la mano derecha, con el pulgar según x, da el signo.
form-principle-length = La longitud a es la distancia entre dos ejes z vecinos medida en su normal común, que es el eje x. Vale 0 si y solo si las dos rectas se cortan.
form-principle-offset = El desplazamiento d es la distancia sobre un eje z entre dos pies: donde llega la normal común desde el eje anterior y donde sale la que va al siguiente. Si los ejes vecinos son paralelos, puede elegir dónde va la normal, pero una sola vez.
form-principle-joint = Una articulación de rotación gira en torno a su eje z: su variable es θ. Una prismática se desliza según él: su variable es d. Cada articulación tiene una fila, en el orden de la base a la herramienta.
form-worked-twist = Un hombro cuyo primer eje es vertical y cuyo segundo eje es horizontal: los dos ejes z son perpendiculares. Con x hacia usted, la mano derecha lleva el z vertical al horizontal con −90° o con 90°, según el sentido dado a z; así α = −90° o 90°, nunca 0.
form-worked-length = Dos eslabones en un plano, de 0,4 m y 0,3 m: los dos ejes son verticales y distan 0,4 m. Su normal común es el primer eslabón: a = 0,4 m. En una muñeca cuyos ejes se cortan en un punto, cada a es 0.
form-worked-offset = Un hombro está a 0,2 m al lado del primer eje, vertical, y el segundo eje es horizontal. Sobre el segundo eje hay 0,2 m entre el pie de la normal desde el primero y el de la normal al tercero: d = 0,2 m, en la fila de la segunda articulación.
form-worked-joint = Un pórtico mueve su carro por un carril y gira la pinza que cuelga de él. El carril es una articulación prismática: su fila tiene la variable en d y un número en θ. La pinza es una articulación de rotación: su fila tiene la variable en θ y un número en d.
form-home-author = Crear un ejercicio
form-home-author-text = Para docentes: convierta el brazo de su propio libro en un ejercicio, en un cuarto de hora.

form-matrices-withheld = Las matrices aparecen aquí cuando las partes que las piden estén bien.
form-sharing = Para docentes: enlaces y paquetes
form-sharing-text = Un enlace lleva estos ajustes, firmados: los estudiantes que lo siguen no pueden cambiarlos y el propio servicio los hace cumplir. Un paquete SCORM se añade a un curso sin ayuda de un administrador; su puntuación viene del navegador del estudiante, pero el comprobante de sus comentarios no se puede falsificar.
form-sharing-may = Los estudiantes pueden usar
form-sharing-catalogue = el catálogo de robots
form-sharing-playground = el taller
form-sharing-matrices = las matrices de su propia tabla
form-sharing-trainer = la práctica de sistemas de referencia
form-sharing-help = Lo que se les dice de una respuesta incorrecta
form-sharing-attempts = Intentos
form-sharing-link = Crear un enlace
form-sharing-receipts = Verificar comprobantes
form-receipt = Obtener un comprobante
form-receipt-text = Un comprobante dice lo que ha valido esta respuesta y va firmado por este servicio. Entréguelo a su docente: como texto, como código QR o como página impresa.
form-receipt-name = Su nombre, como figura en el curso
form-receipt-as-text = Comprobante como texto
form-receipt-copy = Copiar el texto
form-receipt-qr = Comprobante como código QR
form-receipt-pdf = Página para imprimir (PDF)

form-part-frames = Sistemas de referencia
form-frames-hint = Longitudes en { unit-word }. Una dirección puede tener cualquier longitud.
form-frames-scene = El robot con sus sistemas
form-frames-drawn = Sistemas dibujados: { $drawn } de { $all }.
form-frames-frame = Sistema { $frame }
form-frames-z = z apunta
form-frames-origin = Origen
form-frames-x = x apunta
form-frames-z-of = z del sistema { $frame }
form-frames-origin-of = origen del sistema { $frame }
form-frames-x-of = x del sistema { $frame }
form-frames-ends = dónde están el primer y el último sistema
form-frames-typed = escrito…
form-frames-at-joint = en el cuerpo de la articulación { $joint }
form-frames-at-point = en { $name }
form-frames-at-ground = donde está fijado el robot
form-frames-along = según el eje de la articulación { $joint }
form-frames-against = contra el eje de la articulación { $joint }
form-answer-empty = No se ha entregado nada. El ejercicio pide: { $parts }.
