# Como as forças movem um robô.

error-links_count = A lista de elos tem uma entrada para cada linha da tabela: { $expected }, não { $given }.
error-mass_negative = Uma massa não é negativa: { $mass } kg.
error-inertia_not_symmetric = Uma matriz de inércia é simétrica: o elemento xy é igual ao yx.
error-inertia_negative = Um momento de inércia em torno de um eixo nunca é negativo. Esta matriz tem um negativo em torno de algum eixo.
error-mass_matrix_singular = Alguma junta não move nada que tenha massa, e nenhuma força determina a sua aceleração. Dê massa e inércia aos elos.
error-links_missing = Indique a massa dos elos: links, uma entrada para cada linha da tabela.
error-name_of_rate = { $name } é o nome da velocidade de uma junta nas formas fechadas. Dê outro nome ao parâmetro.
error-body_varies = A massa de um elo e o seu lugar não mudam com as variáveis de junta: estas figuram só na tabela.
error-dynamics_not_finite = As massas, comprimentos ou velocidades são tão grandes que o resultado não é um número.
