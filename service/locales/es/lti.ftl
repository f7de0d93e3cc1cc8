### Accesos desde un sistema de gestión del aprendizaje (LTI): qué se rechaza y por qué.

error-lti_parameter_missing = La plataforma de aprendizaje no envió { $name }.
error-lti_platform_unknown = Aquí no está registrada ninguna plataforma { $issuer }. Un administrador tiene que registrarla primero.
error-lti_client_unknown = Aquí no está registrado ningún cliente { $client } de la plataforma { $issuer }: la plataforma lo está, con otro identificador de cliente. Un administrador tiene que registrar también este.
error-lti_platform_ambiguous = Hay varios clientes de { $issuer } registrados; el inicio de sesión debe indicar client_id.
error-lti_platform_inactive = La plataforma { $issuer } está registrada, pero no activa. Un administrador tiene que activarla.
error-lti_target_foreign = La dirección que se quiere abrir no está en este sitio.
error-lti_state_unknown = Este acceso ya se ha usado o es demasiado antiguo. Vuelva a abrir el ejercicio desde su curso.
error-lti_browser_unknown = Este acceso se inició en otro navegador, o el navegador bloquea las cookies en los marcos. Ábralo en una ventana nueva.
error-lti_launch_refused = La plataforma de aprendizaje rechazó el acceso: { $reason }.
error-lti_token_malformed = El mensaje de acceso no es un token firmado.
error-lti_token_algorithm = El mensaje de acceso está firmado con { $algorithm }; solo se acepta RS256.
error-lti_token_key = El mensaje de acceso está firmado con una clave que la plataforma no publica.
error-lti_token_signature = La firma del mensaje de acceso es incorrecta.
error-lti_token_expired = El mensaje de acceso ha caducado. Si vuelve a ocurrir, compruebe los relojes de ambos servidores.
error-lti_token_early = El mensaje de acceso viene del futuro o es demasiado antiguo. Compruebe los relojes de ambos servidores.
error-lti_claim_missing = Al mensaje de acceso le falta { $claim }.
error-lti_claim_wrong = El mensaje de acceso tiene un { $claim } que no corresponde a este acceso.
error-lti_nonce_used = Este mensaje de acceso ya se ha usado. Vuelva a abrir el ejercicio desde su curso.
error-lti_deployment_unknown = Aquí no se conoce el despliegue { $deployment } de esta plataforma. Un administrador tiene que añadirlo.
error-lti_address_refused = { $address } no se consulta: solo se consultan direcciones https públicas y aquellas en las que confía el operador.
error-lti_unreachable = { $address } no respondió como se esperaba: { $reason }.
error-lti_configuration_invalid = A la configuración de la plataforma le falta un { $name } utilizable.
