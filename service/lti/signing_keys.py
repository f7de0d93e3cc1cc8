"""The tool's own keys: RSA of 2048 bits, published before they sign and kept as long as a token may live."""

import json
from collections.abc import Mapping, Sequence
from datetime import datetime, timedelta
from functools import lru_cache
from typing import Any

from joserfc import jwt
from joserfc.jwk import RSAKey

from courses.people.platforms import StoredKey

ALGORITHM = "RS256"
PUBLISHED_BEFORE = timedelta(days=2)
"""Platforms keep key sets for a day: a new key is published so long before it signs."""
PUBLISHED_AFTER = timedelta(days=1)  # An old key stays published so long after its successor signs.
BITS = 2048  # The least that RFC 7518 §3.3 allows for RS256, and what every platform takes.

PUBLIC = ("kty", "kid", "use", "alg", "n", "e")
"""Members of a JWK that are no secret (RFC 7518 §6.3.1, RFC 7517 §4)."""
_CACHED_KEYS = 4  # Private keys in the cache: one signs, and its predecessor did.


def new_private_key() -> tuple[str, str]:
    """Name and private JWK of a new key."""
    key = RSAKey.generate_key(BITS, {"use": "sig", "alg": ALGORITHM}, private=True, auto_kid=True)
    return str(key.kid), json.dumps(key.as_dict(private=True))


def key_set(keys: Sequence[StoredKey]) -> dict[str, Any]:
    """Return the public keys (RFC 7517), as they are written in the private ones.

    Anybody may ask for them, and to import a private key takes 40 ms: OpenSSL looks whether it is sound.
    """
    written = [json.loads(key.private) for key in keys]
    return {"keys": [{name: key[name] for name in PUBLIC if name in key} for key in written]}


def signing_key(keys: Sequence[StoredKey], now: datetime) -> StoredKey:
    """Return the newest key that signs already; the oldest one if none does."""
    ready = [key for key in keys if key.signs_from <= now]
    return max(ready, key=lambda key: key.signs_from) if ready else min(keys, key=lambda key: key.signs_from)


def outdated(keys: Sequence[StoredKey], now: datetime) -> tuple[str, ...]:
    """Return the names of keys that nothing signed with them can still be valid."""
    current = signing_key(keys, now)
    return tuple(
        key.kid
        for key in keys
        if key.signs_from < current.signs_from and current.signs_from + PUBLISHED_AFTER < now
    )


def signed(claims: Mapping[str, Any], key: StoredKey) -> str:
    """Return a JWT of the claims."""
    header = {"alg": ALGORITHM, "typ": "JWT", "kid": key.kid}
    return jwt.encode(header, dict(claims), _imported(key.private), [ALGORITHM])


@lru_cache(maxsize=_CACHED_KEYS)
def _imported(private: str) -> RSAKey:
    return RSAKey.import_key(json.loads(private))
