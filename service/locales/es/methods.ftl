# Cinemática inversa.

error-inverse_form_unknown = Los ejes de este brazo no se suceden de un modo cuya cinemática inversa se conozca en forma simbólica: han de ser perpendiculares o paralelos, con dos o tres articulaciones que se mueven en un plano y una muñeca cuyos ejes se cortan en un punto. Numéricamente se resuelve de todos modos.
error-inverse_form_idle_joint = La articulación { $joint } no hace nada donde la solución simbólica la necesita: el punto que tendría que mover está sobre su eje, u otra articulación lo mueve del mismo modo, porque una longitud entre ejes es 0 o dos articulaciones prismáticas son paralelas. La solución numérica funciona de todos modos.
error-inverse_joint_count = La cinemática inversa admite de 1 a { $limit } articulaciones; esta tabla tiene { $count }.
error-limits_wrong_length = El brazo tiene { $expected ->
    [one] una articulación
   *[other] { $expected } articulaciones
}, pero { $given ->
    [one] se dio un límite
   *[other] se dieron { $given } límites
}; dé uno por articulación, null donde no haya.
error-limits_reversed = Dé los límites de la articulación { $joint } como su valor mínimo y su valor máximo, en este orden.
error-limits_too_far = Los límites de la articulación { $joint } están ambos a más de { $limit } rad de 0. Reste a ambos vueltas completas.
error-pose_tolerance_out_of_range = La tolerancia es un número positivo no mayor que { $limit }.
error-targets_wrong_shape = Dé varios objetivos como una lista de matrices 4×4.
error-workspace_condition_unmet = No se encontró ninguna configuración dentro de los límites que cumpla esta condición.
