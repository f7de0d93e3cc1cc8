### Lansări dintr-o platformă de învățare (LTI): ce se refuză și de ce.

error-lti_parameter_missing = Platforma de învățare nu a trimis { $name }.
error-lti_platform_unknown = Aici nu este înregistrată nicio platformă { $issuer }. Un administrator trebuie mai întâi să o înregistreze.
error-lti_client_unknown = Aici nu este înregistrat niciun client { $client } al platformei { $issuer }: platforma este, cu alt identificator de client. Un administrator trebuie să îl înregistreze și pe acesta.
error-lti_platform_ambiguous = Sunt înregistrați mai mulți clienți ai { $issuer }; autentificarea trebuie să indice client_id.
error-lti_platform_inactive = Platforma { $issuer } este înregistrată, dar nu este activă. Un administrator trebuie să o activeze.
error-lti_target_foreign = Adresa de deschis nu este pe acest site.
error-lti_state_unknown = Această lansare a fost deja folosită sau este prea veche. Deschideți din nou exercițiul din cursul dumneavoastră.
error-lti_browser_unknown = Această lansare a început în alt browser sau browserul blochează cookie-urile în cadre. Deschideți-o într-o fereastră nouă.
error-lti_launch_refused = Platforma de învățare a refuzat lansarea: { $reason }.
error-lti_token_malformed = Mesajul de lansare nu este un token semnat.
error-lti_token_algorithm = Mesajul de lansare este semnat cu { $algorithm }; se acceptă numai RS256.
error-lti_token_key = Mesajul de lansare este semnat cu o cheie pe care platforma nu o publică.
error-lti_token_signature = Semnătura mesajului de lansare este greșită.
error-lti_token_expired = Mesajul de lansare a expirat. Dacă se repetă, verificați ceasurile ambelor servere.
error-lti_token_early = Mesajul de lansare vine din viitor sau este prea vechi. Verificați ceasurile ambelor servere.
error-lti_claim_missing = Din mesajul de lansare lipsește { $claim }.
error-lti_claim_wrong = Valoarea { $claim } din mesajul de lansare nu corespunde acestei lansări.
error-lti_nonce_used = Acest mesaj de lansare a fost deja folosit. Deschideți din nou exercițiul din cursul dumneavoastră.
error-lti_deployment_unknown = Instalarea { $deployment } a acestei platforme nu este cunoscută aici. Un administrator trebuie să o adauge.
error-lti_address_refused = { $address } nu se accesează: se accesează numai adresele https publice și cele în care operatorul are încredere.
error-lti_unreachable = { $address } nu a răspuns cum era de așteptat: { $reason }.
error-lti_configuration_invalid = Configurației platformei îi lipsește un { $name } utilizabil.
