"""What is HTTP's own: routes, strict decoding, refusals, negotiation, compression, middleware.

Reading:
  connections, uploads  limits on what a caller may leave undone
  routing, calls   routes that read their requests strictly, and calls that are functions
  decoding, long_lists, json_faults  JSON, long lists in it, and what is wrong with it
  npy, forms       arrays, forms
  validation       findings of pydantic as faults
  negotiation, languages  media type and language of the answer
  idempotency      a POST that is sent again
  arrival_tickets  when an answer came that is sent again
Who calls:
  addresses        whom an address is counted for
  api_keys         keys of programs
  link_context, link_guard  what students of a link may use
  metering, cost_window  what callers may cost, and have
Answering:
  problems, shortages  the one table of statuses, and what the machine lacks just now
  problem_documents, problem_answers  the problem document, and a refusal that is answered with it
  compression      large answers
  middleware       the outermost layer
  tracing          traces of requests
  openapi          the document of the API
"""
