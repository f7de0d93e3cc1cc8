field-conditions = Condições de singularidade
field-lost = Um movimento perdido

task-singularities =
    É dada a tabela do robô. Em que configurações perde o braço um movimento: { $motion ->
        [translation] onde o posto da jacobiana da velocidade da última origem é menor do que o habitual?
       *[twist] onde o posto da jacobiana é menor do que o habitual?
    } Escreva uma condição em cada linha: uma função que ali se anula (sin(q3)) ou uma equação (q3 = 0, π). Conta o conjunto, seja qual for a forma de o escrever.{ $lost ->
        [yes] {" "}Para a configuração dada, escreva um vetor λ ≠ 0 nos eixos do referencial 0 com λ · J q̇ = 0 façam o que fizerem as juntas, na última origem, comprimentos em { unit-word }: o movimento perdido.
       *[no] {""}
    }

feedback-singularities_right = As condições verificam-se exatamente onde o braço é singular, e nada falta.
feedback-singularities_missing = Famílias de singularidades encontradas: { $found } de { $count }.
feedback-singularity_missing_at = Nenhuma das suas condições se verifica nesta configuração singular: { $at }.
feedback-singularity_invented = A condição { $condition } verifica-se também onde o braço não é singular.
feedback-singularity_invented_at = A condição { $condition } verifica-se em { $at }, onde o braço não é singular.
feedback-singularity_rounded = A condição { $condition } aproxima-se de uma singularidade, mas não o suficiente: calcule com mais casas decimais.
feedback-singularity_sine_for_cosine = A condição { $condition } é a de uma singularidade desfasada de um quarto de volta: seno e cosseno foram trocados.
feedback-singularity_half = De uma família só se encontrou uma parte: considere também a outra solução da sua equação (q = π além de q = 0, o braço dobrado além do esticado).
feedback-singularity_everywhere = A condição { $condition } verifica-se sempre.
feedback-singularity_nowhere = A condição { $condition } nunca se verifica e não diz nada.
feedback-conditions_missing = Faltam as condições.
feedback-lost_motion_missing = Falta o movimento perdido.
feedback-lost_motion_wrong = O vetor não é um movimento que se perde aqui.
feedback-lost_motion_is_kept = Com este vetor o braço ainda se move: λᵀJ não é zero.
feedback-lost_motion_zero = λ = 0 serviria em toda a parte: dê um vetor diferente de 0.
feedback-lost_motion_never = O braço não se move assim em nenhuma configuração: não é aqui que o movimento se perde.
error-conditions_empty = Dê condições ou um movimento perdido.
error-condition_not_equation = { $text } não é uma condição: escreva uma função que se anula ou uma equação com um só sinal =.
error-condition_angle_nonlinear = Um ângulo de uma junta fora de seno, cosseno e tangente só pode estar numa equação como q2 + q3 = π/2.
error-conditions_too_many = Esta célula contém mais de { $limit } condições.
error-condition_period = O que se soma k vezes tem de ser uma volta dividida por um número inteiro: 2π, π, π/2…
error-singularities_no_families = Nenhuma condição pode dizer onde este braço é singular: nunca o é, ou só em famílias de menos dimensões. Escolha o outro movimento ou outro robô.
error-not_singular = O braço não é singular nesta configuração.
