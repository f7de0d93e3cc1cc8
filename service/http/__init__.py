"""What is HTTP's own: routes, strict decoding, refusals, negotiation, compression, middleware."""
