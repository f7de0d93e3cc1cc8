"""The audit log: staff looked at, or changed, what belongs to students."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from typing import Any

import sqlalchemy as sa

from courses.model import Access, CourseSession
from courses.records import access
from courses.storage import Store


def log_access(
    store: Store,
    session: CourseSession,
    action: str,
    now: datetime,
    *,
    subject: str | None = None,
    details: Mapping[str, Any] | None = None,
) -> None:
    """Write down that staff did something. Keys are pseudonyms."""
    with store.writing() as connection:
        connection.execute(
            sa.insert(access).values(
                at=now,
                actor=session.person.key,
                action=action,
                subject=subject,
                link_id=session.link.id,
                details=dict(details or {}),
            )
        )


def accesses(store: Store, *, subject: str | None = None, limit: int = 1000) -> list[Access]:
    """The newest lines of the log, those of one person if named."""
    wanted = sa.select(access).order_by(access.c.id.desc()).limit(limit)
    if subject is not None:
        wanted = wanted.where(access.c.subject == subject)
    with store.reading() as connection:
        return [
            Access(
                at=row.at,
                actor=row.actor,
                action=row.action,
                subject=row.subject,
                link_id=row.link_id,
                details=row.details,
            )
            for row in connection.execute(wanted)
        ]
