# Ficheiros do catálogo de robôs.

error-catalogue_not_toml = Isto não é TOML: { $reason }.
error-catalogue_key_missing = Falta { $key }.
error-catalogue_key_unknown = { $key } não é uma chave conhecida. As chaves conhecidas são { $known }.
error-catalogue_value_type = { $key } deve ser { expected-value }.
error-catalogue_limits_reversed = Junta { $joint }: o limite inferior deve ser menor do que o superior.
error-catalogue_outside_limits = A junta { $joint } desta configuração está fora dos seus limites.
error-robot_unknown = O catálogo não contém o robô { $robot }. Contém { $known }.
expected-value = { $expected ->
    [text] um texto não vazio
    [texts] uma lista de textos
    [number] um número cujo módulo é no máximo 10^15
    [integer] um número inteiro
    [count] um número inteiro não inferior a 1
    [flag] true ou false
    [table] uma tabela
    [tables] uma lista de tabelas
    [cell] um número ou uma expressão
    [cells] uma lista de { $count } números ou expressões
    [choice] um destes valores: { $known }
    [direction] uma lista de três números não todos nulos
    [point_names] uma lista de { $count } nomes de pontos
    [point_chains] uma lista de listas de pelo menos dois nomes de pontos
    [help_levels] uma lista com pelo menos um nível de ajuda
    [numbers] { $count ->
        [0] uma lista de números finitos
       *[other] uma lista de { $count } números finitos
    }
    [rows] { $count ->
        [0] uma lista de listas de { $width } elementos
       *[other] uma lista de { $count } listas de { $width } elementos
    }
   *[other] de outro tipo
}
