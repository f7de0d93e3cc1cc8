### Lo que la autocomprobación de un ejercicio dice a su autor.

check-counts = { $exercise }: { $passed ->
    [one] { $passed } comprobación superada
   *[other] { $passed } comprobaciones superadas
}, fallidas: { $failed }, { $warnings ->
    [one] { $warnings } advertencia
   *[other] { $warnings } advertencias
}
check-structure = La semilla { $seed } cambia la estructura del robot.
check-drawn_structure = El sorteo puede dar { $name } = { $value }, lo que cambia la estructura del robot. Excluya ese valor (without) o elija otro intervalo.
check-figure = Semilla { $seed }: no se puede dibujar la figura ({ $reason }).
check-right = Se rechaza una tabla correcta: { $table }
check-certificate = El certificado de una tabla correcta no se cumple: { $table }
check-harmless = Se acepta una tabla incorrecta: { $table }
check-mistake = El error { $mistake } no se explica en { $table }
check-part = Semilla { $seed }: se rechaza una respuesta correcta a la parte { $part }.
check-follow_through = Semilla { $seed }: lo que se deduce de una tabla incorrecta no puntúa en la parte { $part }.
check-wrong_part = Semilla { $seed }: una respuesta incorrecta a la parte { $part } no se explica como { $mistake }, sino como { $told }.
check-invalid = Se califica una tabla mal formada: { $name }.
check-sample = El ejemplo «{ $name }» no se juzga como se esperaba; el veredicto es: { $told }.
check-rounded = Se rechaza una tabla correcta redondeada a { $digits } cifras con la regla de herramienta { $rule }: { $table }
check-tool_rule = Se rechaza una tabla correcta con la regla de herramienta { $rule }: { $table }
check-crash = Semilla { $seed }: falla la calificación: { $reason }
check-unneeded = Ninguna respuesta correcta necesita { $name }: el estudiante puede elegir sistemas de referencia en los que no aparece. { $rules ->
    [none] Ninguna regla lo cambia: no mencione esa cota en el enunciado.
   *[other] Si la respuesta debe contener esa cota, basta con cualquiera de estas reglas: { $rules }. Si no, no la mencione en el enunciado.
}
check-alike = Algunos estudiantes pueden intercambiar los valores de { $name } y { $other } sin que se note: difieren en un 1 % como máximo. Elija valores o intervalos más separados.
check-taken_by_slide = En la fila de la articulación { $joint }, { $name } bajo d es la variable articular, no la cota. Quien elija sistemas de referencia en los que la cota aparece allí no podrá escribirla. Dele otro nombre.
check-taken_by_short_form = Donde la respuesta es una fórmula, { $name } es un coseno o un seno, no la cota. Dele otro nombre.
check-no_joints = El robot no tiene ninguna articulación: no hay nada que describir. Ponga una en alguna fila de la tabla.
check-nothing_earned = Ninguna tabla incorrecta obtiene puntos: no tiene peso nada de lo que una tabla de ceros describe mal en este robot. Cambie los pesos o fije más reglas.
check-asked_as_shown = La parte { $kind } muestra lo que pide. Pida otra cosa o muéstrelo en otra forma.
check-gravity_not_down = En la figura, la gravedad que da la parte { $kind } no apunta hacia abajo. Gire el sistema 0 con upright o cambie gravity.
check-frames_coincide = En la figura de la parte { $kind }, dos sistemas de referencia tienen el mismo origen porque una articulación prismática entre ellos está dibujada en cero. Dele otro valor en posture.
check-limits_ambiguous = La respuesta a la parte { $kind } depende del sentido en que crece la variable de una articulación con límites, y ese sentido se elige libremente. Fije los sentidos (figure) o elija límites con los que eso no importe.
warm-counts = { $exercise }: { $values ->
    [one] { $values } juego de valores comprobado y dibujado
   *[other] { $values } juegos de valores comprobados y dibujados
}, { $figures ->
    [one] { $figures } figura
   *[other] { $figures } figuras
}, { $forms ->
    [one] { $forms } forma cerrada
   *[other] { $forms } formas cerradas
}, { $failed ->
    [one] { $failed } fallo
   *[other] { $failed } fallos
}, { $seconds } s
error-nothing_to_warm = No hay ningún ejercicio, ni ningún curso con enlaces, llamado { $name }.
error-variants_set = El número de variantes de { $name } está fijado en el ejercicio o en las reglas de los enlaces del curso. Omita --variants.
