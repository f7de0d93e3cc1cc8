# O formulário web dos estudantes: o que diz cada página.

form-skip = Ir para o conteúdo
form-nav-label = Páginas
form-nav-exercises = Exercícios
form-nav-playground = Oficina
form-language = Língua
form-needs-script = Esta página precisa de JavaScript: é ele que desenha o robô e verifica a tabela enquanto se escreve.
form-unreachable = Não é possível contactar o serviço. O que escreveu foi guardado; tente de novo daqui a pouco.
form-retry = Tentar de novo
form-cancel = Cancelar
form-close = Fechar
form-named = { $name }: { $said }
form-loading = A carregar …

form-home-title = Exercícios
form-home-heading = Descreva o robô. Vale qualquer escolha correta de referenciais.
form-home-lead = Tabelas de Denavit–Hartenberg com um robô que se move enquanto se escreve e um verificador que prova se a tabela descreve o mesmo mecanismo.
form-home-exercises = Exercícios
form-home-subjects = Temas
form-home-more = Mais
form-home-playground = Qualquer tabela: poses, jacobianas, formas fechadas, conversões.
form-home-api = Interface de programação
form-home-api-text = O mesmo por HTTP, como documento OpenAPI.
form-home-best =
    Melhor: { $points } de { $total ->
        [one] { $total } ponto
       *[other] { $total } pontos
    }
form-home-joints =
    { $joints ->
        [one] Uma junta
       *[other] { $joints } juntas
    }
form-home-trainer = Praticar a atribuição de referenciais

form-scene-role = vista 3D
form-scene-label = Robô
form-scene-tools = Vista
form-scene-view = Ver
form-scene-view-corner = De canto
form-scene-view-front = De frente
form-scene-view-side = De lado
form-scene-view-top = De cima
form-scene-view-now = Vista: { $view }
form-scene-turn-left = Rodar para a esquerda
form-scene-turn-right = Rodar para a direita
form-scene-turn-up = Inclinar para cima
form-scene-turn-down = Inclinar para baixo
form-scene-zoom-in = Ampliar
form-scene-zoom-out = Reduzir
form-scene-reset = Mostrar tudo
form-scene-keys = As setas rodam a vista, Shift com setas desloca-a, + e − ampliam e reduzem, 0 mostra tudo.

form-joint = Junta
form-joint-revolute = rotativa
form-joint-prismatic = prismática
form-joint-fixed = fixa
form-joint-of-row = Tipo de junta, linha { $row }
form-joint-turn = Ângulo da junta { $name }
form-joint-slide = Deslocamento da junta { $name }
form-joint-value = { $name } em { unit-word }
form-joints-reset = Repor as juntas

form-convention = Convenção
form-convention-standard = standard
form-convention-modified = modificada
form-convention-now-standard = Os valores ficam como estão e leem-se agora na convenção standard: a e α pertencem ao elo i, a junta i move-se segundo o eixo z do referencial i−1.
form-convention-now-modified = Os valores ficam como estão e leem-se agora na convenção modificada: a e α pertencem ao elo i−1, a junta i move-se segundo o eixo z do referencial i.
form-angle-unit = Unidade dos ângulos
form-degrees = graus
form-radians = radianos
form-length-unit = Unidade dos comprimentos
unit-word = { $unit ->
    [in] polegadas
   *[other] { $unit }
}
form-unit-now-deg = Os números das colunas de ângulos leem-se agora em graus.
form-unit-now-rad = Os números das colunas de ângulos leem-se agora em radianos.
form-unit-now-length = Os números das colunas de comprimentos leem-se agora em { unit-word }.
form-unit-doubt-deg = { $value } rad é mais de uma volta. Estes ângulos estão em graus?
form-unit-doubt-rad = { $value }° é um ângulo muito pequeno. Estes ângulos estão em radianos?
form-unit-read-deg = Lê-los em graus
form-unit-read-rad = Lê-los em radianos
form-unit-convert = Converter os números
form-unit-converted = Números convertidos.
form-unit-converted-but =
    { $count ->
        [one] Números convertidos, exceto numa célula que não é uma simples soma: verifique-a.
       *[other] Números convertidos, exceto em { $count } células que não são simples somas: verifique-as.
    }

