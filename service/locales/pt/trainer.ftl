# O treino de referenciais.

trainer-title = Treino de referenciais
trainer-heading = Atribua os referenciais
trainer-lead = Para cada referencial escolha a direção de z, a origem e a direção de x. Cada regra é verificada pelo caminho, e a tabela DH resulta dos seus referenciais.
trainer-back = Voltar ao exercício
trainer-frames = Referenciais
trainer-table = A tabela que resulta
trainer-scene = Eixos e referenciais
trainer-click = Clique num ponto ou numa seta para escolher; as listas fazem o mesmo.
trainer-clear = Limpar este referencial
trainer-next = Próximo referencial
trainer-complete = Todos os referenciais obedecem à convenção: a tabela está completa.
trainer-unfinished = Uma linha aparece assim que ambos os seus referenciais estão completos e não violam nenhuma regra.
trainer-status =
    { $broken ->
        [0] Nenhuma regra violada até agora.
        [one] Uma regra violada.
       *[other] { $broken } regras violadas.
    }
trainer-open = Abrir a tabela na oficina
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
trainer-candidate-base = como no referencial de base dado
trainer-candidate-tool = como no referencial de ferramenta dado
trainer-candidate-coordinates =
    { $axis ->
        [1] ao longo de x das coordenadas
        [2] ao longo de y das coordenadas
        [3] ao longo de z das coordenadas
       *[other] a origem das coordenadas
    }
trainer-candidate-axis = ao longo do eixo { $axis }
trainer-candidate-normal = ao longo da normal dos eixos { $axis } e { $other }
trainer-candidate-frame_x = ao longo de x do referencial { $frame }
trainer-candidate-across = perpendicular ao eixo { $axis }
