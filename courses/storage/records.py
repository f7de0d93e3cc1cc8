"""The database: its relations, the same for SQLite and PostgreSQL."""

from typing import Any

import sqlalchemy as sa

from courses.storage.column_types import PlainText, UtcTime

metadata = sa.MetaData(
    naming_convention={
        "ix": "ix_%(table_name)s_%(column_0_N_name)s",
        "uq": "uq_%(table_name)s_%(column_0_N_name)s",
        "fk": "fk_%(table_name)s_%(column_0_N_name)s",
        "pk": "pk_%(table_name)s",
    }
)


def _id() -> sa.Column[int]:
    return sa.Column("id", sa.Integer, primary_key=True)


def _to(relation: str, **options: Any) -> sa.Column[int]:
    key = sa.ForeignKey(f"{relation}.id", ondelete="CASCADE")
    return sa.Column(f"{relation}_id", sa.Integer, key, nullable=False, **options)


secret = sa.Table(
    "secret",
    metadata,
    sa.Column("name", PlainText, primary_key=True),
    sa.Column("value", PlainText, nullable=False),
)

platform = sa.Table(
    "platform",
    metadata,
    _id(),
    sa.Column("issuer", PlainText, nullable=False),
    sa.Column("client_id", PlainText, nullable=False),
    sa.Column("name", PlainText, nullable=False),
    sa.Column("authorization_endpoint", PlainText, nullable=False),
    sa.Column("token_endpoint", PlainText, nullable=False),
    sa.Column("token_audience", PlainText),
    sa.Column("jwks_uri", PlainText, nullable=False),
    sa.Column("origins", sa.JSON, nullable=False),
    sa.Column("names_shared", sa.Boolean, nullable=False),
    sa.Column("status", PlainText, nullable=False),
    sa.Column("created", UtcTime, nullable=False),
    sa.UniqueConstraint("issuer", "client_id"),
)

deployment = sa.Table(
    "deployment",
    metadata,
    _to("platform", primary_key=True),
    sa.Column("deployment", PlainText, primary_key=True),
)

tool_key = sa.Table(
    "tool_key",
    metadata,
    sa.Column("kid", PlainText, primary_key=True),
    sa.Column("private", PlainText, nullable=False),
    sa.Column("created", UtcTime, nullable=False),
    sa.Column("signs_from", UtcTime, nullable=False),
)

registration = sa.Table(
    "registration",
    metadata,
    _id(),
    sa.Column("secret_hash", PlainText, nullable=False, unique=True),
    sa.Column("note", PlainText, nullable=False),
    sa.Column("created", UtcTime, nullable=False),
    sa.Column("expires", UtcTime, nullable=False),
    sa.Column("used_at", UtcTime),
)

nonce = sa.Table(
    "nonce",
    metadata,
    _to("platform", primary_key=True),
    sa.Column("nonce", PlainText, primary_key=True),
    sa.Column("expires", UtcTime, nullable=False, index=True),
)

one_time_code = sa.Table(
    "one_time_code",
    metadata,
    sa.Column("code_hash", PlainText, primary_key=True),
    sa.Column("purpose", PlainText, nullable=False),
    sa.Column("content", sa.JSON, nullable=False),
    sa.Column("expires", UtcTime, nullable=False, index=True),
)

person = sa.Table(
    "person",
    metadata,
    _id(),
    _to("platform"),
    sa.Column("key", PlainText, nullable=False, unique=True),
    sa.Column("subject", PlainText),
    sa.Column("name", PlainText),
    sa.Column("created", UtcTime, nullable=False),
    sa.Column("seen", UtcTime, nullable=False),
)

course = sa.Table(
    "course",
    metadata,
    _id(),
    _to("platform"),
    sa.Column("deployment", PlainText, nullable=False),
    sa.Column("context", PlainText, nullable=False),
    sa.Column("title", PlainText, nullable=False),
    sa.Column("memberships_url", PlainText),
    sa.UniqueConstraint("platform_id", "deployment", "context"),
)

link = sa.Table(
    "link",
    metadata,
    _id(),
    _to("course"),
    sa.Column("resource", PlainText, nullable=False),
    sa.Column("title", PlainText, nullable=False),
    sa.Column("exercise_id", PlainText),
    sa.Column("settings", sa.JSON, nullable=False),
    sa.Column("line_item", PlainText),
    sa.Column("line_items", PlainText),
    sa.Column("released_at", UtcTime),
    sa.UniqueConstraint("course_id", "resource"),
)