form-table-caption = Tabela DH, convenção { $convention }
form-row-actions = Ações
form-row-add = Acrescentar uma linha
form-row-added = Linha { $row } acrescentada
form-row-remove = Remover a linha { $row }
form-row-removed = Linha { $row } removida
form-row-up = Subir a linha { $row }
form-row-down = Descer a linha { $row }
form-row-moved = A linha { $row } é agora a linha { $to }
form-row = linha { $row }
form-column = coluna { $name }
form-row-cell = linha { $row }, { $name }
form-cell-label = Linha { $row }, { $name } [{ $unit }]
form-cell-empty = Vazia: escreva 0 se for zero.
form-refused = Não foi possível:
form-faults =
    { $count ->
        [one] Uma célula precisa de atenção:
       *[other] { $count } células precisam de atenção:
    }
form-undo = Desfazer
form-undone = Desfeito
form-redo = Refazer
form-redone = Refeito
form-symbols = Símbolos
form-symbol-insert = Inserir { $symbol }
form-keys = Setas para cima e para baixo mudam de linha · Alt com seta move a linha · Alt+Enter acrescenta uma · Alt+Delete remove-a · Ctrl+Z desfaz.
form-paste-title = Colar uma tabela
form-paste-label = Uma tabela de uma folha de cálculo, LaTeX, Markdown, PDF, MATLAB ou Python
form-paste-order = Colunas sem cabeçalho leem-se por esta ordem: { $order }
form-paste-found =
    { $rows ->
        [one] Uma linha encontrada:
       *[other] { $rows } linhas encontradas:
    }
form-paste-nothing = Não se reconhece nenhuma tabela neste texto: cada linha precisa dos quatro parâmetros DH.
form-paste-preview = O que foi encontrado
form-paste-apply = Usar esta tabela
form-pasted =
    { $rows ->
        [one] Uma linha colada.
       *[other] { $rows } linhas coladas.
    }

form-matrix-mode = Matrizes como
form-matrix-numbers = Números
form-matrix-symbols = Símbolos
form-matrix-notation = Notação
form-matrix-short = abreviada
form-matrix-full = completa
form-matrix-none = As matrizes aparecem assim que todas as linhas possam ser lidas.
form-matrix-name = Pose do referencial { $to } no referencial { $from }
form-copy = Copiar como
form-copy-group = Copiar: { $what }
form-copied = Copiado como { $format }
form-copy-failed = O navegador não permite copiar

form-exercise-title = Exercício
form-exercise-task = Enunciado
form-exercise-robot = O robô
form-exercise-description = Descrição por palavras
form-exercise-answer = A sua resposta
form-exercise-givens = Dados
form-exercise-rules = O que é livre e o que está fixado
form-figure-mode = Mostrar o robô em
form-figure-drawing = Desenho
form-figure-space = 3D
form-figure-alt = Desenho do robô: { $title }. Segue-se uma descrição por palavras.
form-figure-label = { $title } no espaço
form-figure-move = Mover as juntas
form-figure-posture = Os valores medem-se a partir da configuração do desenho.
form-choose = Escolha …
form-choose-missing = Escolha uma opção.
form-points =
    { $points } de { $total ->
        [one] { $total } ponto
       *[other] { $total } pontos
    }
form-row-go = Ir para a linha { $row }
form-row-heading = Linha
form-row-missing =
    { $after ->
        [0] antes da 1
       *[other] após a { $after }
    }
form-submit = Verificar a resposta
form-submitting = A verificar …
form-submit-hint = Ctrl+Enter faz o mesmo.
form-help = Se a resposta estiver errada, diga-me
form-help-verdict = apenas isso
form-help-row = que linhas estão erradas
form-help-kind = o que está errado em cada linha
form-help-repair = o que a tornaria certa

