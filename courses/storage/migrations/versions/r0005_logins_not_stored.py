"""Logins are carried by the browser: what anybody could fill is no longer there."""

from alembic import op

revision = "0005"
down_revision = "0004"


def upgrade() -> None:
    """Drop the logins under way; their launches are begun again."""
    op.drop_table("login")
