# O treino de referenciais.

trainer-title = Treino de referenciais
trainer-heading = Atribua os referenciais
trainer-lead = Referencial a referencial, pela ordem em que se ensina: todos os eixos z, as normais comuns, as origens, todos os eixos x. Cada passo é verificado no fim; depois lê-se a tabela DH.
trainer-back = Voltar ao exercício
trainer-frames = Referenciais
trainer-table = A tabela que resulta
trainer-scene = Eixos e referenciais
trainer-click = Clique numa seta ou num ponto, ou arraste-o, para o escolher; as listas fazem o mesmo.
trainer-complete = Todos os referenciais obedecem à convenção: a tabela está completa.
trainer-unfinished = Uma linha aparece assim que ambos os seus referenciais estão completos e não violam nenhuma regra.
trainer-status =
    { $broken ->
        [0] Nenhuma regra violada até agora.
        [one] Uma regra violada.
       *[other] { $broken } regras violadas.
    }
trainer-step = Referencial { $frame }: { $state }
trainer-state-open = por terminar
trainer-state-whole = completo
trainer-state-broken = viola uma regra
trainer-part-z = Direção de z, referencial { $frame }
trainer-part-origin = Origem, referencial { $frame }
trainer-part-x = Direção de x, referencial { $frame }
trainer-opposite = oposto:
trainer-candidate-foot = no eixo { $axis }, no pé da normal ao eixo { $other }
trainer-candidate-intersection = onde os eixos { $axis } e { $other } se encontram
trainer-candidate-level = no eixo { $axis }, ao nível da origem do referencial { $frame }
trainer-candidate-axis_point = no eixo { $axis }, onde está desenhada a junta
trainer-candidate-base = como no referencial da base dado
trainer-candidate-tool = como no referencial da ferramenta dado
trainer-candidate-coordinates =
    { $axis ->
        [1] ao longo de X das coordenadas da figura
        [2] ao longo de Y das coordenadas da figura
        [3] ao longo de Z das coordenadas da figura
       *[other] a origem das coordenadas da figura
    }
trainer-candidate-axis = ao longo do eixo { $axis }
trainer-candidate-normal = ao longo da normal comum dos eixos { $axis } e { $other }
trainer-candidate-frame_x = ao longo de x do referencial { $frame }
trainer-candidate-across = perpendicular ao eixo { $axis }

trainer-step-z = Eixos z
trainer-step-normals = Normais comuns
trainer-step-origin = Origens
trainer-step-x = Eixos x
trainer-step-read = Leitura
trainer-task-z = Escolha para cada referencial a direção de z. Fica sobre o eixo de uma junta; qual, depende da convenção.
trainer-task-normals = As normais comuns dos eixos vizinhos estão desenhadas. Delas resultam as origens e os eixos x.
trainer-task-origin = Escolha a origem de cada referencial. As normais comuns estão desenhadas.
trainer-task-x = Escolha para cada referencial a direção de x. Segue a normal comum até ao eixo z seguinte ou, onde os eixos se intersetam, é perpendicular aos dois eixos z.
trainer-normal-skew = Os eixos { $axis } e { $other } são enviesados: têm uma única normal comum, que está desenhada.
trainer-normal-meet = Os eixos { $axis } e { $other } intersetam-se: x é perpendicular a ambos e a origem fica no ponto de interseção.
trainer-normal-parallel = Os eixos { $axis } e { $other } são paralelos ou coincidentes: qualquer normal comum serve; escolha a que anula d.
trainer-check = Verificar este passo
trainer-onward = Continuar
trainer-restart = Recomeçar
trainer-step-done = Este passo está certo.
trainer-why-z =
    Cada z está ao longo do eixo da junta que lhe corresponde: { $convention ->
        [standard] z do referencial i−1 ao longo do eixo i, porque a linha i roda θ em torno de z do referencial i−1 e avança d ao longo dele.
       *[modified] z do referencial i ao longo do eixo i, porque a linha i termina com θ em torno de z do referencial i e d ao longo dele.
    }
trainer-why-origin = Cada origem está onde a normal comum encontra o seu eixo, porque a se mede a partir daí ao longo de x.
trainer-why-x = Cada x está numa normal comum ou perpendicular a ambos os eixos, porque a e α se medem ao longo e em torno dele.
trainer-open-choice = O referencial { $frame } ainda não tem escolha.
trainer-point-missed = A origem do referencial { $frame } deve ficar no ponto marcado { $point }.
trainer-read = Prima o número de uma linha: a imagem mostra como os seus quatro números levam um referencial ao seguinte.
trainer-take = Levar a tabela para o exercício