form-part-table = Tabela DH
form-part-schematic = Estrutura
form-part-link-matrices = Matrizes dos elos
form-part-transform = Pose do último referencial, em símbolos
form-part-pose = Pose do último referencial, em números
form-part-workspace = Espaço de trabalho
form-part-orientation = Orientação
form-part-rotation-check = Rotação ou não
form-part-frame-chain = Cadeia de referenciais
form-part-inverse-kinematics = Cinemática inversa
form-part-find-mistake = Encontrar o erro
form-part-matrix-mistake = Encontrar o erro numa matriz
form-part-frame-mistake = Encontrar o erro numa figura
form-part-compare-tables = Duas tabelas
form-part-screws = Produto de exponenciais
form-part-jacobian = Jacobiana e estática
form-part-jacobian-form = Jacobiana em forma fechada
form-part-singularities = Singularidades
form-part-equations-of-motion = Equações do movimento
form-part-wrong = A rever:
form-radius-inner = Raio interior
form-radius-outer = Raio exterior
form-matrix-cell = { $name }, linha { $row }, coluna { $column }
form-schematic-joint = Junta { $joint }
form-schematic-relation = Eixo { $joint } em relação ao eixo { $next }
form-relation-coincident = coincidentes
form-relation-parallel = paralelos
form-relation-intersecting-perpendicular = concorrentes, perpendiculares
form-relation-intersecting-oblique = concorrentes, oblíquos
form-relation-skew-perpendicular = enviesados, perpendiculares
form-relation-skew-oblique = enviesados, oblíquos

form-own-heading = O seu robô
form-own-scene = O seu robô, tal como a sua tabela o descreve
form-own-empty = O seu robô cresce aqui com cada linha que pode ser lida.
form-own-missing =
    { $count ->
        [one] Uma célula ainda está vazia.
       *[other] { $count } células ainda estão vazias.
    }
form-own-unread =
    { $count ->
        [one] Uma célula ainda não pode ser lida.
       *[other] { $count } células ainda não podem ser lidas.
    }
form-own-last = A imagem mostra a última tabela que pôde ser lida.
form-own-values = Para desenhar o seu robô, dê um valor a: { $names }.
form-own-shown =
    { $joints ->
        [one] Desenhado a partir da sua tabela: uma junta.
       *[other] Desenhado a partir da sua tabela: { $joints } juntas.
    }
form-own-description = Os referenciais da sua tabela com os eixos x, y e z.{ $count ->
    [0] {""}
   *[other] {" "}Juntas: { $joints }.
}
form-own-parameters = Valores para o desenho
form-joints = Juntas
form-matrices = Matrizes

form-verdict-heading = Veredicto
form-verdict-correct = A sua tabela descreve este robô.
form-verdict-wrong = A sua tabela ainda não está certa.
form-verdict-all = Tudo o que entregou está certo.
form-verdict-some = Ainda nem tudo está certo.
form-verdict-outdated = Entretanto alterou a sua resposta.
form-basis-proved = Provado: a identidade vale para todos os valores das juntas.
form-basis-verified = Verificado em muitas configurações.
form-links-caption = O que está certo em cada linha
form-fact-twist = Torção α
form-fact-length = Comprimento a
form-fact-offset = Deslocamento
form-fact-joint = Tipo de junta
form-finding-ok = certo
form-finding-wrong = errado
form-finding-doubtful = talvez errado
form-finding-missing = falta
form-finding-unknown = em aberto
form-finding-hidden = –
form-repairs = O que a tornaria certa
form-repair-or = ou
form-both-label = O robô do exercício e o seu, a moverem-se juntos
form-both-text = Os dois robôs movem-se juntos: o seu com os seus referenciais, o do exercício a cinzento e laranja.
form-both-description = Os seus referenciais assentam no robô do exercício e ambos seguem o mesmo movimento.
form-both-position = Instante do movimento
form-play = Iniciar
form-pause = Pausa

form-history-heading = As suas tentativas
form-history-restore = Repor no formulário
form-history-restored = A tentativa está de novo no formulário
form-history-kept = Guardadas apenas neste navegador.
form-history-clear = Limpar o histórico

form-missing-title = Não encontrado
form-missing-text = Esta página não existe. Todos os exercícios estão na primeira página.
form-missing-home = Para os exercícios
form-storage-blocked = O navegador não guarda nada aqui: o que escreve perde-se ao fechar ou recarregar esta página.
form-other-tab = Este exercício também está aberto noutro separador, onde se acabou de escrever algo. Fica o que for escrito por último.
form-other-tab-take = Mostrar o que lá foi escrito

