### A página que verifica uma pasta de recibos.

receipts-title = Comprovativos
receipts-lead = Largue os ficheiros que os estudantes entregaram ou cole os textos: cada comprovativo é verificado e as classificações passam a um ficheiro para o Moodle ou o Canvas.
receipts-files = Ficheiros com comprovativos
receipts-paste = Ou os textos, um a seguir ao outro
receipts-verify = Verificar
receipts-none = Ainda não há nenhum comprovativo.
receipts-found =
    { $all ->
        [1]
            { $valid ->
                [0] O comprovativo não é autêntico.
               *[other] O comprovativo é autêntico.
            }
       *[other] Autênticos: { $valid } de { $all } comprovativos.
    }
receipts-save-csv = CSV
receipts-save-moodle = CSV para o Moodle
receipts-save-canvas = CSV para o Canvas
receipts-name = Nome
receipts-exercise = Exercício
receipts-points = Pontos
receipts-time = Hora
receipts-settings = Definições
receipts-said = Resultado
receipts-genuine = autêntico
receipts-repeated = autêntico, mas outro destes comprovativos tem a mesma resposta
receipts-by-link = pela ligação de um docente
receipts-answer = Resposta
receipts-sign = Assinado por { $service }. O código e o texto abaixo dizem o mesmo; { $page } verifica-os.
