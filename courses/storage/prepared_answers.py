"""Figures and closed forms that were made before, by addresses made from what they follow from.

All processes on one database share them. Nothing here is worth a backup: what is missing is made again.
"""

from collections.abc import Mapping
from datetime import datetime

import sqlalchemy as sa

from courses.storage.database import Store
from courses.storage.records import prepared_answer
from courses.storage.statements import insert_all_once

MOST = 20_000  # Answers that are kept: some ten kilobytes each, two hundred megabytes at the most.


def prepared(store: Store, address: str) -> bytes | None:
    """Return what was made for an address; None if nothing was."""
    wanted = sa.select(prepared_answer.c.content).where(prepared_answer.c.address == address)
    with store.asking() as connection:
        found = connection.scalar(wanted)
    return None if found is None else bytes(found)


def keep_prepared(store: Store, answers: Mapping[str, bytes], at: datetime) -> None:
    """Write answers down by their addresses; the oldest ones make room for them."""
    if not answers:
        return
    table = prepared_answer
    rows = [{"address": address, "content": body, "made": at} for address, body in answers.items()]
    with store.writing() as connection:
        insert_all_once(connection, table, rows)
        excess = (connection.scalar(sa.select(sa.func.count()).select_from(table)) or 0) - MOST
        if excess > 0:
            oldest = sa.select(table.c.address).order_by(table.c.made).limit(excess)
            connection.execute(sa.delete(table).where(table.c.address.in_(oldest)))
