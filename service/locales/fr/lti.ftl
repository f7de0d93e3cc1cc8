### Lancements depuis une plateforme d’apprentissage (LTI) : ce qui est refusé, et pourquoi.

error-lti_parameter_missing = La plateforme d’apprentissage n’a pas envoyé { $name }.
error-lti_platform_unknown = Aucune plateforme { $issuer } n’est enregistrée ici. Un administrateur doit d’abord l’enregistrer.
error-lti_client_unknown = Aucun client { $client } de la plateforme { $issuer } n’est enregistré ici : la plateforme l’est, avec un autre identifiant de client. Un administrateur doit enregistrer celui-ci aussi.
error-lti_platform_ambiguous = Plusieurs clients de { $issuer } sont enregistrés ; la connexion doit indiquer client_id.
error-lti_platform_inactive = La plateforme { $issuer } est enregistrée, mais pas active. Un administrateur doit l’activer.
error-lti_target_foreign = L’adresse à ouvrir n’est pas sur ce site.
error-lti_state_unknown = Ce lancement a déjà servi ou est trop ancien. Rouvrez l’exercice depuis votre cours.
error-lti_browser_unknown = Ce lancement a commencé dans un autre navigateur, ou le navigateur bloque les cookies dans les cadres. Ouvrez-le dans une nouvelle fenêtre.
error-lti_launch_refused = La plateforme d’apprentissage a refusé le lancement : { $reason }.
error-lti_token_malformed = Le message de lancement n’est pas un jeton signé.
error-lti_token_algorithm = Le message de lancement est signé avec { $algorithm } ; seul RS256 est accepté.
error-lti_token_key = Le message de lancement est signé avec une clé que la plateforme ne publie pas.
error-lti_token_signature = La signature du message de lancement est fausse.
error-lti_token_expired = Le message de lancement a expiré. Si cela se reproduit, vérifiez les horloges des deux serveurs.
error-lti_token_early = Le message de lancement vient du futur ou est trop ancien. Vérifiez les horloges des deux serveurs.
error-lti_claim_missing = Il manque { $claim } au message de lancement.
error-lti_claim_wrong = Le message de lancement contient un { $claim } qui n’est pas celui de ce lancement.
error-lti_nonce_used = Ce message de lancement a déjà servi. Rouvrez l’exercice depuis votre cours.
error-lti_deployment_unknown = Le déploiement { $deployment } de cette plateforme n’est pas connu ici. Un administrateur doit l’ajouter.
error-lti_address_refused = { $address } n’est pas consultée : seules sont consultées les adresses https publiques et celles auxquelles l’exploitant fait confiance.
error-lti_unreachable = { $address } n’a pas répondu comme attendu : { $reason }.
error-lti_configuration_invalid = Il manque un { $name } utilisable à la configuration de la plateforme.
