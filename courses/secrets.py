"""Secrets of an installation; tokens, codes and nonces: random, stored as hashes only."""

from __future__ import annotations

import hashlib
import hmac
import secrets
from collections.abc import Mapping
from datetime import datetime, timedelta
from functools import lru_cache
from typing import Any

import sqlalchemy as sa

from courses import records
from courses.refusals import SessionError
from courses.statements import insert_once
from courses.storage import Store
from kinematics.errors import Fault

TOKEN_BYTES = 32
"""256 random bits."""


def new_token() -> str:
    """Return 256 random bits, for URLs and headers."""
    return secrets.token_urlsafe(TOKEN_BYTES)


def hashed(token: str) -> str:
    """Return what is stored of a token. It has 256 random bits: no salt is needed."""
    return hashlib.sha256(token.encode()).hexdigest()


def pseudonym(store: Store, issuer: str, client_id: str, subject: str) -> str:
    """Return the key of a person: a hash of platform and subject, keyed with the installation's secret."""
    text = "\0".join((issuer, client_id, subject)).encode()
    return hmac.new(_secret(store, "pseudonyms"), text, hashlib.sha256).hexdigest()[:32]


@lru_cache(maxsize=16)
def _secret(store: Store, name: str) -> bytes:
    """An installation's secret of a name, made at its first use; every replica sees the same one."""
    with store.writing() as connection:
        insert_once(connection, records.secret, {"name": name, "value": secrets.token_hex(32)})
        found = connection.scalar(sa.select(records.secret.c.value).where(records.secret.c.name == name))
    return bytes.fromhex(str(found))


def issue_code(store: Store, purpose: str, content: Mapping[str, Any], now: datetime, life: timedelta) -> str:
    """Return a code that brings content back once."""
    code = new_token()
    with store.writing() as connection:
        connection.execute(
            sa.insert(records.one_time_code).values(
                code_hash=hashed(code), purpose=purpose, content=dict(content), expires=now + life
            )
        )
    return code


def redeem_code(store: Store, purpose: str, code: str, now: datetime) -> dict[str, Any]:
    """Return what a code was issued for; it works once.

    Raises:
        SessionError: it was used, is too old, or was never issued.
    """
    table = records.one_time_code
    wanted = sa.and_(table.c.code_hash == hashed(code), table.c.purpose == purpose)
    with store.writing() as connection:
        row = connection.execute(sa.select(table).where(wanted).with_for_update()).first()
        used = connection.execute(sa.delete(table).where(wanted)).rowcount
    if row is None or used != 1 or row.expires <= now:
        raise SessionError(Fault.at("code_used"))
    content: dict[str, Any] = row.content
    return content


def check_code(store: Store, purpose: str, code: str, now: datetime) -> None:
    """Refuse a code that could not be redeemed; one that could stays good.

    Raises:
        SessionError: it was used, is too old, or was never issued.
    """
    table = records.one_time_code
    wanted = sa.and_(table.c.code_hash == hashed(code), table.c.purpose == purpose)
    with store.reading() as connection:
        expires = connection.scalar(sa.select(table.c.expires).where(wanted))
    if expires is None or expires <= now:
        raise SessionError(Fault.at("code_used"))


def remember_nonce(store: Store, platform_id: int, value: str, expires: datetime) -> bool:
    """Insert a nonce; return False if the platform has used it before."""
    with store.writing() as connection:
        values = {"platform_id": platform_id, "nonce": hashed(value), "expires": expires}
        return insert_once(connection, records.nonce, values)
