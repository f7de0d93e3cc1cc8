### Disciplinas, tentativas guardadas e acessos a partir de uma plataforma de ensino: o que é recusado e porquê.

problem-title-401 = Sem sessão iniciada
problem-title-403 = Sem acesso
problem-title-409 = Agora não é possível

## Armazenamento

error-storage_folder = A pasta de dados { $folder } não pode ser usada: { $reason }. Indique em FRAMEWISE_DATA_FOLDER uma pasta onde se possa escrever, ou ponha FRAMEWISE_STORAGE em off.
error-storage_address = FRAMEWISE_DATABASE_URL não designa uma base de dados PostgreSQL. Tem a forma postgresql://utilizador:palavra-passe@servidor/base.
error-storage_unusable = A base de dados { $location } não pode ser usada: { $reason }.
error-storage_unavailable = A base de dados não responde neste momento. O que já foi confirmado está a salvo. Envie de novo dentro de alguns segundos.
error-storage_missing = Não há nenhuma base de dados em { $location }. FRAMEWISE_DATA_FOLDER ou FRAMEWISE_DATABASE_URL deve indicar a do serviço.
error-schema_newer = Os dados foram escritos por uma versão mais recente do programa (esquema { $found }; esta versão conhece { $known }). Instale a versão mais recente.
error-storage_not_empty = Uma cópia de segurança só é reposta numa base de dados vazia; a relação { $table } já contém linhas.
error-backup_unreadable = { $file } não pode ser lido nem escrito como cópia de segurança: { $reason }.

## Tentativas

error-record_unknown = { $kind ->
    [attempt] Não existe essa tentativa nesta disciplina.
    [person] Não existe essa pessoa nesta disciplina.
    [anybody] Não existe essa pessoa aqui.
    [several] Vários pseudónimos começam assim. Indique mais caracteres; uma exportação mostra-o completo.
    [link] Não existe essa ligação nesta disciplina.
    [platform] Não existe essa plataforma.
    [course] Não existe essa disciplina.
   *[other] Não existe esse registo nesta disciplina.
}
error-attempts_not_open = As tentativas são aceites a partir de { TIME($opens) } UTC.
error-attempts_closed = O exercício fechou em { TIME($closes) } UTC.
error-attempts_used = { $allowed ->
    [one] A única tentativa que este exercício permite já foi feita.
   *[other] Já foram feitas as { $allowed } tentativas que este exercício permite.
}
error-exercise_changed = O exercício foi alterado depois de ter aberto esta página e nada foi entregue. Recarregue a página: o que escreveu continua lá.
error-settings_changed = As suas alterações não foram guardadas: outra pessoa guardou outras regras depois de ter aberto esta página. Recarregue a página e veja-as.
error-regrading_outdated = Nada foi aplicado: o exercício ou as regras da ligação mudaram desde que estas classificações foram calculadas, ou foram aplicadas outras. Volte a classificar.
error-scores_unsent = { $count ->
    [one] Nada foi eliminado: a pauta não recebeu { $count } classificação desta disciplina. Veja o que a retém; para a perder, acrescente --with-unsent.
   *[other] Nada foi eliminado: a pauta não recebeu { $count } classificações desta disciplina. Veja o que as retém; para as perder, acrescente --with-unsent.
}
error-setting_invalid = { $name } pode ser: { $known }.
error-closes_before_opening = O exercício fecharia antes de abrir.
error-session_expired = A sua sessão terminou. O que escreveu continua aqui: volte a abrir o exercício a partir da sua disciplina.
error-administrator_unknown = Esta página abre-se com um endereço que framewise lti administer mostra. O endereço só funciona uma vez, nos dez minutos seguintes; a sessão dura duas horas.
error-code_used = Este endereço já foi usado. Volte a abrir o exercício a partir da sua disciplina.
error-staff_only = Isto está aberto aos docentes da disciplina.
error-publishing_closed =
    { $who ->
        [staff] Aqui só pode publicar exercícios quem vem de uma disciplina como docente, ou com uma chave de âmbito publish.
        [key] Aqui só se podem publicar exercícios com uma chave de âmbito publish.
       *[nobody] Neste serviço ninguém pode publicar exercícios.
    }
error-link_without_exercise = Ainda não foi escolhido um exercício para esta ligação. Um docente escolhe-o ao abrir a ligação.
error-invitation_used = Este endereço de registo já foi usado ou é demasiado antigo. Peça um novo.
error-storage_off = Esta instalação não guarda disciplinas: o seu armazenamento está desligado.
error-posted_form_too_large =
    O formulário tem mais de { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-form_invalid = O corpo não é um formulário (application/x-www-form-urlencoded).
