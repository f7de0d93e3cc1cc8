### Запуски із системи керування навчанням (LTI): що відхиляється і чому.

error-lti_parameter_missing = Навчальна платформа не надіслала { $name }.
error-lti_platform_unknown = Платформу { $issuer } тут не зареєстровано. Спершу її має зареєструвати адміністратор.
error-lti_platform_ambiguous = Зареєстровано кілька клієнтів { $issuer }; вхід має називати client_id.
error-lti_platform_inactive = Платформу { $issuer } зареєстровано, але ще не активовано.
error-lti_target_foreign = Адреса, яку треба відкрити, не належить цьому сайту.
error-lti_state_unknown = Цей запуск уже використано або він застарів. Відкрийте вправу з курсу ще раз.
error-lti_browser_unknown = Цей запуск почато в іншому браузері, або браузер блокує файли cookie у фреймах. Відкрийте його в новому вікні.
error-lti_launch_refused = Навчальна платформа відхилила запуск: { $reason }.
error-lti_token_malformed = Повідомлення запуску не є підписаним токеном.
error-lti_token_algorithm = Повідомлення запуску підписано алгоритмом { $algorithm }; приймається лише RS256.
error-lti_token_key = Повідомлення запуску підписано ключем, якого платформа не публікує.
error-lti_token_signature = Підпис повідомлення запуску неправильний.
error-lti_token_expired = Термін дії повідомлення запуску минув. Якщо це повториться, перевірте годинники обох серверів.
error-lti_token_early = Повідомлення запуску з майбутнього або застаріле. Перевірте годинники обох серверів.
error-lti_claim_missing = У повідомленні запуску бракує { $claim }.
error-lti_claim_wrong = У повідомленні запуску { $claim } не належить до цього запуску.
error-lti_nonce_used = Це повідомлення запуску вже використано. Відкрийте вправу з курсу ще раз.
error-lti_deployment_unknown = Розгортання { $deployment } цієї платформи тут невідоме. Його додає адміністратор.
error-lti_address_refused = { $address } не запитується: запитуються лише загальнодоступні адреси https і ті, яким довіряє оператор.
error-lti_unreachable = { $address } відповіла не так, як очікувалося: { $reason }.
error-lti_configuration_invalid = У конфігурації платформи бракує придатного { $name }.
