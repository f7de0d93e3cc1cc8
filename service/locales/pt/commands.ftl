### O que a autoverificação de um exercício diz ao seu autor.

check-counts = { $exercise }: { $passed ->
    [one] { $passed } verificação passou
   *[other] { $passed } verificações passaram
}, { $failed ->
    [one] { $failed } falhou
   *[other] { $failed } falharam
}, { $warnings ->
    [one] { $warnings } aviso
   *[other] { $warnings } avisos
}
check-structure = A semente { $seed } altera a estrutura do robô.
check-drawn_structure = O sorteio pode dar { $name } = { $value }, o que altera a estrutura do robô. Exclua esse valor (without) ou escolha outro intervalo.
check-figure = Semente { $seed }: não é possível desenhar a figura ({ $reason }).
check-right = Uma tabela certa é rejeitada: { $table }
check-certificate = O certificado de uma tabela certa não se verifica: { $table }
check-harmless = Uma tabela errada é aceite: { $table }
check-mistake = O erro { $mistake } não é explicado em { $table }
check-part = Semente { $seed }: uma resposta certa à parte { $part } é rejeitada.
check-follow_through = Semente { $seed }: o que decorre de uma tabela errada não pontua na parte { $part }.
check-wrong_part = Semente { $seed }: uma resposta errada à parte { $part } não é explicada como { $mistake }, mas como { $told }.
check-invalid = Uma tabela mal formada é avaliada: { $name }.
check-sample = O exemplo “{ $name }” não é julgado como esperado; o veredicto é: { $told }.
check-rounded = Uma tabela certa arredondada a { $digits } algarismos é rejeitada com a regra de ferramenta { $rule }: { $table }
check-tool_rule = Uma tabela certa é rejeitada com a regra de ferramenta { $rule }: { $table }
check-crash = Semente { $seed }: a avaliação falha: { $reason }
check-unneeded = Nenhuma resposta certa precisa de { $name }: o estudante pode escolher referenciais em que não aparece. { $rules ->
    [none] Nenhuma regra o muda: retire-o do enunciado.
   *[other] Se a resposta o deve conter, basta qualquer uma destas regras: { $rules }. Caso contrário, retire-o do enunciado.
}
check-alike = Alguns estudantes podem trocar { $name } e { $other } em números sem que se note: diferem em 1 % no máximo. Escolha valores ou intervalos mais afastados.
check-taken_by_slide = Na linha da junta { $joint }, { $name } sob d é a variável de junta, não a dimensão. Quem escolher referenciais em que a dimensão aparece aí não a poderá escrever. Dê-lhe outro nome.
check-taken_by_short_form = Onde a resposta é uma fórmula, { $name } é um cosseno ou um seno, não a dimensão. Dê-lhe outro nome.
check-no_joints = O robô não tem nenhuma junta: não há nada a descrever. Ponha uma numa linha da tabela.
check-nothing_earned = Nenhuma tabela errada recebe pontos: nada do que uma tabela de zeros descreve mal neste robô tem peso. Mude os pesos ou fixe mais regras.
check-asked_as_shown = A parte { $kind } mostra o que pede. Peça outra coisa ou mostre-a noutra forma.
check-gravity_not_down = Na figura, a aceleração da gravidade dada na parte { $kind } não aponta para baixo. Rode o referencial 0 com upright ou altere gravity.
check-frames_coincide = Na figura da parte { $kind }, dois referenciais têm a mesma origem porque uma junta prismática entre eles está desenhada em zero. Dê-lhe outro valor em posture.
check-limits_ambiguous = A resposta à parte { $kind } depende do sentido em que cresce a variável de uma junta com limites, que se escolhe livremente. Fixe os sentidos (figure) ou escolha limites para os quais isso seja indiferente.
warm-counts = { $exercise }: conjuntos de valores verificados e desenhados: { $values }, figuras: { $figures }, formas fechadas: { $forms }, falhas: { $failed }, { $seconds } s
error-nothing_to_warm = Não há exercício, nem disciplina com ligações, chamado { $name }.
error-variants_set = O número de variantes de { $name } está definido no exercício ou nas regras das ligações da disciplina. Omita --variants.
