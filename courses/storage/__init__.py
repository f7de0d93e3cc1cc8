"""The database, SQLite or PostgreSQL: what was acknowledged survives the end of the process, however it ends.

database         opened under a lock, brought to this program's schema, used in transactions
engines          its connections: how they are opened and checked, how a transaction begins
turns            who writes next to an SQLite file
troubles         which errors are the database's own, and pass
postgresql_connection  one that gives up where the server keeps silent
records, column_types  its relations, the same for both
statements       what both write alike
schema_history, migrations  the schema, step by step
backup           a copy of all rows, and back
prepared_answers  figures and closed forms made before: a cache that processes share
"""
