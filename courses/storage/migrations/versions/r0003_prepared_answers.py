"""Answers that were made before, shared by all processes."""

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"


def upgrade() -> None:
    """Make the relation of figures and closed forms that were made before."""
    op.create_table(
        "prepared_answer",
        sa.Column("address", sa.Text(), nullable=False),
        sa.Column("content", sa.LargeBinary(), nullable=False),
        sa.Column("made", sa.DateTime(timezone=True), nullable=False),
        sa.PrimaryKeyConstraint("address", name=op.f("pk_prepared_answer")),
    )
    op.create_index(op.f("ix_prepared_answer_made"), "prepared_answer", ["made"])
