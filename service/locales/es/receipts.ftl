### La página que verifica una carpeta de comprobantes.

receipts-title = Comprobantes
receipts-lead = Suelte los archivos que entregaron sus estudiantes o pegue sus textos: se verifica cada comprobante y las calificaciones pasan a un archivo para Moodle o Canvas.
receipts-files = Archivos con comprobantes
receipts-paste = O sus textos, uno tras otro
receipts-verify = Verificar
receipts-none = Todavía no hay ningún comprobante.
receipts-found =
    { $all ->
        [1]
            { $valid ->
                [0] El comprobante no es auténtico.
               *[other] El comprobante es auténtico.
            }
       *[other] Auténticos: { $valid } de { $all } comprobantes.
    }
receipts-save-csv = CSV
receipts-save-moodle = CSV para Moodle
receipts-save-canvas = CSV para Canvas
receipts-name = Nombre
receipts-exercise = Ejercicio
receipts-points = Puntos
receipts-time = Hora
receipts-settings = Ajustes
receipts-said = Resultado
receipts-genuine = auténtico
receipts-repeated = auténtico, pero otro de estos comprobantes lleva la misma respuesta
receipts-by-link = por el enlace de un docente
receipts-answer = Respuesta
receipts-sign = Firmado por { $service }. El código y el texto de abajo dicen lo mismo; { $page } los verifica.
