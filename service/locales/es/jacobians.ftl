task-jacobian-analytic =
    { $variables ->
        [own] Tome su propia tabla y sus propias variables articulares con estos valores.
       *[given] Se dan la tabla del robot y una configuración.
    } Escriba la jacobiana analítica: la velocidad del último origen en el sistema 0 y después las derivadas temporales de los tres ángulos en torno a los ejes { $turning ->
            [fixed] fijos
           *[current] móviles
        } { $axes }, en su orden. En números, con las longitudes en { unit-word }, por radián.

task-jacobian-form =
    { $variables ->
        [own] Tome su propia tabla y sus propias variables articulares.
       *[given] Se da la tabla del robot.
    } { $ask ->
        [jacobian] Escriba la jacobiana geométrica del último origen en forma cerrada: sus elementos son funciones de las variables articulares, por radián.
        [forces] Escriba los pares y fuerzas articulares que corresponden a la fuerza y al momento en el último origen, τ = Jᵀ(f, m), como funciones de las variables articulares.
       *[both] Escriba la jacobiana geométrica del último origen en forma cerrada, por radián, y los pares y fuerzas articulares τ = Jᵀ(f, m) que corresponden a la fuerza y al momento en el último origen.
    } { $frame ->
        [end] Todos los vectores están en los ejes del último sistema.
       *[base] Todos los vectores están en los ejes del sistema 0.
    }

task-jacobian-form-analytic =
    { $variables ->
        [own] Tome su propia tabla y sus propias variables articulares.
       *[given] Se da la tabla del robot.
    } Escriba la jacobiana analítica: la velocidad del último origen en el sistema 0 y después las derivadas temporales de los tres ángulos en torno a los ejes { $turning ->
            [fixed] fijos
           *[current] móviles
        } { $axes }, en su orden. Los elementos son funciones de las variables articulares.

feedback-jacobian_geometric = Las tres últimas filas son las de la velocidad angular; se piden las derivadas de los ángulos.
feedback-jacobian_other_point = Estas son las velocidades de otro punto; se pide la del origen del último sistema.
feedback-jacobian_reversed =
    { $count ->
        [1] La columna { $joint } tiene el signo opuesto: fíjese hacia dónde apunta z.
       *[other] Las columnas { $joints } tienen el signo opuesto: fíjese hacia dónde apunta z.
    }
feedback-jacobian_per_degree = Las columnas de las articulaciones de rotación son por grado; se piden por radián.
feedback-jacobian_other_unit = Las longitudes están en una unidad distinta de la pedida.
feedback-jacobian_angles_locked = En esta configuración, el primer y el último ángulo giran en torno a la misma recta: los ángulos no tienen derivadas y no hay jacobiana analítica.
error-angles_locked = El primero y el último de los ángulos { $axes } giran aquí en torno a la misma recta: no hay jacobiana analítica. Elija otros ángulos.
