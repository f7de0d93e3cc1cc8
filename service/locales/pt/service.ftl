# Recusas do serviço HTTP.

problem-title-400 = O pedido não pode ser lido
problem-title-404 = Não encontrado
problem-title-405 = Este método não está disponível aqui
problem-title-406 = Nenhum formato de resposta aceitável
problem-title-408 = O pedido demorou demasiado a chegar
problem-title-413 = O pedido é demasiado grande
problem-title-415 = Este tipo de corpo não é suportado
problem-title-422 = O pedido não pode ser executado tal como está
problem-title-500 = O serviço falhou
problem-title-503 = O serviço está ocupado

error-body_missing = O pedido não tem corpo. Envie um objeto JSON.
error-body_invalid = O corpo não pode ser lido. Envie um objeto JSON em UTF-8.
error-json_not_utf8 = O corpo não está em UTF-8, como o JSON exige.
error-json_too_deep = O documento JSON tem demasiados níveis de aninhamento.
error-json_not_finite = Linha { $line }, coluna { $column }: um número tem de ser finito. O JSON não tem NaN nem infinito.
error-json_invalid = O corpo não é JSON: linha { $line }, coluna { $column }. O analisador diz: { $reason }.
error-json_duplicate_key = A chave “{ $key }” aparece duas vezes no mesmo objeto. Mantenha só uma.
error-json_too_many_values = O corpo contém demasiado: leem-se no máximo { $limit } valores, campos, listas ou objetos.
error-json_too_many_fields = Um objeto do corpo tem { $given } campos; nenhuma chamada tem mais de { $limit }.
error-body_timed_out = O corpo não chegou em { $seconds } s. Envie-o mais depressa ou em partes mais pequenas.
error-content_encoding_unsupported = Corpos comprimidos não são lidos. Envie o corpo sem Content-Encoding.
error-charset_unsupported = O corpo é anunciado como { $charset }. O JSON é lido apenas em UTF-8.
error-media_type_unsupported =
    { $given ->
        [none] O pedido não diz o que é o seu corpo.
       *[other] O corpo é anunciado como { $given }.
    } Esta chamada lê { $offers }: indique-o no cabeçalho Content-Type.
error-not_acceptable = Esta chamada responde em { $offers }; o cabeçalho Accept exclui tudo isso.
error-body_too_large =
    O corpo tem mais de { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }, o máximo que esta chamada lê.
error-method_not_allowed = Este endereço aceita { $allowed }, mas não { $method }.
error-address_unknown = Não há nada em { $path }. O documento /api/v1/openapi.json lista todas as chamadas.
error-problem_unknown = Nenhuma recusa tem o código { $code }.
error-internal_error = O serviço falhou neste pedido. Comunique-o com o identificador { $id }.
error-busy = O servidor está ocupado. Tente de novo dentro de { $seconds } s.

error-field_missing = Falta o campo “{ $field }”.
error-field_unknown = Não existe aqui o campo “{ $field }”. Os campos são: { $allowed }.
error-target_or_position = Dê exatamente um de “target”, “targets” e “position”; com uma posição, no máximo um de “quaternion” e “axis”.
error-table_or_robot = Dê “table” ou “robot”: exatamente um dos dois.
error-number_expected = “{ $field }” tem de ser um número.
error-number_not_finite = “{ $field }” tem de ser um número finito.
error-number_too_small =
    { $bound ->
        [excluded] O número tem de ser maior do que { $limit }.
       *[included] O número tem de ser pelo menos { $limit }.
    }
error-number_too_large =
    { $bound ->
        [excluded] O número tem de ser menor do que { $limit }.
       *[included] O número tem de ser no máximo { $limit }.
    }
error-integer_expected = “{ $field }” tem de ser um número inteiro.
error-boolean_expected = “{ $field }” tem de ser true ou false.
error-string_expected = “{ $field }” tem de ser texto.
error-string_too_long =
    O texto é demasiado longo: { $limit ->
        [one] lê-se no máximo um carácter
       *[other] leem-se no máximo { $limit } caracteres
    }.
error-string_too_short =
    O texto é demasiado curto: { $limit ->
        [one] é necessário pelo menos um carácter
       *[other] são necessários pelo menos { $limit } caracteres
    }.
error-string_pattern = O texto não tem a forma esperada, { $pattern }.
error-list_expected = “{ $field }” tem de ser uma lista.
error-list_too_long =
    A lista é demasiado longa: pode ter no máximo { $limit ->
        [one] um elemento
       *[other] { $limit } elementos
    }.
error-list_too_short =
    A lista é demasiado curta: precisa de pelo menos { $limit ->
        [one] um elemento
       *[other] { $limit } elementos
    }.
error-object_expected = “{ $field }” tem de ser um objeto com campos nomeados.
error-body_not_object = O corpo tem de ser um objeto JSON com campos nomeados.
error-null_expected = “{ $field }” tem de ser null ou ser omitido.
error-value_not_allowed = O valor tem de ser um destes: { $expected }.
error-value_invalid = Este valor não pode ser usado: { $reason }.

error-joints_wrong_dimensions = Um array de variáveis de junta tem uma ou duas dimensões, não { $dimensions }: (juntas) ou (configurações, juntas).
error-batch_too_large = O lote tem { $given } configurações; calculam-se no máximo { $limit } num pedido.
error-query_missing = Os valores das juntas vieram como npy; o resto do pedido vai, como JSON, no parâmetro de consulta “request”.
error-npy_header_invalid =
    O corpo não é um ficheiro npy como numpy.save o escreve: { $rule ->
        [magic] tem de começar por \x93NUMPY, uma versão e o comprimento do cabeçalho
        [version] a versão tem de ser 1.0, 2.0 ou 3.0
        [header] o cabeçalho tem de estar completo, ter no máximo 4096 bytes e indicar descr, fortran_order e shape
       *[shape] shape tem de ser um tuplo de dimensões que um array possa ter
    }.
error-npy_length_mismatch =
    O cabeçalho npy promete { $promised ->
        [one] { $promised } byte
       *[other] { $promised } bytes
    } de dados; seguem-se { $present }.
error-npy_object_refused = O ficheiro npy contém objetos Python, que nunca são desserializados. Envie um array de números.
error-npy_type_unsupported = O ficheiro npy contém { $type }. Envie números reais, como float64 (<f8).
error-npy_one_part = Um ficheiro npy contém um só array. Indique uma parte: { $allowed }.
error-one_source = Descreva o robô de uma só maneira: { $allowed }.

error-api_key_missing = O pedido não indica nenhuma chave. Envie-a como Authorization: Bearer fwk_….
error-api_key_invalid = Esta chave não é conhecida aqui, expirou ou foi revogada.
error-api_key_scope = Esta chave serve para { $scopes }; a chamada precisa de { $needed }.
error-idempotency_key_length = Uma Idempotency-Key tem de 1 a { $limit } caracteres.
error-idempotency_key_in_use = Um pedido com esta Idempotency-Key ainda está a ser respondido. Tente de novo daqui a um segundo.
error-idempotency_key_reused = Esta Idempotency-Key já foi usada para outro pedido. Use uma chave nova para um pedido novo.
error-rate_exceeded = Foi excedido o limite de { $limit } unidades de custo por minuto. Tente de novo daqui a { $seconds } s.
error-setting_missing = Falta a definição { $name }.
problem-title-429 = Demasiados pedidos
error-quaternion_or_axis = Dê no máximo um de “quaternion” e “axis”.

language-name = Português
