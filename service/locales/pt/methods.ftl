# Cinemática inversa.

error-inverse_form_unknown = Os eixos deste braço não se sucedem de um modo cuja cinemática inversa seja conhecida em forma simbólica: têm de ser perpendiculares ou paralelos, com duas ou três juntas que se movem num plano e um punho cujos eixos se intersetam num ponto. Numericamente resolve-se na mesma.
error-inverse_form_idle_joint = A junta { $joint } nada faz onde a solução simbólica precisa dela: o ponto que teria de mover está sobre o seu eixo, ou outra junta move esse ponto do mesmo modo, porque um comprimento entre eixos é 0 ou duas juntas prismáticas são paralelas. A solução numérica funciona na mesma.
error-inverse_joint_count = A cinemática inversa admite de 1 a { $limit } juntas; esta tabela tem { $count }.
error-limits_wrong_length =
    O braço tem { $expected ->
        [one] { $expected } junta
       *[other] { $expected } juntas
    }, mas { $given ->
        [one] foi dado { $given } limite
       *[other] foram dados { $given } limites
    }; dê um para cada junta, null onde não houver limite.
error-limits_reversed = Dê como limites da junta { $joint } o valor mínimo e o valor máximo, nesta ordem.
error-limits_too_far = Os limites da junta { $joint } ficam ambos a mais de { $limit } rad de 0. Subtraia de ambos voltas completas.
error-pose_tolerance_out_of_range = A tolerância é um número positivo, no máximo { $limit }.
error-targets_wrong_shape = Dê vários alvos como uma lista de matrizes 4×4.
error-workspace_condition_unmet = Não se encontrou nenhuma configuração dentro dos limites que cumpra esta condição.
