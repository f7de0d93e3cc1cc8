# Asignación de sistemas: reglas y rechazos.

rule-z_not_along_axis = z debe estar a lo largo del eje { $axis }, porque la articulación { $axis } gira alrededor de este z o se desliza a lo largo de él.
rule-origin_not_on_axis = El origen debe estar sobre el eje { $axis }, porque z de este sistema va a lo largo de él.
rule-origin_not_on_common_normal = El origen debe estar donde la normal común de los ejes { $first } y { $second } corta el eje de este sistema, porque a se mide sobre esa normal.
rule-origin_not_at_intersection = Los ejes { $first } y { $second } se cortan: el origen va en su punto de intersección, porque allí a es cero.
rule-x_not_across_z = x debe ser perpendicular a z, porque los ejes de un sistema son perpendiculares.
rule-x_not_along_common_normal = x debe estar a lo largo de la normal común de los ejes { $first } y { $second }, porque a se mide a lo largo de x y es la distancia más corta entre los ejes.
rule-x_not_across_both_axes = x debe ser perpendicular a ambos ejes { $first } y { $second }, porque α lleva uno sobre el otro girando alrededor de x.
rule-first_x_misses_axis = x del primer sistema debe cortar el eje { $axis } en ángulo recto, porque su fila solo tiene a y α, a lo largo y alrededor de x, para llegar allí.
rule-last_x_misses_axis = x del último sistema debe cortar el eje { $axis } en ángulo recto, porque su fila solo tiene a y α, a lo largo y alrededor de x, para partir de él.
rule-z_reversed = z apunta contra el sentido positivo del eje { $axis }. Está permitido; la variable articular entra entonces con signo menos.
rule-x_reversed = x apunta del eje { $second } al eje { $first }. Está permitido; la longitud del eslabón resulta entonces negativa.
rule-offset_could_vanish = Con otro origen en este eje, d{ $joint } sería cero.
rule-angle_could_vanish = Con otra dirección de x, θ{ $joint } sería cero.
rule-first_not_simplest = El sistema 0 podría colocarse de modo que se anulen más parámetros.
rule-last_not_simplest = El último sistema podría colocarse de modo que se anulen más parámetros.

error-axes_wrong_number = Una cadena tiene de 1 a { $limit } ejes; esta tiene { $count }.
error-axis_joint_unknown = La articulación de un eje es de rotación (revolute) o prismática (prismatic).
error-gripper_jaws_along_approach = Los dedos se deslizan transversalmente a la dirección de aproximación, no a lo largo de ella.
error-vector_malformed = Dé tres números finitos x, y, z, ninguno mayor que { $limit }.
error-direction_zero = Una dirección necesita longitud: 0, 0, 0 no apunta a ninguna parte.
error-frames_too_many = Una cadena de { $count ->
    [one] una articulación
   *[other] { $count } articulaciones
} tiene los sistemas 0 a { $count }.
error-frame_y_not_z_cross_x = y se deduce de z y x. Omítalo o dé z × x junto a ambos.
error-parallel_tolerance_out_of_range = La tolerancia para ejes paralelos está entre { $least } y { $greatest } rad.
error-near_parallel = Los ejes { $previous } y { $joint } son paralelos salvo { $angle } rad y se tomaron como paralelos. Por eso el último sistema puede quedar girado hasta el doble de ese ángulo y desplazado hasta { $displacement }.
error-near_parallel_dummy_row = Los ejes { $previous } y { $joint } son paralelos salvo { $angle } rad; una fila fija entre ellos mantiene exacta la tabla.
error-base_not_frame_zero_standard = El sistema 0 de una tabla estándar tiene z a lo largo del eje 1 y el origen sobre él; el sistema dado no, así que solo se llega a él por la transformación de base.
error-base_not_frame_zero_modified = El sistema 0 de una tabla modificada tiene un eje x que corta el eje 1 en ángulo recto; el sistema dado no, así que solo se llega a él por la transformación de base.
error-tool_not_last_frame_standard = El último sistema de una tabla estándar tiene un eje x que corta el último eje en ángulo recto; la herramienta dada no, así que solo se llega a ella por la transformación de herramienta.
error-tool_not_last_frame_modified = El último sistema de una tabla modificada tiene z a lo largo del último eje y el origen sobre él; la herramienta dada no, así que solo se llega a ella por la transformación de herramienta.
