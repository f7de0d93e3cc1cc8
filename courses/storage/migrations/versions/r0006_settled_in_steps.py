"""A regrading that counts is settled for a few students at a time, and notes how far that has come."""

import sqlalchemy as sa
from alembic import op

revision = "0006"
down_revision = "0005"


def upgrade() -> None:
    """Add the student from whom on a run is unsettled; those applied before are settled."""
    op.add_column("regrading", sa.Column("unsettled_from", sa.Integer))
