task-jacobian-analytic =
    { $variables ->
        [own] Tome a sua própria tabela e as suas próprias variáveis das juntas nestes valores.
       *[given] São dadas a tabela do robô e uma configuração.
    } Escreva a jacobiana analítica: a velocidade da última origem no referencial 0 e depois as derivadas temporais dos três ângulos em torno dos eixos { $turning ->
            [fixed] fixos
           *[current] correntes
        } { $axes }, pela sua ordem. Em números, comprimentos em { unit-word }, por radiano.

task-jacobian-form =
    { $variables ->
        [own] Tome a sua própria tabela e as suas próprias variáveis das juntas.
       *[given] É dada a tabela do robô.
    } { $ask ->
        [jacobian] Escreva a jacobiana geométrica da última origem em forma fechada: os seus elementos são funções das variáveis das juntas, por radiano.
        [forces] Escreva os binários e forças nas juntas que correspondem à força e ao momento na última origem, τ = Jᵀ(f, m), como funções das variáveis das juntas.
       *[both] Escreva a jacobiana geométrica da última origem em forma fechada, por radiano, e os binários e forças nas juntas τ = Jᵀ(f, m) que correspondem à força e ao momento na última origem.
    } { $frame ->
        [end] Todos os vetores estão nos eixos do último referencial.
       *[base] Todos os vetores estão nos eixos do referencial 0.
    }

task-jacobian-form-analytic =
    { $variables ->
        [own] Tome a sua própria tabela e as suas próprias variáveis das juntas.
       *[given] É dada a tabela do robô.
    } Escreva a jacobiana analítica: a velocidade da última origem no referencial 0 e depois as derivadas temporais dos três ângulos em torno dos eixos { $turning ->
            [fixed] fixos
           *[current] correntes
        } { $axes }, pela sua ordem. Os elementos são funções das variáveis das juntas.

feedback-jacobian_geometric = As três últimas linhas são as da velocidade angular; pedem-se as derivadas dos ângulos.
feedback-jacobian_other_point = Estas são as velocidades de outro ponto; pede-se a da origem do último referencial.
feedback-jacobian_reversed =
    { $count ->
        [1] A coluna { $joint } tem o sinal oposto: veja para onde aponta z.
       *[other] As colunas { $joints } têm o sinal oposto: veja para onde aponta z.
    }
feedback-jacobian_per_degree = As colunas das juntas rotativas são por grau; pedem-se por radiano.
feedback-jacobian_other_unit = Os comprimentos estão numa unidade diferente da pedida.
feedback-jacobian_angles_locked = Nesta configuração, o primeiro e o último ângulo rodam em torno da mesma reta: os ângulos não têm derivadas, e não há jacobiana analítica.
error-angles_locked = O primeiro e o último dos ângulos { $axes } rodam aqui em torno da mesma reta: não há jacobiana analítica. Escolha outros ângulos.
