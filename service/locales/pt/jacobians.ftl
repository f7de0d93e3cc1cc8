task-jacobian-analytic =
    { $variables ->
        [own] Tome sua própria tabela e suas próprias variáveis nestes valores.
       *[given] São dadas a tabela do robô e uma configuração.
    } Escreva a jacobiana analítica: as velocidades da última origem no sistema 0 e depois as derivadas dos três ângulos em torno dos eixos { $turning ->
            [fixed] fixos
           *[current] correntes
        } { $axes }, em sua ordem. Em números, comprimentos em { $unit }, por radiano.

task-jacobian-form =
    { $variables ->
        [own] Tome sua própria tabela e suas próprias variáveis.
       *[given] É dada a tabela do robô.
    } { $ask ->
        [jacobian] Escreva a jacobiana geométrica da última origem em forma fechada: seus elementos são funções das variáveis das juntas, por radiano.
        [forces] Escreva os torques e forças das juntas que correspondem à força e ao momento na última origem, τ = Jᵀ(f, m), como funções das variáveis das juntas.
       *[both] Escreva a jacobiana geométrica da última origem em forma fechada, por radiano, e os torques e forças das juntas τ = Jᵀ(f, m) que correspondem à força e ao momento na última origem.
    } { $frame ->
        [end] Todos os vetores estão nos eixos do último sistema.
       *[base] Todos os vetores estão nos eixos do sistema 0.
    }

task-jacobian-form-analytic =
    { $variables ->
        [own] Tome sua própria tabela e suas próprias variáveis.
       *[given] É dada a tabela do robô.
    } Escreva a jacobiana analítica: as velocidades da última origem no sistema 0 e depois as derivadas dos três ângulos em torno dos eixos { $turning ->
            [fixed] fixos
           *[current] correntes
        } { $axes }, em sua ordem. Os elementos são funções das variáveis das juntas.

feedback-jacobian_geometric = As três últimas linhas são as da velocidade angular; pedem-se as derivadas dos ângulos.
feedback-jacobian_angles_locked = Nesta configuração, o primeiro e o último ângulo giram em torno da mesma reta: os ângulos não têm derivadas, e não há jacobiana analítica.
error-angles_locked = O primeiro e o último dos ângulos { $axes } giram aqui em torno da mesma reta: não há jacobiana analítica. Escolha outros ângulos.
