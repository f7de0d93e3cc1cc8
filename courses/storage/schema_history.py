"""The history of the schema, applied; loaded only where something is to be applied, since it takes 9 MB."""

import sqlalchemy as sa
from alembic.config import Config
from alembic.runtime.environment import EnvironmentContext
from alembic.script import ScriptDirectory

from courses.refusals import StorageError
from courses.storage.database import MIGRATIONS, revision_in
from courses.storage.records import metadata
from kinematics.errors import Fault


def advance(connection: sa.Connection, target: str) -> None:
    """Apply what the database lacks of the history.

    Raises:
        StorageError: the database's schema is not in this program's history.
    """
    config = Config()
    config.set_main_option("script_location", str(MIGRATIONS))
    config.set_main_option("path_separator", "os")
    scripts = ScriptDirectory.from_config(config)
    current = revision_in(connection)
    if current and current not in {script.revision for script in scripts.walk_revisions()}:
        raise StorageError(Fault.at("schema_newer", found=current, known=scripts.get_current_head() or ""))
    with EnvironmentContext(
        config, scripts, fn=lambda revision, _: scripts._upgrade_revs(target, revision)
    ) as environment:
        environment.configure(connection=connection, target_metadata=metadata)
        environment.run_migrations()
