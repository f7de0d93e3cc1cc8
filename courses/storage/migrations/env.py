"""Where Alembic starts. The program migrates by `database.migrate`; this serves `alembic revision`."""

from alembic import context

from courses.storage.records import metadata

connection = context.config.attributes["connection"]
context.configure(connection=connection, target_metadata=metadata)
with context.begin_transaction():
    context.run_migrations()
