"""Secrets of an installation, and what they seal; tokens, codes and nonces: random, stored as hashes only."""

import base64
import hashlib
import hmac
import json
import secrets
import zlib
from collections.abc import Mapping
from datetime import datetime, timedelta
from functools import lru_cache
from typing import Any

import sqlalchemy as sa

from courses.refusals import SessionError
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import insert_once
from kinematics.errors import Fault

TOKEN_BYTES = 32  # 256 random bits.


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


def preview_key(key: str) -> str:
    """Return the key of whom a member of the staff, of this key, is in previews."""
    return hashed(f"preview {key}")[:32]


@lru_cache(maxsize=16)
def _secret(store: Store, name: str) -> bytes:
    """An installation's secret of a name, made at its first use; every replica sees the same one."""
    with store.writing() as connection:
        insert_once(connection, records.secret, {"name": name, "value": secrets.token_hex(32)})
        found = connection.scalar(sa.select(records.secret.c.value).where(records.secret.c.name == name))
    return bytes.fromhex(str(found))


def sealed(store: Store, purpose: str, content: Mapping[str, Any]) -> str:
    """Return content for a stranger to carry: whoever holds it can read it, and not alter it."""
    told = base64.urlsafe_b64encode(zlib.compress(json.dumps(dict(content)).encode())).rstrip(b"=")
    return f"{told.decode()}.{_seal(store, purpose, told)}"


def unsealed(store: Store, purpose: str, text: str) -> dict[str, Any] | None:
    """Return what was sealed for a purpose; None if this installation has not sealed exactly this text."""
    told, _, seal = text.encode().partition(b".")
    if not hmac.compare_digest(seal, _seal(store, purpose, told).encode()):
        return None
    content: dict[str, Any] = json.loads(zlib.decompress(base64.urlsafe_b64decode(told + b"==")))
    return content


def _seal(store: Store, purpose: str, told: bytes) -> str:
    return hmac.new(_secret(store, purpose), told, hashlib.sha256).hexdigest()


def issue_code(store: Store, purpose: str, content: Mapping[str, Any], now: datetime, life: timedelta) -> str:
    """Return a code that brings content back once; delete those that were never redeemed."""
    code = new_token()
    with store.writing() as connection:
        delete_stale(connection, records.one_time_code, now)
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
    own = _own(purpose, code)
    with store.writing() as connection:
        row = connection.execute(sa.select(records.one_time_code).where(own).with_for_update()).first()
        used = connection.execute(sa.delete(records.one_time_code).where(own)).rowcount
    if row is None or used != 1 or row.expires <= now:
        raise SessionError(Fault.at("code_used"))
    content: dict[str, Any] = row.content
    return content


def check_code(store: Store, purpose: str, code: str, now: datetime) -> None:
    """Refuse a code that could not be redeemed; one that could stays good.

    Raises:
        SessionError: it was used, is too old, or was never issued.
    """
    wanted = sa.select(records.one_time_code.c.expires).where(_own(purpose, code))
    with store.asking() as connection:
        expires = connection.scalar(wanted)
    if expires is None or expires <= now:
        raise SessionError(Fault.at("code_used"))


def _own(purpose: str, code: str) -> sa.ColumnElement[bool]:
    table = records.one_time_code
    return sa.and_(table.c.code_hash == hashed(code), table.c.purpose == purpose)


def remember_nonce(store: Store, platform_id: int, value: str, now: datetime, life: timedelta) -> bool:
    """Insert a nonce, and delete old ones; return False if the platform has used it before."""
    with store.writing() as connection:
        delete_stale(connection, records.nonce, now)
        values = {"platform_id": platform_id, "nonce": hashed(value), "expires": now + life}
        return insert_once(connection, records.nonce, values)


def delete_stale(connection: sa.Connection, table: sa.Table, now: datetime) -> None:
    """Delete codes, or nonces, that have ended."""
    connection.execute(sa.delete(table).where(table.c.expires < now))
