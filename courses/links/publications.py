"""Exercises that were published: each version under an address made from its content, and never changed.

Whoever publishes the same draft twice gets the same address; another draft gets another one. What an
attempt was judged by is therefore there as long as the database is.
"""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Any

import sqlalchemy as sa

from courses.refusals import PublicationError
from courses.storage.database import Store
from courses.storage.records import publication
from courses.storage.statements import insert_once
from exercises.authoring.draft import ExerciseDraft
from kinematics.errors import Fault

MOST = 10_000  # Publications of an installation: some hundred megabytes at the most.
DIGITS = 12  # Of the digest in an address: 48 bits, among ten thousand no two alike.


@dataclass(frozen=True, kw_only=True, slots=True)
class Publication:
    """A version of an exercise.

    Attributes:
        address: its id with the beginning of its digest; the id of the exercise on this service.
        digest: SHA-256 of its content [hexadecimal].
        draft: its content.
    """

    address: str
    digest: str
    draft: ExerciseDraft


def content_of(draft: ExerciseDraft) -> str:
    """Return a draft as text, its keys in the order in which the author has them."""
    content = {"id": draft.id, "definition": draft.definition, "statements": draft.statements}
    return json.dumps(content, ensure_ascii=False, allow_nan=False, default=dict)


def publish(store: Store, draft: ExerciseDraft, at: datetime, *, most: int | None = MOST) -> Publication:
    """Keep a version of an exercise for good.

    Args:
        draft: one that was read without a fault.
        most: publications of an installation; None for the exercises of its own folders, which courses need
            whatever strangers have published.

    Raises:
        PublicationError: as many as may be are there already.
    """
    content = content_of(draft)
    ordered = json.dumps(json.loads(content), sort_keys=True, ensure_ascii=False)
    digest = hashlib.sha256(ordered.encode()).hexdigest()
    found = Publication(address=f"{draft.id}-{digest[:DIGITS]}", digest=digest, draft=draft)
    with store.writing() as connection:
        known = sa.select(publication.c.digest).where(publication.c.address == found.address)
        if connection.scalar(known) is None:
            count = connection.scalar(sa.select(sa.func.count()).select_from(publication)) or 0
            if most is not None and count >= most:
                raise PublicationError(Fault.at("publications_full", limit=most))
            row = {"address": found.address, "digest": digest, "content": content, "published": at}
            insert_once(connection, publication, row)
    return found


def published(store: Store, address: str) -> ExerciseDraft | None:
    """Return the draft at an address, named by it; None if there is none."""
    with store.reading() as connection:
        content = connection.scalar(sa.select(publication.c.content).where(publication.c.address == address))
    if content is None:
        return None
    data: Mapping[str, Any] = json.loads(content)
    return ExerciseDraft(id=address, definition=data["definition"], statements=data["statements"])
