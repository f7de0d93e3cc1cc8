# Refusals of the HTTP service itself.

problem-title-400 = The request cannot be read
problem-title-404 = Not found
problem-title-405 = This method is not available here
problem-title-406 = No acceptable response format
problem-title-408 = The request took too long to arrive
problem-title-413 = The request is too large
problem-title-415 = This kind of body is not supported
problem-title-422 = The request cannot be carried out as it stands
problem-title-500 = The service failed
problem-title-503 = The service is busy

error-body_missing = The request has no body. Send a JSON object.
error-body_invalid = The body cannot be read. Send a JSON object in UTF-8.
error-json_not_utf8 = The body is not UTF-8, as JSON must be.
error-json_too_deep = The JSON document is nested too deeply.
error-json_not_finite = Line { $line }, column { $column }: a number must be finite. JSON has no NaN and no infinity.
error-json_invalid = The body is not JSON: line { $line }, column { $column }. The parser says: { $reason }.
error-json_duplicate_key = The key “{ $key }” appears twice in one object. Keep one of the two.
error-json_too_many_values = The body holds too much: at most { $limit } values, fields, lists or objects are read.
error-json_too_many_fields = An object of the body has { $given } fields; no call has more than { $limit }.
error-body_timed_out = The body did not arrive within { $seconds } s. Send it faster, or in smaller parts.
error-content_encoding_unsupported = Compressed bodies are not read. Send the body without Content-Encoding.
error-charset_unsupported = The body is declared as { $charset }. JSON is read as UTF-8 only.
error-media_type_unsupported =
    { $given ->
        [none] The request does not say what its body is.
       *[other] The body is declared as { $given }.
    } This call reads { $offers }: say so in the header Content-Type.
error-not_acceptable = This call answers in { $offers }; the Accept header allows none of these.
error-body_too_large =
    The body is larger than { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }, the most that this call reads.
error-method_not_allowed = This address supports { $allowed }, not { $method }.
error-address_unknown = There is nothing at { $path }. The document /api/v1/openapi.json lists every call.
error-problem_unknown = No refusal has the code { $code }.
error-internal_error = The service failed on this request. Report it with the id { $id }.
error-busy = The server is busy. Try again in { $seconds } s.

error-field_missing = The field “{ $field }” is missing.
error-field_unknown = There is no field “{ $field }” here. The fields are: { $allowed }.
error-target_or_position = Give exactly one of “target”, “targets” and “position”; with a position at most one of “quaternion” and “axis”.
error-table_or_robot = Give either “table” or “robot”, exactly one of them.
error-number_expected = “{ $field }” must be a number.
error-number_not_finite = “{ $field }” must be a finite number.
error-number_too_small =
    { $bound ->
        [excluded] The number must be greater than { $limit }.
       *[included] The number must be at least { $limit }.
    }
error-number_too_large =
    { $bound ->
        [excluded] The number must be less than { $limit }.
       *[included] The number must be at most { $limit }.
    }
error-integer_expected = “{ $field }” must be a whole number.
error-boolean_expected = “{ $field }” must be true or false.
error-string_expected = “{ $field }” must be text.
error-string_too_long =
    The text is too long: at most { $limit ->
        [one] one character is
       *[other] { $limit } characters are
    } read.
error-string_too_short =
    The text is too short: at least { $limit ->
        [one] one character is
       *[other] { $limit } characters are
    } needed.
error-string_pattern = The text does not have the expected form, { $pattern }.
error-list_expected = “{ $field }” must be a list.
error-list_too_long =
    The list is too long: it may have at most { $limit ->
        [one] one item
       *[other] { $limit } items
    }.
error-list_too_short =
    The list is too short: it needs at least { $limit ->
        [one] one item
       *[other] { $limit } items
    }.
error-object_expected = “{ $field }” must be an object with named fields.
error-body_not_object = The body must be a JSON object with named fields.
error-null_expected = “{ $field }” must be null or left out.
error-value_not_allowed = This must be one of: { $expected }.
error-value_invalid = This value cannot be used: { $reason }.

error-joints_wrong_dimensions = An array of joints has one or two dimensions, not { $dimensions }: (joints) or (configurations, joints).
error-batch_too_large = The batch has { $given } configurations; at most { $limit } are computed in one request.
error-query_missing = The joints came as npy; the rest of the request belongs, as JSON, in the query parameter “request”.
error-npy_header_invalid =
    The body is not an npy file as numpy.save writes it: { $rule ->
        [magic] it must begin with \x93NUMPY, a version and the length of the header
        [version] its version must be 1.0, 2.0 or 3.0
        [header] its header must be complete, at most 4096 bytes long, and name descr, fortran_order and shape
       *[shape] its shape must be a tuple of sizes that an array can have
    }.
error-npy_length_mismatch =
    The npy header declares { $promised ->
        [one] { $promised } byte
       *[other] { $promised } bytes
    } of data; { $present } follow it.
error-npy_object_refused = The npy file holds Python objects, which are never unpickled. Send an array of numbers.
error-npy_type_unsupported = The npy file holds { $type }. Send real numbers, such as float64 (<f8).
error-npy_one_part = An npy file holds one array. Name one part: { $allowed }.
error-one_source = Describe the robot in exactly one way: { $allowed }.

error-api_key_missing = The request names no key. Send it as Authorization: Bearer fwk_….
error-api_key_invalid = This key is not known here, has expired or was revoked.
error-api_key_scope = This key is for { $scopes }; the call needs { $needed }.
error-idempotency_key_length = An Idempotency-Key has 1 to { $limit } characters.
error-idempotency_key_in_use = A request with this Idempotency-Key is still being answered. Try again in a second.
error-idempotency_key_reused = This Idempotency-Key was used for another request. Use a new key for a new request.
error-rate_exceeded = The limit of { $limit } cost units per minute was exceeded. Try again in { $seconds } s.
error-setting_missing = The setting { $name } is missing.
problem-title-429 = Too many requests
error-quaternion_or_axis = Give at most one of “quaternion” and “axis”.

language-name = English
