# Cómo las fuerzas mueven un robot.

error-links_count = La lista de eslabones tiene una entrada por cada fila de la tabla: { $expected }, no { $given }.
error-mass_negative = Una masa no puede ser negativa: { $mass } kg.
error-inertia_not_symmetric = Una matriz de inercia es simétrica: el elemento xy es igual al yx.
error-inertia_negative = Un momento de inercia respecto de un eje nunca es negativo. Esta matriz tiene uno negativo respecto de algún eje.
error-dynamics_without_joints = Nada se mueve: las ecuaciones de movimiento necesitan una fila de rotación o prismática.
error-mass_matrix_singular = Alguna articulación no mueve nada que tenga masa, así que ninguna fuerza determina su aceleración. Dé masa e inercia a los eslabones.
error-links_missing = Indique la masa de los eslabones: links, una entrada por cada fila de la tabla.
error-name_of_rate = { $name } es el nombre de la velocidad de una articulación en las formas cerradas. Llame al parámetro de otro modo.
error-body_varies = La masa de un eslabón y su lugar en él no cambian con las variables articulares: estas solo figuran en la tabla.
error-dynamics_not_finite = Las masas, longitudes o velocidades son tan grandes que el resultado no es un número.

task-equations-of-motion =
    Se dan la tabla del robot y el cuerpo que se mueve con cada sistema i. Escriba los términos de M q̈ + C q̇ + g = τ que se piden, como funciones de q1, q2, …, sus velocidades dq1, dq2, … y los símbolos dados; longitudes en { unit-word }, por radián. { $skew ->
        [yes] Es correcta toda C con el C q̇ correcto; además, Ṁ − 2C debe ser antisimétrica.
       *[no] Es correcta toda C con el C q̇ correcto.
    }
given-link-weights = Los eslabones: masa, centro en el sistema i, momentos respecto de él [kg { $unit }²]
given-gravity-vector = Aceleración de la gravedad en el sistema 0 [{ $unit }/s²]
given-weights = Valores de los símbolos
field-mass = Matriz de masas M
field-coriolis = Matriz C
field-velocity = Términos de Coriolis y centrífugos C q̇
field-gravity = Términos gravitatorios g
feedback-motion_right = Estas son las ecuaciones de movimiento.
feedback-motion_mass_wrong = No todos los elementos de M son correctos.
feedback-motion_coriolis_wrong = No todas las filas de C q̇ son correctas.
feedback-motion_velocity_wrong = No todos los términos de Coriolis y centrífugos son correctos.
feedback-motion_skew_wrong = Con esta C, Ṁ − 2C no es antisimétrica. Los símbolos de Christoffel dan una con la que lo es.
feedback-motion_gravity_wrong = No todos los elementos de g son correctos.
feedback-motion_missing =
    { $what ->
        [mass] Falta la matriz de masas.
        [coriolis] Falta la matriz C.
        [skew] Sin la matriz C no hay Ṁ − 2C.
        [velocity] Faltan los términos de Coriolis y centrífugos.
       *[gravity] Faltan los términos gravitatorios.
    }
feedback-motion_asymmetric = Una matriz de masas es simétrica; esta no lo es.
feedback-motion_point_masses = Esta es la M de masas puntuales: faltan los momentos de inercia propios de los eslabones.
feedback-motion_gravity_sign = Esta g tiene el signo opuesto: g es lo que las articulaciones deben hacer contra la gravedad, el gradiente de la energía potencial.
feedback-motion_velocity_sign = Este C q̇ tiene el signo opuesto.
feedback-motion_coupling_once = Cada producto q̇j q̇k de dos articulaciones distintas aparece dos veces en C q̇, como jk y como kj; aquí cuenta una sola vez.
feedback-motion_mass_rate = Esto es Ṁ q̇. Hay que restar el gradiente de la energía cinética, ½ ∂(q̇ᵀM q̇)/∂q.
error-motion_row_count = La matriz tiene una fila por articulación: { $expected }, no { $given }.
error-motion_empty = Escriba al menos una de las matrices o filas que se piden.
error-motion_cell = Aquí va un número o una expresión; para una posición o para momentos de inercia, tres.