form-row-play = Mostrar a linha { $row } na imagem
form-film = A linha passo a passo
form-film-hint = Coloque o cursor numa célula ou prima o número de uma linha: vê-se como os seus quatro números levam o referencial i−1 ao referencial i.
form-film-none = A linha { $row } ainda não pode ser mostrada: preencha-a, bem como as anteriores.
form-film-play = Reproduzir a linha
form-film-back = Um passo atrás
form-film-forward = Um passo à frente
form-film-row-before = Linha anterior
form-film-row-after = Linha seguinte
form-film-start = Linha { $row }: parte do referencial { $frame }.
form-film-turn = Linha { $row }, { $number } de 4: rotação de { $letter } = { $value } em torno de { $axis }.
form-film-slide = Linha { $row }, { $number } de 4: translação de { $letter } = { $value } ao longo de { $axis }.
form-scene-enlarge = Ecrã inteiro
form-scene-record = Guardar como imagem
form-scene-recorded = Imagem guardada
form-own-rows =
    { $rows ->
        [one] Desenhada até agora: uma linha.
       *[other] Desenhadas até agora: { $rows } linhas.
    }

form-matrix-text = Como texto
form-matrix-text-label = { $name } como texto: LaTeX, MATLAB, Python ou células de uma folha de cálculo
form-matrix-text-unread = Não se reconhece nenhuma matriz 4×4 neste texto.
form-name-unknown =
    { $known ->
        [none] { $name } não é uma dimensão deste robô; nenhuma tem nome.
       *[other] { $name } não é uma dimensão deste robô. As suas dimensões: { $names }.
    }

form-nav-lesson = Primeira lição
form-term = O que significa “{ $term }”?
form-convention-what = O que são?
form-exercise-write = Fixe um referencial a cada elo e escreva a tabela DH deste robô.

form-why = Porque é que cada linha está certa
form-why-row = Linha { $row }: posição dos eixos z{ $before } e z{ $row }: { $relation }; por isso α = { $alpha } e a = { $a }; ao longo de z, os referenciais distam d = { $d }.
form-second-table = Outra tabela válida
form-second-other-convention = Está escrita na convenção { $convention }.
form-second-axis-reversed = Um eixo z aponta no sentido oposto, ou uma variável de junta cresce no sentido oposto.
form-second-x-turned = Um eixo x aponta para outro lado, pelo que a variável da sua junta vale zero noutra posição.
form-second-origin-moved = Uma origem está noutro ponto do seu eixo.
form-second-none = As regras deste exercício não deixam outra tabela.

form-ghost-label = O seu robô, transparente, sobre o do exercício
form-ghost-text = O robô do exercício é cinzento e laranja; o seu, vermelho transparente. Ambos fazem o mesmo movimento. O referencial marcado { $row }, o da linha { $row }, é o primeiro que se afasta do robô do exercício.
form-ghost-description = O seu robô coincide com o do exercício antes do referencial { $row }, que está marcado: aí separam-se.
form-ghost-later = Neste momento verificam-se tantas respostas que ainda não se desenhou onde o seu robô se afasta do robô do exercício.
form-ghost-draw = Desenhar agora
form-ghost-none = O seu robô não pode ser desenhado sobre o do exercício.
form-new = Nova
form-new-done = Uma tabela nova, vazia.

