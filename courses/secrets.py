"""Secrets of an installation, and tokens: random, stored as hashes only."""

from __future__ import annotations

import hashlib
import hmac
import secrets
from functools import lru_cache

import sqlalchemy as sa

from courses.records import secret
from courses.statements import insert_once
from courses.storage import Store

TOKEN_BYTES = 32
"""256 random bits."""


def new_token() -> str:
    """256 random bits, for URLs and headers."""
    return secrets.token_urlsafe(TOKEN_BYTES)


def hashed(token: str) -> str:
    """What is stored of a token. It has 256 random bits: no salt is needed."""
    return hashlib.sha256(token.encode()).hexdigest()


def pseudonym(store: Store, issuer: str, client_id: str, subject: str) -> str:
    """Key of a person: a hash of platform and subject, keyed with the installation's secret."""
    text = "\0".join((issuer, client_id, subject)).encode()
    return hmac.new(_secret(store, "pseudonyms"), text, hashlib.sha256).hexdigest()[:32]


@lru_cache(maxsize=16)
def _secret(store: Store, name: str) -> bytes:
    """An installation's secret of a name, made at its first use; every replica sees the same one."""
    with store.writing() as connection:
        insert_once(connection, secret, {"name": name, "value": secrets.token_hex(32)})
        found = connection.scalar(sa.select(secret.c.value).where(secret.c.name == name))
    return bytes.fromhex(str(found))
