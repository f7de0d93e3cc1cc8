"""Where Alembic starts. The program migrates by `courses.storage.migrate`; this serves `alembic revision`."""

from alembic import context

from courses.records import metadata

connection = context.config.attributes["connection"]
context.configure(connection=connection, target_metadata=metadata)
with context.begin_transaction():
    context.run_migrations()
