field-conditions = Condiciones de singularidad
field-lost = Un movimiento perdido

task-singularities =
    Se da la tabla del robot. ¿En qué configuraciones pierde el brazo un movimiento, es decir, { $motion ->
        [translation] dónde tiene la jacobiana de la velocidad del último origen un rango menor que el habitual?
       *[twist] dónde tiene la jacobiana un rango menor que el habitual?
    } Escriba una condición en cada fila: una función que se anula allí (sin(q3)) o una ecuación (q3 = 0, π). Solo cuenta el conjunto de configuraciones, sea cual sea la forma de escribirlo.{ $lost ->
        [yes] {" "}Para la configuración dada, escriba un vector λ ≠ 0 en los ejes del sistema 0 tal que λ · J q̇ = 0 hagan lo que hagan las articulaciones, en el último origen, con las longitudes en { unit-word }: el movimiento que se pierde.
       *[no] {""}
    }

feedback-singularities_right = Las condiciones se cumplen exactamente donde el brazo es singular, y no falta nada.
feedback-singularities_missing = Familias de singularidades halladas: { $found } de { $count }.
feedback-singularity_missing_at = Ninguna de sus condiciones se cumple en esta configuración singular: { $at }.
feedback-singularity_invented = La condición { $condition } se cumple también donde el brazo no es singular.
feedback-singularity_invented_at = La condición { $condition } se cumple en { $at }, donde el brazo no es singular.
feedback-singularity_rounded = La condición { $condition } se acerca a una singularidad, pero no lo suficiente: calcule con más decimales.
feedback-singularity_sine_for_cosine = La condición { $condition } es la de una singularidad salvo un cuarto de vuelta: se han confundido seno y coseno.
feedback-singularity_half = De una familia solo se ha hallado una parte: considere también la otra solución de su ecuación (q = π además de q = 0, el brazo plegado además del extendido).
feedback-singularity_everywhere = La condición { $condition } se cumple siempre.
feedback-singularity_nowhere = La condición { $condition } no se cumple nunca y no dice nada.
feedback-conditions_missing = Faltan las condiciones.
feedback-lost_motion_missing = Falta el movimiento perdido.
feedback-lost_motion_wrong = El vector no es un movimiento que se pierda aquí.
feedback-lost_motion_is_kept = Con este vector el brazo aún se mueve: λᵀJ no es cero.
feedback-lost_motion_zero = λ = 0 valdría en todas partes: dé un vector distinto de 0.
feedback-lost_motion_never = El brazo no se mueve así en ninguna configuración: el movimiento no se pierde justo aquí.
error-conditions_empty = Dé condiciones o un movimiento perdido.
error-condition_not_equation = { $text } no es una condición: escriba una función que se anula o una ecuación con un solo signo =.
error-condition_angle_nonlinear = Un ángulo articular fuera de seno, coseno y tangente solo puede estar en una ecuación como q2 + q3 = π/2.
error-conditions_too_many = Esta celda contiene más de { $limit } condiciones.
error-condition_period = Lo que se suma k veces ha de ser una vuelta dividida por un número entero: 2π, π, π/2, …
error-singularities_no_families = Ninguna condición puede decir dónde es singular este brazo: no lo es nunca, o solo en familias de menos dimensiones. Elija el otro movimiento u otro robot.
error-not_singular = El brazo no es singular en esta configuración.
