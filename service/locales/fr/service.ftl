# Refus du service HTTP.

problem-title-400 = La requête ne peut pas être lue
problem-title-404 = Introuvable
problem-title-405 = Cette méthode n’est pas disponible ici
problem-title-406 = Aucun format de réponse acceptable
problem-title-408 = La requête a mis trop de temps à arriver
problem-title-413 = La requête est trop grande
problem-title-415 = Ce type de corps n’est pas pris en charge
problem-title-422 = La requête ne peut pas être exécutée telle quelle
problem-title-500 = Le service a échoué
problem-title-503 = Le service est occupé

error-body_missing = La requête n’a pas de corps. Envoyez un objet JSON.
error-body_invalid = Le corps ne peut pas être lu. Envoyez un objet JSON en UTF-8.
error-json_not_utf8 = Le corps n’est pas en UTF-8, comme JSON l’exige.
error-json_too_deep = Le document JSON est imbriqué trop profondément.
error-json_not_finite = Ligne { $line }, colonne { $column } : un nombre doit être fini. JSON n’a ni NaN ni infini.
error-json_invalid = Le corps n’est pas du JSON : ligne { $line }, colonne { $column }. L’analyseur dit : { $reason }.
error-json_duplicate_key = La clé « { $key } » figure deux fois dans un même objet. N’en gardez qu’une.
error-json_too_many_values = Le corps contient trop d’éléments : { $limit } valeurs, champs, listes ou objets au plus sont lus.
error-json_too_many_fields = Un objet du corps a { $given } champs ; aucun appel n’en a plus de { $limit }.
error-body_timed_out = Le corps n’est pas arrivé en { $seconds } s. Envoyez-le plus vite ou en parties plus petites.
error-content_encoding_unsupported = Les corps compressés ne sont pas lus. Envoyez le corps sans Content-Encoding.
error-charset_unsupported = Le corps est annoncé en { $charset }. JSON n’est lu qu’en UTF-8.
error-media_type_unsupported =
    { $given ->
        [none] La requête ne dit pas ce qu’est son corps.
       *[other] Le corps est annoncé comme { $given }.
    } Cet appel lit { $offers } : indiquez-le dans l’en-tête Content-Type.
error-not_acceptable = Cet appel répond en { $offers } ; l’en-tête Accept exclut tout cela.
error-body_too_large =
    Le corps dépasse { $limit ->
        [one] { $limit } octet
       *[other] { $limit } octets
    }, le maximum que lit cet appel.
error-method_not_allowed = Cette adresse accepte { $allowed }, mais pas { $method }.
error-address_unknown = Il n’y a rien à { $path }. Le document /api/v1/openapi.json énumère tous les appels.
error-problem_unknown = Aucun refus n’a le code { $code }.
error-internal_error = Le service a échoué sur cette requête. Signalez-le avec l’identifiant { $id }.
error-busy = Le serveur est occupé. Réessayez dans { $seconds } s.

error-field_missing = Le champ « { $field } » manque.
error-field_unknown = Il n’y a pas ici de champ « { $field } ». Les champs sont : { $allowed }.
error-target_or_position = Donnez exactement l’un de « target », « targets » et « position » ; avec une position, au plus l’un de « quaternion » et « axis ».
error-table_or_robot = Donnez soit « table », soit « robot » : exactement l’un des deux.
error-number_expected = « { $field } » doit être un nombre.
error-number_not_finite = « { $field } » doit être un nombre fini.
error-number_too_small =
    { $bound ->
        [excluded] Le nombre doit être supérieur à { $limit }.
       *[included] Le nombre doit être au moins { $limit }.
    }
error-number_too_large =
    { $bound ->
        [excluded] Le nombre doit être inférieur à { $limit }.
       *[included] Le nombre doit être au plus { $limit }.
    }
error-integer_expected = « { $field } » doit être un nombre entier.
error-boolean_expected = « { $field } » doit être true ou false.
error-string_expected = « { $field } » doit être du texte.
error-string_too_long =
    Le texte est trop long : au plus { $limit ->
        [1] un caractère est lu
       *[other] { $limit } caractères sont lus
    }.
error-string_too_short =
    Le texte est trop court : il faut au moins { $limit ->
        [1] un caractère
       *[other] { $limit } caractères
    }.
error-string_pattern = Le texte n’a pas la forme attendue, { $pattern }.
error-list_expected = « { $field } » doit être une liste.
error-list_too_long =
    La liste est trop longue : elle peut avoir au plus { $limit ->
        [1] un élément
       *[other] { $limit } éléments
    }.
error-list_too_short =
    La liste est trop courte : il lui faut au moins { $limit ->
        [1] un élément
       *[other] { $limit } éléments
    }.
error-object_expected = « { $field } » doit être un objet à champs nommés.
error-body_not_object = Le corps doit être un objet JSON à champs nommés.
error-null_expected = « { $field } » doit être null ou absent.
error-value_not_allowed = La valeur doit être l’une de celles-ci : { $expected }.
error-value_invalid = Cette valeur ne peut pas être utilisée : { $reason }.

error-joints_wrong_dimensions = Un tableau de variables articulaires a une ou deux dimensions, pas { $dimensions } : (articulations) ou (configurations, articulations).
error-batch_too_large = Le lot compte { $given } configurations ; une requête en calcule au plus { $limit }.
error-query_missing = Les variables articulaires sont venues en npy ; le reste de la requête va, en JSON, dans le paramètre d’URL « request ».
error-npy_header_invalid =
    Le corps n’est pas un fichier npy tel que numpy.save l’écrit : { $rule ->
        [magic] il doit commencer par \x93NUMPY, une version et la longueur de l’en-tête
        [version] sa version doit être 1.0, 2.0 ou 3.0
        [header] son en-tête doit être complet, compter au plus 4096 octets et nommer descr, fortran_order et shape
       *[shape] shape doit être un n-uplet de dimensions qu’un tableau peut avoir
    }.
error-npy_length_mismatch =
    L’en-tête npy promet { $promised ->
        [one] { $promised } octet
       *[other] { $promised } octets
    } de données ; il en suit { $present }.
error-npy_object_refused = Le fichier npy contient des objets Python, qui ne sont jamais désérialisés. Envoyez un tableau de nombres.
error-npy_type_unsupported = Le fichier npy contient { $type }. Envoyez des nombres réels, par exemple float64 (<f8).
error-npy_one_part = Un fichier npy contient un seul tableau. Nommez une partie : { $allowed }.
error-one_source = Décrivez le robot d’une seule manière : { $allowed }.

error-api_key_missing = La requête n’indique aucune clé. Envoyez-la sous la forme Authorization: Bearer fwk_….
error-api_key_invalid = Cette clé est inconnue ici, a expiré ou a été révoquée.
error-api_key_scope = Cette clé sert à { $scopes } ; l’appel demande { $needed }.
error-idempotency_key_length = Une Idempotency-Key compte de 1 à { $limit } caractères.
error-idempotency_key_in_use = Une requête portant cette Idempotency-Key est encore en cours. Réessayez dans une seconde.
error-idempotency_key_reused = Cette Idempotency-Key a déjà servi pour une autre requête. Prenez une nouvelle clé pour une nouvelle requête.
error-rate_exceeded = La limite de { $limit } unités de coût par minute a été dépassée. Réessayez dans { $seconds } s.
error-setting_missing = Le réglage { $name } manque.
problem-title-429 = Trop de requêtes
error-quaternion_or_axis = Donnez au plus l’un de « quaternion » et « axis ».

language-name = Français