participation = sa.Table(
    "participation",
    metadata,
    _to("link", primary_key=True),
    _to("person", primary_key=True, index=True),
    sa.Column("role", PlainText, nullable=False),
    sa.Column("began", UtcTime),
    sa.Column("extra_seconds", sa.Integer, nullable=False, server_default="0"),
    sa.Column("extra_attempts", sa.Integer, nullable=False, server_default="0"),
    sa.Column("made", sa.Integer, nullable=False, server_default="0"),
    sa.Column("draft", sa.JSON(none_as_null=True)),
    sa.Column("draft_at", UtcTime),
    sa.Index("ix_participation_link_id_extra_seconds", "link_id", "extra_seconds"),
)

session = sa.Table(
    "session",
    metadata,
    _id(),
    sa.Column("token_hash", PlainText, nullable=False, unique=True),
    _to("link"),
    _to("person", index=True),
    sa.Column("role", PlainText, nullable=False),
    sa.Column("locale", PlainText),
    sa.Column("return_url", PlainText),
    sa.Column("expires", UtcTime, nullable=False, index=True),
)

attempt = sa.Table(
    "attempt",
    metadata,
    _id(),
    _to("link"),
    _to("person", index=True),
    sa.Column("number", sa.Integer, nullable=False),
    sa.Column("key", PlainText, nullable=False),
    sa.Column("at", UtcTime, nullable=False),
    sa.Column("exercise_id", PlainText, nullable=False),
    sa.Column("version", PlainText, nullable=False),
    sa.Column("seed", PlainText),
    sa.Column("language", PlainText, nullable=False),
    sa.Column("answer", sa.JSON, nullable=False),
    sa.Column("form", sa.JSON(none_as_null=True)),
    sa.Column("report", sa.JSON, nullable=False),
    sa.Column("score", sa.Float, nullable=False),
    sa.Column("correct", sa.Boolean, nullable=False),
    sa.Column("shown", PlainText, nullable=False),
    sa.UniqueConstraint("link_id", "person_id", "number"),
    sa.UniqueConstraint("link_id", "person_id", "key"),
)

finding = sa.Table(
    "finding",
    metadata,
    _to("attempt", primary_key=True),
    sa.Column("position", sa.Integer, primary_key=True),
    _to("link"),
    sa.Column("kind", PlainText, nullable=False),
    sa.Column("code", PlainText, nullable=False),
    sa.Column("row", sa.Integer),
    sa.Index("ix_finding_link_id_kind_code", "link_id", "kind", "code"),
)

grade = sa.Table(
    "grade",
    metadata,
    _to("link", primary_key=True),
    _to("person", primary_key=True, index=True),
    sa.Column("score", sa.Float, nullable=False),
    sa.Column("number", sa.Integer, nullable=False),
)

score_to_send = sa.Table(
    "score_to_send",
    metadata,
    _to("link", primary_key=True),
    _to("person", primary_key=True, index=True),
    sa.Column("score", sa.Float, nullable=False),
    sa.Column("submitted_at", UtcTime),
    sa.Column("revision", sa.Integer, nullable=False),
    sa.Column("sent_revision", sa.Integer, nullable=False, server_default="0"),
    sa.Column("due", UtcTime, index=True),
    sa.Column("timestamp", UtcTime),
    sa.Column("lease", PlainText),
    sa.Column("tries", sa.Integer, nullable=False, server_default="0"),
    sa.Column("dead", sa.Boolean, nullable=False, server_default=sa.false()),
    sa.Column("problem", PlainText),
)

regrading = sa.Table(
    "regrading",
    metadata,
    _id(),
    _to("link"),
    sa.Column("scope", PlainText, nullable=False),
    sa.Column("version", PlainText, nullable=False),
    sa.Column("started", UtcTime, nullable=False),
    sa.Column("applied", UtcTime),
    sa.Column("unsettled_from", sa.Integer),
)

regraded = sa.Table(
    "regraded",
    metadata,
    _to("regrading", primary_key=True),
    _to("attempt", primary_key=True, index=True),
    sa.Column("score", sa.Float, nullable=False),
    sa.Column("correct", sa.Boolean, nullable=False),
    sa.Column("report", sa.JSON(none_as_null=True)),
)

publication = sa.Table(
    "publication",
    metadata,
    sa.Column("address", PlainText, primary_key=True),
    sa.Column("digest", PlainText, nullable=False),
    sa.Column("content", PlainText, nullable=False),
    sa.Column("published", UtcTime, nullable=False),
)

prepared_answer = sa.Table(
    "prepared_answer",
    metadata,
    sa.Column("address", PlainText, primary_key=True),
    sa.Column("content", sa.LargeBinary, nullable=False),
    sa.Column("made", UtcTime, nullable=False, index=True),
)

access = sa.Table(
    "access",
    metadata,
    _id(),
    sa.Column("at", UtcTime, nullable=False, index=True),
    sa.Column("actor", PlainText, nullable=False),
    sa.Column("action", PlainText, nullable=False),
    sa.Column("subject", PlainText, index=True),
    sa.Column("link_id", sa.Integer),
    sa.Column("details", sa.JSON, nullable=False),
)
