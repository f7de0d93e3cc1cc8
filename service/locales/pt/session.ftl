### Acessos a partir de uma disciplina e o que lê um estudante com sessão iniciada.

session-launch-title = A abrir o exercício
session-registration-title = Registo de uma plataforma de aprendizagem
session-new-window = Abrir numa janela nova
session-registered = O Framewise está registado em { $issuer }. Um administrador do Framewise ativa o registo; depois podem criar-se ligações.
session-registered-again = O Framewise está novamente registado em { $issuer }; as ligações funcionam como antes.
session-tool-description = Exercícios de cinemática de robôs: aceita-se qualquer escolha válida de referenciais e explicam-se as tabelas erradas.
session-heading = A sua sessão
session-signed-in = Sessão iniciada como { $name } · { $course }
session-attempts = Tentativas: { $made }
session-attempts-of = Tentativas: { $made } de { $allowed }
session-hand-in = Entregar
session-hand-in-ready = Entregar o que está pronto
session-counting = { $counting ->
    [first] Conta a primeira tentativa
   *[last] Conta a última tentativa
}
session-penalty = Cada tentativa adicional custa { $percent } do total de pontos
session-closes = Fecha: { $when }
session-grade =
    Contados: { $points } de { $total ->
        [one] { $total } ponto
       *[other] { $total } pontos
    }
session-gradebook = Para a pauta: { $percent }
session-no-more = Agora não se aceitam tentativas
session-back = Voltar à disciplina
session-received = A tentativa { $attempt } foi recebida e guardada. O resultado será mostrado mais tarde.
session-draft-other = É mostrado o que escreveu por último. Existe outra versão da sua resposta, de { $when }.
session-draft-take = Mostrar a outra versão
session-exercise-changed = O exercício foi alterado depois de uma tentativa anterior
session-attempt-then = A tentativa { $attempt } foi feita antes de o exercício ser alterado. O seu resultado refere-se ao exercício tal como era então.
session-exercise-then = Ver o exercício tal como era
session-opens = Abre: { $when }
session-late = Fechado: as tentativas já não contam
session-handed-in = entregue
session-attempts-kept = Ficam guardadas na sua disciplina.
session-attempts-latest = Aqui estão as últimas { $count }.
session-ended = A sua sessão terminou: as respostas que der aqui não contam. Volte a abrir o exercício a partir da sua disciplina; o que lá escreveu continua lá.
session-elsewhere = A sua disciplina pede outro exercício: as respostas a este não contam.
session-elsewhere-go = Abrir o exercício da disciplina
session-launch-by-hand = As plataformas de aprendizagem enviam os estudantes para aqui; por si só, este endereço não mostra nada. Abra o exercício a partir da sua disciplina.
