# Como as forças movem um robô.

error-links_count = A lista de elos tem uma entrada para cada linha da tabela: { $expected }, não { $given }.
error-mass_negative = Uma massa não é negativa: { $mass } kg.
error-inertia_not_symmetric = Uma matriz de inércia é simétrica: o elemento xy é igual ao yx.
error-inertia_negative = Um momento de inércia em torno de um eixo nunca é negativo. Esta matriz tem um negativo em torno de algum eixo.
error-mass_matrix_singular = Alguma junta não move nada que tenha massa, e nenhuma força determina a sua aceleração. Dê massa e inércia aos elos.
