"""Courses: people, links, attempts, drafts and grades, policies over time, statistics, and their storage.

Knows nothing of HTTP or LTI. A clock is handed in wherever time matters; policies are pure functions of what
was handed in and of that clock.

model            what a course is made of: people, links, attempts
policies         what attempts are worth, and whether another one is taken
enrolment        people and courses, as a launch tells of them
sessions         who is signed in
links, link_settings  what staff changes of a link
attempts, submissions  what was handed in is stored before it is answered
judged, regrading, settling  the judgement that counts, judging again, and what follows from it
gradebook, outbox  the counted score, and on its way to the platform
statistics, attempt_export  what lecturers see and take away
publications     published exercises, by content
prepared_answers  figures and closed forms made before
platforms        platforms and keys
administration, audit, privacy  who may do what, who did, and what people may ask for
storage          the database, opened and used in transactions; engines, its connections
turns            who writes next to an SQLite file
postgresql_connection  one that gives up where the server keeps silent
records, column_types  its relations
statements       what SQLite and PostgreSQL write alike
schema_history, migrations  its schema, step by step
backup           a copy, and back
secrets          secrets, tokens and one-time codes
refusals         what goes wrong
"""
