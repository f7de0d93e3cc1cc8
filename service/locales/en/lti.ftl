### Launches from a learning management system (LTI): what is refused, and why.

error-lti_parameter_missing = The learning platform sent no { $name }.
error-lti_platform_unknown = No platform { $issuer } is registered here. An administrator has to register it first.
error-lti_client_unknown = No client { $client } of the platform { $issuer } is registered here: the platform is, with another client id. An administrator has to register this one too.
error-lti_platform_ambiguous = Several clients of { $issuer } are registered; the login has to give client_id.
error-lti_platform_inactive = The platform { $issuer } is registered, but not active. An administrator has to activate it.
error-lti_target_foreign = The address to open is not on this site.
error-lti_state_unknown = This launch has been used already, or is too old. Open the exercise from your course again.
error-lti_browser_unknown = This launch was begun in another browser, or the browser blocks cookies in frames. Open it in a new window.
error-lti_launch_refused = The learning platform refused the launch: { $reason }.
error-lti_token_malformed = The launch message is not a signed token.
error-lti_token_algorithm = The launch message is signed with { $algorithm }; only RS256 is accepted.
error-lti_token_key = The launch message is signed with a key that the platform does not publish.
error-lti_token_signature = The signature of the launch message is wrong.
error-lti_token_expired = The launch message has expired. Check the clocks of both servers if this happens again.
error-lti_token_early = The launch message is from the future or too old. Check the clocks of both servers.
error-lti_claim_missing = The launch message lacks { $claim }.
error-lti_claim_wrong = The value of { $claim } in the launch message does not belong to this launch.
error-lti_nonce_used = This launch message has been used already. Open the exercise from your course again.
error-lti_deployment_unknown = The deployment { $deployment } of this platform is not known here. An administrator has to add it.
error-lti_address_refused = { $address } is not fetched: the service fetches only public https addresses and those that its operator trusts.
error-lti_unreachable = { $address } did not answer as expected: { $reason }.
error-lti_configuration_invalid = The platform’s configuration lacks a usable { $name }.
