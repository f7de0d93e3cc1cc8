"""When an answer came that could not be taken just then: a ticket to send with it again.

A refusal with status 503 says "send this again", and the end of an exam may come before that is done. The
refusal of a hand-in therefore brings a ticket that says when the answer came, signed with the installation's
secret (HMAC-SHA-256) and bound to the session and to the answer. Sent with the same answer in the same field,
it makes the answer count as of then.
"""

import hashlib
import hmac
import re
from datetime import UTC, datetime, timedelta
from typing import Any

HEADER = "Framewise-Arrival"  # The field that carries a ticket, either way.
LIFE = timedelta(hours=1)
"""How long a ticket is good for: after a longer outage, the exam itself has to be extended."""
_EPOCH = datetime(1970, 1, 1, tzinfo=UTC)
_MICROSECOND = timedelta(microseconds=1)
_PURPOSE = b"framewise arrival\0"
_TICKET = re.compile(r"([0-9]{1,17})\.([0-9a-f]{64})")


def arrival_ticket(came: datetime, token: str, answer: Any, secret: bytes) -> str:
    """Return a ticket: the time [µs since 1970-01-01 UTC] and its signature."""
    told = str((came - _EPOCH) // _MICROSECOND)
    return f"{told}.{_signature(told, token, answer, secret)}"


def told_arrival(ticket: str, token: str, answer: Any, secret: bytes, now: datetime) -> datetime | None:
    """Return when an answer came first, by its ticket; None if that is another's, or older than an hour."""
    match = _TICKET.fullmatch(ticket)
    if match is None or not hmac.compare_digest(match[2], _signature(match[1], token, answer, secret)):
        return None
    came = _EPOCH + int(match[1]) * _MICROSECOND
    return came if now - came <= LIFE else None


def _signature(told: str, token: str, answer: Any, secret: bytes) -> str:
    content = repr((told, token, answer)).encode(errors="surrogatepass")
    return hmac.new(secret, _PURPOSE + content, hashlib.sha256).hexdigest()
