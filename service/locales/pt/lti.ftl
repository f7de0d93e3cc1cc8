### Acessos a partir de uma plataforma de ensino (LTI): o que é recusado e porquê.

error-lti_parameter_missing = A plataforma de aprendizagem não enviou { $name }.
error-lti_platform_unknown = Nenhuma plataforma { $issuer } está registada aqui. Um administrador tem de a registar primeiro.
error-lti_client_unknown = Nenhum cliente { $client } da plataforma { $issuer } está registado aqui: a plataforma está, com outro identificador de cliente. Um administrador tem de registar também este.
error-lti_platform_ambiguous = Estão registados vários clientes de { $issuer }; o início de sessão tem de indicar client_id.
error-lti_platform_inactive = A plataforma { $issuer } está registada, mas não ativa. Um administrador tem de a ativar.
error-lti_target_foreign = O endereço a abrir não é deste site.
error-lti_state_unknown = Este acesso já foi usado ou é demasiado antigo. Volte a abrir o exercício a partir da sua disciplina.
error-lti_browser_unknown = Este acesso começou noutro navegador, ou o navegador bloqueia os cookies em molduras. Abra-o numa janela nova.
error-lti_launch_refused = A plataforma de aprendizagem recusou o acesso: { $reason }.
error-lti_token_malformed = A mensagem de acesso não é um token assinado.
error-lti_token_algorithm = A mensagem de acesso está assinada com { $algorithm }; só RS256 é aceite.
error-lti_token_key = A mensagem de acesso está assinada com uma chave que a plataforma não publica.
error-lti_token_signature = A assinatura da mensagem de acesso está errada.
error-lti_token_expired = A mensagem de acesso expirou. Se voltar a acontecer, verifique os relógios dos dois servidores.
error-lti_token_early = A mensagem de acesso vem do futuro ou é demasiado antiga. Verifique os relógios dos dois servidores.
error-lti_claim_missing = Falta { $claim } na mensagem de acesso.
error-lti_claim_wrong = O valor de { $claim } na mensagem de acesso não corresponde a este acesso.
error-lti_nonce_used = Esta mensagem de acesso já foi usada. Volte a abrir o exercício a partir da sua disciplina.
error-lti_deployment_unknown = A implantação { $deployment } desta plataforma não é conhecida aqui. Um administrador tem de a acrescentar.
error-lti_address_refused = { $address } não é consultado: só são consultados endereços https públicos e aqueles em que o operador confia.
error-lti_unreachable = { $address } não respondeu como esperado: { $reason }.
error-lti_configuration_invalid = Falta à configuração da plataforma um { $name } utilizável.
