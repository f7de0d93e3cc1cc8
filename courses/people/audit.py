"""The audit log: staff looked at, or changed, what belongs to students."""

from collections.abc import Mapping
from datetime import datetime
from typing import Any

import sqlalchemy as sa

from courses.model import CourseSession
from courses.storage.database import Store
from courses.storage.records import access


def log_access(
    store: Store,
    session: CourseSession,
    action: str,
    now: datetime,
    *,
    subject: str | None = None,
    details: Mapping[str, Any] | None = None,
) -> None:
    """Record that staff did something. Keys are pseudonyms."""
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
