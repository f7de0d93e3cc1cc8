### Cursos, intentos guardados y accesos desde un sistema de gestión del aprendizaje: qué se rechaza y por qué.

problem-title-401 = Sin sesión iniciada
problem-title-403 = Sin acceso
problem-title-409 = Ahora no es posible

## Almacenamiento

error-storage_folder = No se puede usar la carpeta de datos { $folder }: { $reason }. Indique en FRAMEWISE_DATA_FOLDER una carpeta en la que se pueda escribir, o ponga FRAMEWISE_STORAGE en off.
error-storage_address = FRAMEWISE_DATABASE_URL no designa una base de datos PostgreSQL. Tiene la forma postgresql://usuario:contraseña@servidor/base.
error-storage_unusable = No se puede usar la base de datos { $location }: { $reason }.
error-storage_unavailable = La base de datos no responde en este momento. Lo que ya se confirmó está a salvo. Vuelva a enviarlo dentro de unos segundos.
error-storage_missing = No hay ninguna base de datos en { $location }. FRAMEWISE_DATA_FOLDER o FRAMEWISE_DATABASE_URL debe indicar la del servicio.
error-schema_newer = Los datos fueron escritos por una versión más reciente del programa (esquema { $found }; esta versión conoce { $known }). Instale la versión más reciente.
error-storage_not_empty = Una copia de seguridad solo se restaura en una base de datos vacía; la relación { $table } ya contiene filas.
error-backup_unreadable = { $file } no se puede leer o escribir como copia de seguridad: { $reason }.

## Intentos

error-record_unknown = { $kind ->
    [attempt] No existe ese intento en este curso.
    [person] No existe esa persona en este curso.
    [anybody] No existe esa persona aquí.
    [several] Varios seudónimos empiezan así. Indique más caracteres; una exportación lo muestra entero.
    [link] No existe ese enlace en este curso.
    [platform] No existe esa plataforma.
    [course] No existe ese curso.
   *[other] No existe ese registro en este curso.
}
error-attempts_not_open = Se admiten intentos a partir del { TIME($opens) } UTC.
error-attempts_closed = El ejercicio se cerró el { TIME($closes) } UTC.
error-attempts_used = { $allowed ->
    [one] Ya se ha hecho el único intento que permite este ejercicio.
   *[other] Ya se han hecho los { $allowed } intentos que permite este ejercicio.
}
error-exercise_changed = El ejercicio se modificó después de que abriera esta página y no se ha entregado nada. Vuelva a cargar la página: lo que escribió sigue ahí.
error-settings_changed = Sus cambios no se han guardado: otra persona ha guardado otras reglas desde que abrió esta página. Vuelva a cargar la página y revíselas.
error-regrading_outdated = No se ha aplicado nada: el ejercicio o las reglas del enlace han cambiado desde que se calcularon estas puntuaciones, o se han aplicado otras. Vuelva a calificar.
error-scores_unsent = { $count ->
    [one] No se ha eliminado nada: el libro de calificaciones no ha recibido { $count } puntuación de este curso. Vea qué la retiene; para perderla, añada --with-unsent.
   *[other] No se ha eliminado nada: el libro de calificaciones no ha recibido { $count } puntuaciones de este curso. Vea qué las retiene; para perderlas, añada --with-unsent.
}
error-setting_invalid = { $name } puede ser: { $known }.
error-closes_before_opening = El ejercicio se cerraría antes de abrirse.
error-session_expired = Su sesión ha terminado. Lo que escribió sigue aquí: vuelva a abrir el ejercicio desde su curso.
error-administrator_unknown = Esta página se abre con una dirección que imprime framewise lti administer. La dirección funciona una sola vez, en los diez minutos siguientes; la sesión dura dos horas.
error-code_used = Esta dirección ya se ha usado. Vuelva a abrir el ejercicio desde su curso.
error-staff_only = Esto está reservado al profesorado del curso.
error-publishing_closed =
    { $who ->
        [staff] Aquí solo puede publicar ejercicios quien llega desde un curso como docente, o con una clave de ámbito publish.
        [key] Aquí solo se pueden publicar ejercicios con una clave de ámbito publish.
       *[nobody] En este servicio nadie puede publicar ejercicios.
    }
error-link_without_exercise = Todavía no se ha elegido un ejercicio para este enlace. Lo elige un docente al abrir el enlace.
error-invitation_used = Esta dirección de registro ya se ha usado o es demasiado antigua. Pida una nueva.
error-storage_off = Esta instalación no guarda cursos: su almacenamiento está desactivado.
error-posted_form_too_large =
    El formulario supera los { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-form_invalid = El cuerpo no es un formulario (application/x-www-form-urlencoded).