form-progress = Progresso
form-progress-open = por fazer
form-progress-typed = por verificar
form-part-missing = por entregar
form-part-empty = Ainda não há nada escrito aqui.
form-submit-part = Verificar esta parte
form-points-for = Uma tabela errada ganha pontos pelas torções, comprimentos e deslocamentos certos que uma tabela de zeros não teria. O que mais custa é uma junta em falta ou do tipo errado; o que menos, um sinal errado.
form-help-steps = uma pista de cada vez
form-help-principle = O princípio.
form-help-worked = Um passo resolvido, noutro robô.
form-help-next = Para obter a pista seguinte, altere a resposta e verifique-a de novo.
form-principle-twist = A torção α leva um eixo z ao seguinte, vista ao longo do eixo x, perpendicular a ambos. Eixos z paralelos têm 0° ou 180°, perpendiculares 90° ou −90°; a mão direita, com o polegar segundo x, dá o sinal.
form-principle-length = O comprimento a é a distância entre dois eixos z vizinhos ao longo da normal comum, que é o eixo x. É 0 se e só se as duas retas se intersetam.
form-principle-offset = O deslocamento d é a distância, ao longo de um eixo z, entre os pés de duas normais comuns: a que vem do eixo anterior e a que vai para o seguinte. Entre eixos paralelos pode escolher onde fica a normal, mas uma só vez.
form-principle-joint = Uma junta rotativa roda em torno do seu eixo z: a variável é θ. Uma junta prismática desliza ao longo dele: a variável é d. Cada junta tem uma linha, pela ordem da base à ferramenta.
form-worked-twist = Um ombro cujo primeiro eixo é vertical e cujo segundo eixo é horizontal: os dois eixos z são perpendiculares. Com x virado para si, a mão direita leva o z vertical ao horizontal com −90° ou 90°, conforme o sentido dado a z; logo α = −90° ou 90°, nunca 0.
form-worked-length = Dois elos num plano, com 0,4 m e 0,3 m: os dois eixos são verticais, a 0,4 m um do outro. A normal comum é o primeiro elo, logo a = 0,4 m. Num punho cujos eixos se intersetam num ponto, cada a é 0.
form-worked-offset = Um ombro está 0,2 m ao lado do primeiro eixo, vertical, e o segundo eixo é horizontal. Ao longo do segundo eixo há 0,2 m entre o pé da normal vinda do primeiro e o da normal para o terceiro: d = 0,2 m, na linha da segunda junta.
form-worked-joint = Um pórtico desloca o carro ao longo de uma calha e roda a garra por baixo. A calha é uma junta prismática: a sua linha tem a variável em d e um número em θ. A garra é uma junta rotativa: a variável em θ e um número em d.
form-home-author = Criar um exercício
form-home-author-text = Para docentes: faça do braço do seu próprio livro um exercício, num quarto de hora.

form-matrices-withheld = As matrizes aparecem aqui quando as partes que as pedem estiverem certas.
form-sharing = Para docentes: ligações e pacotes
form-sharing-text = Uma ligação leva estas definições, assinadas: quem chega por ela não as pode mudar, e é o próprio serviço que as faz cumprir. Um pacote SCORM entra numa disciplina sem administrador; a classificação vem do navegador do estudante, mas o comprovativo nos comentários não pode ser forjado.
form-sharing-may = Os estudantes podem usar
form-sharing-catalogue = o catálogo de robôs
form-sharing-playground = a oficina
form-sharing-matrices = as matrizes da própria tabela
form-sharing-trainer = o treino de referenciais
form-sharing-help = O que lhes é dito sobre uma resposta errada
form-sharing-attempts = Tentativas
form-sharing-link = Criar uma ligação
form-sharing-receipts = Verificar comprovativos
form-receipt = Obter um comprovativo
form-receipt-text = Um comprovativo diz o que esta resposta valeu e é assinado por este serviço. Entregue-o ao docente: como texto, como código QR ou como página impressa.
form-receipt-name = O seu nome, tal como figura na disciplina
form-receipt-as-text = Comprovativo como texto
form-receipt-copy = Copiar o texto
form-receipt-qr = Comprovativo como código QR
form-receipt-pdf = Página para imprimir (PDF)

form-part-frames = Referenciais
form-frames-hint = Comprimentos em { unit-word }. Uma direção pode ter qualquer comprimento.
form-frames-scene = O robô com os seus referenciais
form-frames-drawn = { $drawn } de { $all } referenciais estão desenhados.
form-frames-frame = Referencial { $frame }
form-frames-z = z aponta
form-frames-origin = Origem
form-frames-x = x aponta
form-frames-z-of = z do referencial { $frame }
form-frames-origin-of = origem do referencial { $frame }
form-frames-x-of = x do referencial { $frame }
form-frames-ends = onde estão o primeiro e o último referencial
form-frames-typed = escrito …
form-frames-at-joint = no corpo da junta { $joint }
form-frames-at-point = em { $name }
form-frames-at-ground = onde o robô está fixo
form-frames-along = ao longo do eixo da junta { $joint }
form-frames-against = no sentido oposto ao do eixo da junta { $joint }
form-answer-empty = Nada foi entregue. O exercício pede: { $parts }.
