# Como as forças movem um robô.

error-links_count = A lista de elos tem uma entrada para cada linha da tabela: { $expected }, não { $given }.
error-mass_negative = Uma massa não pode ser negativa: { $mass } kg.
error-inertia_not_symmetric = Uma matriz de inércia é simétrica: o elemento xy é igual ao yx.
error-inertia_negative = Um momento de inércia em torno de um eixo nunca é negativo. Esta matriz tem um negativo em torno de algum eixo.
error-dynamics_without_joints = Nada se move: as equações do movimento precisam de uma linha rotativa ou prismática.
error-mass_matrix_singular = Alguma junta não move nada que tenha massa, e nenhuma força determina a sua aceleração. Dê massa e inércia aos elos.
error-links_missing = Indique a massa dos elos: links, uma entrada para cada linha da tabela.
error-name_of_rate = { $name } é o nome da velocidade de uma junta nas formas fechadas. Dê outro nome ao parâmetro.
error-body_varies = A massa de um elo e o seu lugar nele não mudam com as variáveis das juntas: estas figuram só na tabela.
error-dynamics_not_finite = As massas, os comprimentos ou as velocidades são tão grandes que o resultado não é um número.

task-equations-of-motion =
    São dadas a tabela do robô e o corpo que se move com cada referencial i. Escreva os termos pedidos de M q̈ + C q̇ + g = τ como funções de q1, q2, …, das suas velocidades dq1, dq2, … e dos símbolos dados; comprimentos em { unit-word }, por radiano. { $skew ->
        [yes] Está certa qualquer C que dê o C q̇ certo; além disso, Ṁ − 2C deve ser antissimétrica.
       *[no] Está certa qualquer C que dê o C q̇ certo.
    }
given-link-weights = Os elos: massa, centro no referencial i, momentos em torno dele [kg { $unit }²]
given-gravity-vector = Aceleração da gravidade no referencial 0 [{ $unit }/s²]
given-weights = Valores dos símbolos
field-mass = Matriz de massa M
field-coriolis = Matriz C
field-velocity = Termos de Coriolis e centrífugos C q̇
field-gravity = Termos gravitacionais g
feedback-motion_right = Estas são as equações do movimento.
feedback-motion_mass_wrong = Nem todos os elementos de M estão certos.
feedback-motion_coriolis_wrong = Nem todas as linhas de C q̇ estão certas.
feedback-motion_velocity_wrong = Nem todos os termos de Coriolis e centrífugos estão certos.
feedback-motion_skew_wrong = Com esta C, Ṁ − 2C não é antissimétrica. Os símbolos de Christoffel dão uma C com a qual o é.
feedback-motion_gravity_wrong = Nem todos os elementos de g estão certos.
feedback-motion_missing =
    { $what ->
        [mass] Falta a matriz de massa.
        [coriolis] Falta a matriz C.
        [skew] Sem a matriz C não há Ṁ − 2C.
        [velocity] Faltam os termos de Coriolis e centrífugos.
       *[gravity] Faltam os termos gravitacionais.
    }
feedback-motion_asymmetric = Uma matriz de massa é simétrica; esta não é.
feedback-motion_point_masses = Esta é a M de massas pontuais: faltam os momentos de inércia próprios dos elos.
feedback-motion_gravity_sign = Este g tem o sinal oposto: g é o que as juntas devem fazer contra a gravidade, o gradiente da energia potencial.
feedback-motion_velocity_sign = Este C q̇ tem o sinal oposto.
feedback-motion_coupling_once = Cada produto q̇j q̇k de duas juntas diferentes ocorre duas vezes em C q̇, como jk e como kj; aqui conta uma só vez.
feedback-motion_mass_rate = Isto é Ṁ q̇. É preciso subtrair o gradiente da energia cinética, ½ ∂(q̇ᵀM q̇)/∂q.
error-motion_row_count = A matriz tem uma linha para cada junta: { $expected }, não { $given }.
error-motion_empty = Escreva pelo menos uma das matrizes ou linhas pedidas.
error-motion_cell = Aqui escreve-se um número ou uma expressão; para uma posição ou momentos de inércia, três.
