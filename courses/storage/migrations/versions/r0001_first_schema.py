"""The first schema."""

from typing import Any

import sqlalchemy as sa
from alembic import op
from sqlalchemy.types import TypeEngine

revision = "0001"
down_revision = None

_TIME = sa.DateTime(timezone=True)
_JSON_OR_NULL = sa.JSON(none_as_null=True)


def upgrade() -> None:
    """Make every relation; `courses.storage.records` says how constraints and indexes are named."""
    _platforms()
    _courses()
    _attempts()
    _scores()


def _platforms() -> None:
    op.create_table(
        "access",
        _id(),
        *_times("at", index=True),
        *_texts("actor", "action"),
        *_texts("subject", nullable=True, index=True),
        *_integers("link_id", nullable=True),
        sa.Column("details", sa.JSON, nullable=False),
    )
    op.create_table(
        "one_time_code",
        *_texts("code_hash", primary_key=True),
        *_texts("purpose"),
        sa.Column("content", sa.JSON, nullable=False),
        *_times("expires", index=True),
    )
    op.create_table(
        "platform",
        _id(),
        *_texts("issuer", "client_id", "name", "authorization_endpoint", "token_endpoint"),
        *_texts("token_audience", nullable=True),
        *_texts("jwks_uri"),
        sa.Column("origins", sa.JSON, nullable=False),
        sa.Column("names_shared", sa.Boolean, nullable=False),
        *_texts("status"),
        *_times("created"),
        sa.UniqueConstraint("issuer", "client_id"),
    )
    op.create_table(
        "registration",
        _id(),
        *_texts("secret_hash", unique=True),
        *_texts("note"),
        *_times("created", "expires"),
        *_times("used_at", nullable=True),
    )
    op.create_table("secret", *_texts("name", primary_key=True), *_texts("value"))
    op.create_table(
        "tool_key", *_texts("kid", primary_key=True), *_texts("private"), *_times("created", "signs_from")
    )


def _courses() -> None:
    op.create_table(
        "course",
        _id(),
        _to("platform"),
        *_texts("deployment", "context", "title"),
        *_texts("memberships_url", nullable=True),
        sa.UniqueConstraint("platform_id", "deployment", "context"),
    )
    op.create_table("deployment", _to("platform", primary_key=True), *_texts("deployment", primary_key=True))
    op.create_table(
        "login",
        *_texts("state_hash", primary_key=True),
        _to("platform"),
        *_texts("nonce", "browser_hash", "target"),
        sa.Column("request", sa.JSON, nullable=False),
        *_times("expires", index=True),
    )
    op.create_table(
        "nonce",
        _to("platform", primary_key=True),
        *_texts("nonce", primary_key=True),
        *_times("expires", index=True),
    )
    op.create_table(
        "person",
        _id(),
        _to("platform"),
        *_texts("key", unique=True),
        *_texts("subject", "name", nullable=True),
        *_times("created", "seen"),
    )
    op.create_table(
        "link",
        _id(),
        _to("course"),
        *_texts("resource", "title"),
        *_texts("exercise_id", nullable=True),
        sa.Column("settings", sa.JSON, nullable=False),
        *_texts("line_item", "line_items", nullable=True),
        *_times("released_at", nullable=True),
        sa.UniqueConstraint("course_id", "resource"),
    )


def _attempts() -> None:
    op.create_table(
        "attempt",
        _id(),
        _to("link"),
        _to("person", index=True),
        *_integers("number"),
        *_texts("key"),
        *_times("at"),
        *_texts("exercise_id", "version"),
        *_texts("seed", nullable=True),
        *_texts("language"),
        sa.Column("answer", sa.JSON, nullable=False),
        sa.Column("form", _JSON_OR_NULL, nullable=True),
        sa.Column("report", sa.JSON, nullable=False),
        sa.Column("score", sa.Float, nullable=False),
        sa.Column("correct", sa.Boolean, nullable=False),
        *_texts("shown"),
        sa.UniqueConstraint("link_id", "person_id", "key"),
        sa.UniqueConstraint("link_id", "person_id", "number"),
    )
    op.create_table(
        "grade",
        _to("link", primary_key=True),
        _to("person", primary_key=True, index=True),
        sa.Column("score", sa.Float, nullable=False),
        *_integers("number"),
    )
    op.create_table(
        "participation",
        _to("link", primary_key=True),
        _to("person", primary_key=True, index=True),
        *_texts("role"),
        *_times("began", nullable=True),
        *_integers("extra_seconds", "extra_attempts", "made", server_default="0"),
        sa.Column("draft", _JSON_OR_NULL, nullable=True),
        *_times("draft_at", nullable=True),
    )
    op.create_table(
        "regrading",
        _id(),
        _to("link"),
        *_texts("scope", "version"),
        *_times("started"),
        *_times("applied", nullable=True),
    )


def _scores() -> None:
    op.create_table(
        "score_to_send",
        _to("link", primary_key=True),
        _to("person", primary_key=True, index=True),
        sa.Column("score", sa.Float, nullable=False),
        *_times("submitted_at", nullable=True),
        *_integers("revision"),
        *_integers("sent_revision", server_default="0"),
        *_times("due", nullable=True, index=True),
        *_times("timestamp", nullable=True),
        *_texts("lease", nullable=True),
        *_integers("tries", server_default="0"),
        sa.Column("dead", sa.Boolean, nullable=False, server_default=sa.false()),
        *_texts("problem", nullable=True),
    )
    op.create_table(
        "session",
        _id(),
        *_texts("token_hash", unique=True),
        _to("link"),
        _to("person", index=True),
        *_texts("role"),
        *_texts("locale", "return_url", nullable=True),
        *_times("expires", index=True),
    )
    op.create_table(
        "finding",
        _to("attempt", primary_key=True),
        *_integers("position", primary_key=True),
        _to("link"),
        *_texts("kind", "code"),
        *_integers("row", nullable=True),
        sa.Index("ix_finding_link_id_kind_code", "link_id", "kind", "code"),
    )
    op.create_table(
        "regraded",
        _to("regrading", primary_key=True),
        _to("attempt", primary_key=True, index=True),
        sa.Column("score", sa.Float, nullable=False),
        sa.Column("correct", sa.Boolean, nullable=False),
        sa.Column("report", _JSON_OR_NULL, nullable=True),
    )


def _id() -> sa.Column[int]:
    return sa.Column("id", sa.Integer, primary_key=True)


def _to(relation: str, **options: Any) -> sa.Column[int]:
    key = sa.ForeignKey(f"{relation}.id", ondelete="CASCADE")
    return sa.Column(f"{relation}_id", sa.Integer, key, **{"nullable": False, **options})


def _columns(kind: TypeEngine[Any], *names: str, **options: Any) -> list[sa.Column[Any]]:
    return [sa.Column(name, kind, **{"nullable": False, **options}) for name in names]


def _texts(*names: str, **options: Any) -> list[sa.Column[Any]]:
    return _columns(sa.Text(), *names, **options)


def _integers(*names: str, **options: Any) -> list[sa.Column[Any]]:
    return _columns(sa.Integer(), *names, **options)


def _times(*names: str, **options: Any) -> list[sa.Column[Any]]:
    return _columns(_TIME, *names, **options)
