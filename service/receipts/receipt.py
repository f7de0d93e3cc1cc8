"""A receipt: the facts of a verdict as a compact JWS (RFC 7515), signed with EdDSA (RFC 8037)."""

import hashlib
from base64 import urlsafe_b64decode, urlsafe_b64encode
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from datetime import UTC, datetime
from typing import Any

import orjson
from joserfc import jws
from joserfc.errors import JoseError

from kinematics.errors import Fault
from service.http.problems import RequestError
from service.receipts.keys import ALGORITHM, REGISTRY, ReceiptKeys

TYPE = "framewise-receipt+jwt"
LONGEST = 8192  # Characters of a receipt; one with all parts and a long name takes a quarter of it.
LONGEST_NAME = 200  # Characters of a name.


@dataclass(frozen=True, kw_only=True, slots=True)
class PartScore:
    """What one part of an exercise earned."""

    points: float
    max_points: float
    correct: bool


@dataclass(frozen=True, kw_only=True, slots=True)
class Receipt:
    """What a receipt says.

    Attributes:
        seed: what the student's values were drawn from, None for the exercise's own values.
        name: the name that the student typed; nobody has checked it.
        points: what the answer earned.
        parts: score by part.
        settings: what was in force: help level, parts asked, and the lecturer's signed settings, if any.
        answer: SHA-256 of the answer, in hexadecimal digits (see `answer_hash`).
        time: when it was judged, UTC, in whole seconds.
        service: origin of the service that judged.
    """

    exercise: str
    version: int
    seed: str | None
    name: str
    points: float
    max_points: float
    parts: Mapping[str, PartScore]
    settings: Mapping[str, Any] = field(default_factory=dict)
    answer: str
    time: datetime
    service: str


_CLAIMS = tuple(entry.name for entry in fields(Receipt) if entry.name not in ("time", "service"))
"""Fields that are claims of the same names; the other two are `iat` and `iss`."""


def answer_hash(answer: Mapping[str, Any]) -> str:
    """Return the SHA-256 of an answer: its JSON with sorted keys, without white space."""
    return hashlib.sha256(orjson.dumps(answer, option=orjson.OPT_SORT_KEYS)).hexdigest()


def issue(receipt: Receipt, keys: ReceiptKeys) -> str:
    """Return the receipt as a compact JWS."""
    payload = orjson.dumps(
        {
            "iss": receipt.service,
            "iat": int(receipt.time.timestamp()),
            **{name: getattr(receipt, name) for name in _CLAIMS},
        },
        option=orjson.OPT_SORT_KEYS,
    )
    header = {"alg": ALGORITHM, "kid": keys.signing.kid, "typ": TYPE}
    return jws.serialize_compact(header, payload, keys.signing, registry=REGISTRY)


def verify(token: str, keys: ReceiptKeys) -> Receipt:
    """Return what a receipt says, if one of our keys signed exactly this text.

    Raises:
        RequestError: it is no receipt, was altered, or was signed by another key.
    """
    header = _header(token)
    key = keys.find(header.get("kid"))
    if header.get("alg") != ALGORITHM or header.get("typ") != TYPE or set(header) != {"alg", "kid", "typ"}:
        raise _refused("receipt_malformed")
    if key is None:
        raise _refused("receipt_key_unknown", kid=str(header.get("kid"))[:80])
    try:
        signed = jws.deserialize_compact(token, key, registry=REGISTRY)
    except (JoseError, ValueError):
        raise _refused("receipt_altered") from None
    claims = orjson.loads(signed.payload or b"")
    told = {name: claims[name] for name in _CLAIMS}
    told["parts"] = {kind: PartScore(**score) for kind, score in told["parts"].items()}
    return Receipt(**told, time=datetime.fromtimestamp(claims["iat"], UTC), service=claims["iss"])


def _header(token: str) -> dict[str, Any]:
    """Return the header of a text with three parts in canonical base64url.

    The last character of an encoding may hold bits that mean nothing: a text that differs there alone would
    carry a valid signature, and be another text.
    """
    parts = token.split(".")
    if len(token) > LONGEST or len(parts) != 3 or not token.isascii():
        raise _refused("receipt_malformed")
    try:
        decoded = [urlsafe_b64decode(part + "=" * (-len(part) % 4)) for part in parts]
        header = orjson.loads(decoded[0])
    except ValueError:
        raise _refused("receipt_malformed") from None
    written = [urlsafe_b64encode(part).rstrip(b"=").decode() for part in decoded]
    if written != parts or not isinstance(header, dict):
        raise _refused("receipt_malformed")
    return header


def _refused(code: str, **params: str) -> RequestError:
    return RequestError(Fault.at(code, **params))
