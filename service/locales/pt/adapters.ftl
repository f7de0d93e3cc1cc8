# Ficheiros de estudantes, avaliadores de outros sistemas, pacotes SCORM, recibos.

error-file_too_large =
    { $file } ocupa mais de { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }; uma tabela ocupa poucos quilobytes.
error-file_missing = Não existe nenhum ficheiro nem pasta { $file }.
error-grade_path_needed = É preciso um ficheiro, uma pasta ou um arquivo zip: só com --for é que - ou nada representa a entrada padrão.
error-options_without_effect = { $options } não teria efeito { $host ->
    [yes] com --for
   *[no] sem --for
}.
error-marks_are_text = { $file } não conteria uma folha de cálculo: as classificações são escritas como texto que as folhas de cálculo leem. Dê ao ficheiro um nome com .csv.
error-file_unreadable = Não é possível ler { $file }: { $reason ->
    [empty] está vazio
    [binary] não é um ficheiro de texto
    [columns] as suas linhas não se podem dividir em colunas; guarde-o como CSV
    [UTF-16] começa como UTF-16, mas não o é até ao fim; guarde-o como UTF-8
   *[other] { $reason }
}.
error-file_unusable = Não é possível ler ou escrever { $file }: { $reason }.
error-file_type_unknown = { $file } é de um tipo que não é lido aqui. São lidos { $known }.
error-file_without_table = { $file } não contém nenhuma tabela DH. Uma tabela tem as colunas theta, d, a e alpha.
error-files_too_many = { $file } contém mais de { $limit } ficheiros.
error-rows_too_many = { $file } tem mais de { $limit } linhas. Divida-o em vários ficheiros.
error-columns_unknown = Nenhuma linha de { $file } nomeia as colunas { $known }. Escreva-as acima da tabela.
error-columns_repeated = Os títulos { $titles } de { $file } designam a mesma coluna. Escreva cada coluna uma só vez; o deslocamento de uma junta fica na sua célula: q1 + 90.
error-units_differ = Os títulos de { $file } nomeiam duas unidades para a mesma grandeza: { $units }. Escreva todos os ângulos numa só unidade, e todos os comprimentos numa só unidade.
error-columns_differ_in_length = As colunas de { $file } têm comprimentos diferentes; cada uma precisa de um valor por linha.
error-exercise_not_named = Não se diz a que exercício isto responde. Indique-o, por exemplo puma560.
error-artefact_unknown = Aqui não se avaliam artefactos do tipo { $type }; avaliam-se { $known }.
error-function_command_unknown = Este comando não é conhecido. Comandos conhecidos: { $known }.
error-function_call_invalid = O corpo de uma chamada tem `response`, `answer` e `params` (um objeto). Está errado em: { $places }.
error-callback_not_allowed = O operador deste serviço não permite enviar comentários para este endereço.
error-version_not_supported = Esta versão da API de avaliação não é suportada aqui; é suportada { $supported }.

error-api_key_unknown = Não há nenhuma chave { $id }.
error-key_file_unreadable = { $file } não é um ficheiro de chaves utilizável: { $reason }.
error-receipt_kid_unknown = { $file } não contém nenhuma chave { $id }.
error-receipt_malformed = Isto não é um comprovativo, ou não está completo. Copie-o do primeiro ao último carácter.
error-receipt_key_unknown = O comprovativo foi assinado com uma chave que este serviço não tem. Pergunte ao serviço que o emitiu.
error-receipt_altered = O comprovativo foi alterado depois de emitido.

evaluation-right = Certo
evaluation-wrong = Ainda não está certo
evaluation-readable = A resposta pode ser avaliada.
evaluation-unreadable = A resposta não pode ser avaliada tal como está; isto não conta como tentativa.

scorm-no-script = Este exercício precisa de JavaScript.
scorm-no-lms = Não foi encontrada nenhuma plataforma de aprendizagem em torno desta página. Pode praticar, mas nenhuma classificação será registada.

grade-summary = Certas: { $right }; erradas: { $wrong }; não avaliáveis: { $ungraded }.
grade-left-out = Ficheiros deixados de fora devido ao seu tipo: { $count } ({ $files }).
