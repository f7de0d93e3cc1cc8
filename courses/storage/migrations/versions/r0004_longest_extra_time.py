"""The longest extra time of a link, found without going through all of its students."""

from alembic import op

revision = "0004"
down_revision = "0003"


def upgrade() -> None:
    """Make the index in which it stands at the end."""
    columns = ["link_id", "extra_seconds"]
    op.create_index(op.f("ix_participation_link_id_extra_seconds"), "participation", columns)
