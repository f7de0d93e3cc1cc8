error-text_markup = Isto é marcação, que nenhum texto de um exercício pode conter: { $found }. Escreva L1 < L2 com espaços.
error-text_too_long = O texto é demasiado longo; são admitidos no máximo { $limit } caracteres.
error-text_control_character = O texto contém o carácter de controlo { $found }, que não se vê. Apague-o.
error-statement_not_text = O enunciado não é texto em UTF-8.
error-draft_too_large = A definição é maior do que a de um robô pode ser: uma tabela ou lista tem no máximo { $entries } entradas, todas juntas { $values }, e no máximo { $deepest } níveis.
error-archive_too_large =
    O arquivo é demasiado grande; um exercício tem no máximo { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-archive_not_zip = Isto não é um arquivo zip legível.
error-archive_too_many_files = O arquivo contém { $count } ficheiros; a pasta de um exercício tem no máximo { $limit }.
error-archive_entry = { $name } não pertence a um exercício: uma pasta com { $known } e ficheiros statement.<língua>.md, e nada mais.
error-archive_method = { $name } está cifrado ou comprimido de uma forma que aqui não se lê. Use um zip comum.
error-archive_file_too_large =
    { $name } é demasiado grande; um ficheiro de um exercício tem no máximo { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-archive_no_exercise = O arquivo não contém nenhum exercício: espera-se uma pasta com { $known }.
error-source_form = Um exercício começa a partir de um de { $known }.
error-drawing_too_many_axes = Há { $count } eixos; podem desenhar-se no máximo { $limit }.
error-drawing_too_many_lengths = Há { $count } comprimentos com nome; são possíveis no máximo { $limit }.
error-axis_not_before =
    { $before ->
        [0] Antes deste eixo não há outro desenhado: o eixo { $axis } não pode servir de referência.
        [one] Antes deste eixo só está desenhado o eixo 1, não o eixo { $axis }.
       *[other] O eixo { $axis } não está entre os { $before } eixos desenhados antes deste.
    }
error-length_unknown = { $name } ainda não é um comprimento deste desenho. Os seus comprimentos: { $known }.
error-draft_too_many_rows = A tabela tem { $count } linhas; num rascunho tem no máximo { $limit }. Uma mais longa pode escrever-se como pasta.
error-draft_without_table = O exercício não pede nenhuma tabela DH, por isso não há tabelas para mostrar. Acrescente a parte “Tabela DH”.
error-publications_full = Já estão publicados todos os exercícios que este serviço guarda ({ $limit }). Descarregue antes a pasta.
author-title = Criar um exercício
author-lead = Faça do braço do seu próprio livro um exercício: desenhe-o ou parta do que tem. O exercício testa-se enquanto escreve.
author-card-start = O robô
author-card-texts = Título e enunciado
author-card-parts = O que se pede
author-card-policy = O que é livre e o que é fixo
author-card-values = Valores
author-card-help = Ajuda e tentativas
author-card-figure = Figura
author-card-preview = Pré-visualização
author-card-trials = Experimente
author-card-take = Descarregar e publicar
author-selftest = Autoteste
author-start = Partir de
author-start-robot = Catálogo
author-start-axes = Desenho
author-start-table = Tabela DH
author-start-scm = Cadeia SCM
author-start-urdf = URDF
author-start-robot-hint = Um robô do catálogo, com a sua tabela e dimensões.
author-start-axes-hint = Coloque os eixos das juntas um após o outro, a partir da base, com o robô em zero. Os comprimentos com nome são as cotas da figura; a tabela resulta daí.
author-start-table-hint = A solução como a escreveria: números ou nomes como L1. Os comprimentos em números recebem nome automaticamente.
author-start-scm-hint = Uma linha por junta: translações X Y Z e rotações A B C até à seguinte; a variável está na sua célula, q1, q2, …
author-start-urdf-hint = Um ficheiro com uma única cadeia em série. Só se leem as juntas, não as malhas; a tabela termina na última junta móvel, sem a ferramenta que se lhe segue.
author-robot = Robô
author-begin = Começar com este robô
author-started = O exercício está pronto a ser escrito.
author-urdf-file = Ficheiro URDF
author-scm-final = Transformação final
author-axes = Eixos das juntas
author-axis = { $number } · { $joint }
author-axis-add = Acrescentar um eixo
author-axis-added = Eixo { $number } acrescentado.
author-axis-remove = Remover o eixo { $number }
author-axis-removed = Eixo { $number } removido.
author-axis-joint = Tipo da junta { $number }
author-placed = Eixo { $number } colocado.
author-how = Como
author-point = Um ponto do eixo
author-point-at = dado por coordenadas
author-point-on = sobre outro eixo
author-point-from = deslocado de outro eixo
author-point-axis = Eixo
author-point-distance = Distância ao longo dele
author-direction = A sua direção
author-direction-vector = vetor à escolha
author-direction-through = por outro ponto
author-along = segundo { $axis }
author-parallel = paralelo ao eixo { $axis }
author-opposite = oposto ao eixo { $axis }
author-perpendicular = perpendicular ao eixo { $axis }, para …
author-across = perpendicular aos eixos { $axis } e { $other }
author-lengths-named = Comprimentos com nome
author-lengths-named-hint = Escreva em qualquer campo acima um nome como L1 ou a2, também somas como L1 + L2, e dê aqui o seu valor.
author-lengths-none = Nenhum comprimento tem nome ainda.
author-scene = Os eixos no espaço
author-scene-hint = Clique num ponto da grelha ou de outro eixo para pôr lá o eixo escolhido, numa seta para o rodar, num eixo para o escolher. Tudo se pode fazer também nos campos abaixo.
author-scene-text = { $count ->
    [one] Um eixo de junta
   *[other] { $count } eixos de junta
}, com os pontos e direções em que se pode clicar.
author-language = Língua do texto
author-title-of = Título
author-statement = Enunciado
author-statement-hint = Markdown: parágrafos, listas, *ênfase*, **negrito**, `código`. *L1* é composto como variável. O que se pede e o que é livre não precisa de ser dito: o serviço acrescenta-o na língua do leitor.
author-statement-preview = Como os estudantes o leem
author-statement-none = Ainda não há texto nesta língua: quem a lê vê o texto noutra língua e é avisado disso.
author-statement-waiting = Um momento …
author-points = pontos
author-points-of = Pontos por { $part }
author-points-total =
    No total: { $points ->
        [one] { $points } ponto
       *[other] { $points } pontos
    }.
author-rule-convention = Convenção
author-rule-convention-any = qualquer
author-rule-convention-standard = standard
author-rule-convention-modified = modificada
author-rule-base = Referencial 0
author-rule-base-free = em qualquer lugar
author-rule-base-axis = z como na solução
author-rule-base-origin = origem como na solução
author-rule-base-frame = exatamente como na solução
author-rule-tool = Último referencial
author-rule-tool-free = em qualquer lugar
author-rule-tool-point = origem no ponto marcado
author-rule-tool-axis = z sobre o último eixo
author-rule-tool-frame = exatamente como na solução
author-rule-zero = Zero das variáveis
author-rule-zero-free = livre
author-rule-zero-figure = como na figura
author-rule-direction = Sentido positivo
author-rule-direction-free = livre
author-rule-direction-figure = como na figura
author-tolerance-length = Tolerância, como fração do tamanho do robô
author-tolerance-angle = Tolerância dos ângulos, rad
author-policy-admits = Das { $choices } formas como os manuais escreveriam a tabela deste robô, { $admitted ->
    [one] é aceite uma
   *[other] são aceites { $admitted }
}. Os referenciais entre as juntas são livres em qualquer caso.
author-values-hint = Cada estudante recebe valores próprios onde se dá um intervalo; nos outros casos vale o valor habitual.
author-values-none = A tabela não tem dimensões com nome.
author-value = Valor habitual
author-drawn = sorteado para cada estudante
author-draw-from = { $name } de
author-draw-to = { $name } até
author-draw-step = { $name } com passo
author-draw-from-short = de
author-draw-to-short = até
author-draw-step-short = passo
author-aliases = Outros nomes
author-help-most = O máximo que se diz sobre uma tabela errada
author-help-ladder = pouco no início, mais a cada tentativa
author-attempts = Tentativas
author-access = O que os estudantes podem usar enquanto trabalham
author-access-hint = Aos estudantes que chegam por uma ligação de uma disciplina, o próprio serviço recusa o que está desligado.
author-access-catalogue = o catálogo de robôs
author-access-playground = a oficina
author-access-matrices = as matrizes de uma tabela
author-access-trainer = o treino de referenciais
author-view-azimuth = Vista: rotação em torno da vertical
author-view-elevation = Vista: altura
author-posture = Configuração na figura
author-marks = Pontos marcados
author-marks-hint = São precisos se as regras prendem o último referencial a um ponto.
author-mark-end = marcar a última origem como P
author-lengths = Cotas desenhadas de outro modo
author-lengths-hint = Dê a uma cota pequena outro comprimento na figura para que se leia bem; a figura diz que não está à escala. Vazio: tal como é.
author-saved = guardado neste navegador
author-other-tab = Esta página também está aberta noutro separador, e o rascunho acabou de ser alterado lá. Só é guardado o rascunho que for alterado por último.
author-test-waiting = Alterado; os testes correm daqui a pouco.
author-test-refused = Os testes correm assim que os erros assinalados acima forem corrigidos.
author-test-running = A testar: respostas certas com outros referenciais, erros, cada parte …
author-test-passed = Passaram todas as { $passed } verificações.
author-test-failed = { $failed ->
    [one] Falhou uma verificação
   *[other] Falharam { $failed } verificações
}; { $passed } passaram.
author-test-warnings = Convém saber:
author-try = Experimentar como estudante
author-right = Mostrar dez respostas certas diferentes
author-right-shown = { $wrong ->
    [0] As { $count } são aceites; a primeira é a sua solução.
   *[other] { $wrong } de { $count } são recusadas.
}
author-wrong = Mostrar as respostas erradas mais comuns e os seus pontos
author-wrong-hint = As mais prováveis primeiro: o que se diria a um estudante e o que a resposta toda ainda vale. Acrescente palavras suas onde quiser.
author-wrong-marks =
    { $points } de { $most ->
        [one] { $most } ponto
       *[other] { $most } pontos
    }, tabela { $score } %
author-wrong-refused = recusada, não custa tentativa
author-wrong-untold = Não se sugere nenhuma correção ({ $name }).
author-wrong-tested = o exercício testa-se com este erro
author-own-words = As suas palavras, depois das nossas
author-id = Nome da pasta
author-download = Descarregar a pasta
author-downloaded = O arquivo contém uma pasta para git e para “framewise exercises check”.
author-publish = Publicar neste serviço
author-publish-closed = Este serviço não aceita exercícios a partir desta página: descarregue a pasta e entregue-a a quem gere o serviço.
author-published = Publicado. Esta versão fica assim para sempre; uma alteração cria outra.
author-open = Abrir o exercício
author-insert = Inseri-lo na disciplina
author-lti-hint = Numa ligação criada pela sua plataforma, dê isto como parâmetro personalizado:
author-link = Copiar uma ligação para o rascunho
author-link-copied = O endereço contém agora todo o rascunho e foi copiado.
author-import = Abrir uma pasta (zip)
author-import-hint = Como se descarrega aqui ou como a tem no git.
author-imported = O exercício está aberto.

## What a definition may say beside

author-add = Acrescentar: { $name }
author-remove = Remover { $name }
author-usual = valor habitual
author-dimension-handle = Cota { $name }: arraste-a ou use as setas; com Retrocesso, o serviço volta a colocá-la
author-dimension-hint = Arraste o nome de uma cota para onde se leia bem.
author-dimension-moved = { $name } deslocada.
author-dimension-free = { $name } volta a ser colocada automaticamente.
author-draw-without = sem
author-part-keys = { $part }: o que é dado e pedido
author-part-not-beside = Não em conjunto com “{ $part }”: uma parte mostra a resposta da outra.
author-needs = Necessárias em todas as respostas certas
author-needs-hint = As regras têm de o garantir: fixe a base ou a ferramenta; senão, uma escolha de referenciais deixa a cota de fora.
author-rungs = O máximo que se diz
author-rung = na tentativa { $number }
author-rung-more = Mais um degrau
author-rung-less = Menos um degrau
author-weights = O que custam os erros
author-weights-hint = Pesos relativos: um erro de peso 2 custa o dobro de um de peso 1. Num campo vazio vale o peso habitual.
author-weight-joint = junta em falta; se for de outro tipo, o dobro
author-weight-twist = uma torção α
author-weight-length = um comprimento a
author-weight-offset = um deslocamento d, ou θ de uma prismática
author-weight-rule = uma regra não cumprida
author-weight-sign = só o sinal, como fração
author-weight-row = um erro com nome numa linha, no máximo
author-weight-table = um em toda a tabela, no máximo
author-samples = Respostas suas para os testes
author-samples-hint = O autoteste julga-as e avisa se o veredicto não é o que espera. Experimente uma resposta como estudante para a guardar aqui.
author-sample = Exemplo
author-sample-key = a solução
author-sample-name = O que mostra
author-sample-expect = Esperado
author-sample-correct = certa
author-sample-incorrect = errada
author-sample-invalid = recusada
author-sample-feedback = Códigos que o veredicto contém
author-sample-keep = Guardar esta resposta como exemplo
author-sample-kept = Guardada entre os exemplos.
author-figure-more = Tudo o resto sobre a figura
author-figure-upright = Como está o referencial 0 na figura, graus
author-figure-roll = rolamento
author-figure-pitch = arfagem
author-figure-yaw = guinada
author-figure-width = Largura do papel
author-figure-points = Pontos com nome
author-figure-joints = Corpos das juntas
author-figure-name = Nome
author-figure-at = no ponto
author-figure-label = número na ponta
author-figure-scale = tamanho
author-figure-reach = comprimento do eixo
author-figure-links = Elos
author-figure-links-hint = Uma cadeia de pontos em cada linha: O0 O1 P
author-figure-marks = Todos os pontos marcados
author-figure-ground = Base fixa
author-figure-normal = direção que se afasta dela, x y z
author-figure-gripper = Garra
author-figure-away = a afastar-se do ponto
author-figure-jaws = dedos lado a lado segundo x y z
author-figure-dimension = Cota
author-figure-value = comprimento, se não for o nome
author-figure-offset = deslocada para, x y z
author-figure-distance = quanto
author-figure-distance-along = quanto ao longo dele
author-figure-form = Como
author-figure-frame = num referencial da solução
author-figure-between = entre dois pontos
author-figure-by = deslocado
author-figure-joint = ao longo do eixo de uma junta
author-figure-coordinates = coordenadas
author-figure-ratio = na fração
author-figure-from = a partir do ponto
author-key-joints = Valores das juntas
author-key-turns = Ângulos sorteados para cada estudante
author-key-slides = Deslizamentos sorteados para cada estudante
author-key-tolerance = Tolerância
author-key-point = Ponto marcado
author-key-from = Distância a partir de
author-key-limits = Limites das juntas
author-key-mistakes = Erros que se podem introduzir
author-key-known = Pose conhecida
author-key-asked = Pede-se: a pose
author-key-ask = O que se pede
author-key-frame = Nos eixos
author-key-axes = Ordem dos eixos
author-key-turning = Rotação em torno
author-key-asked_axes = Ordem dos eixos pedida
author-key-asked_turning = Pede-se: rotação em torno
author-key-wrench = Força e momento que a ferramenta exerce
author-key-cases = Poses que se podem pedir
author-key-solutions = Soluções pedidas
author-key-reach = O que se deve alcançar
author-key-given = Dado como
author-key-angles = Ângulos
author-key-middle = Ângulo do meio sorteado entre
author-choice-jacobian = a jacobiana
author-choice-forces = os binários e forças nas juntas
author-choice-base = do referencial 0
author-choice-end = do último referencial
author-choice-reached = alcançável
author-choice-out_of_reach = fora do alcance
author-choice-all = todas
author-choice-one = uma
author-choice-pose = posição e orientação
author-choice-position = só a posição
author-choice-matrix = matriz de rotação
author-choice-quaternion = quaternião
author-choice-axis_angle = eixo e ângulo
author-choice-angles = três ângulos
author-choice-every_triple = todos os ternos de ângulos
author-choice-current = dos eixos do referencial móvel
author-choice-fixed = de eixos fixos
author-choice-axis = o eixo da junta 1
author-key-one-joint = { $name } sorteada à parte
author-version = Versão: aumente-a quando mudarem as respostas certas ou os valores
author-variants = Conjuntos de valores para todos os estudantes
author-key-motion = Movimento que conta
author-choice-twist = velocidades linear e angular
author-choice-translation = só a velocidade linear
author-key-links = Elos do braço
author-key-gravity = Aceleração da gravidade, no referencial 0
author-key-weights = Símbolos e seus valores
author-key-matrix = Matriz mostrada
author-choice-mass = a matriz de massa M
author-choice-coriolis = uma matriz C
author-choice-skew = que Ṁ − 2C é antissimétrica
author-choice-velocity = apenas C q̇
author-choice-gravity = o termo gravitacional g
author-choice-link = de um elo
author-choice-transform = do braço inteiro
author-body = Elo { $number }
author-body-mass = massa
author-body-centre = centro de massa
author-body-moments = momentos de inércia
author-quantity-name = Nome de uma grandeza
author-quantity-value = valor
author-quantity-draw = sorteado para cada estudante
