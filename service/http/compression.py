"""Large answers are compressed for callers that take gzip; small ones are not worth the time."""

import gzip

from anyio.to_thread import run_sync
from starlette.types import Message, Send

from service.http.negotiation import weighted

SMALLEST = 32 * 1024  # Answers [byte] that are worth compressing; below it a page arrives no sooner.
IN_A_THREAD = 256 * 1024  # Answers [byte] whose compression the event loop must not wait for.
_LEVEL = 4  # Level of gzip: the higher ones take longer and save little.
_TYPES = (b"application/json", b"application/problem+json", b"image/svg+xml", b"text/")


def accepts_gzip(accept_encoding: bytes) -> bool:
    """Return whether a caller with this header takes gzip."""
    return dict(weighted(accept_encoding.decode("latin-1"))).get("gzip", 0.0) > 0.0


def compressing(send: Send) -> Send:
    """Return a sender that compresses an answer which comes in one piece and is large."""
    held: list[Message] = []

    async def send_compressed(message: Message) -> None:
        if message["type"] == "http.response.start" and _is_worth_it(dict(message["headers"])):
            held.append(message)
            return
        if held and message["type"] == "http.response.body":
            start = held.pop()
            if not message.get("more_body"):
                message = {**message, "body": await _compressed(message.get("body", b""))}
                start["headers"] = _headers(start, len(message["body"]))
            await send(start)
        await send(message)

    return send_compressed


def _is_worth_it(headers: dict[bytes, bytes]) -> bool:
    length = headers.get(b"content-length", b"0")
    return (
        len(length) >= len(str(SMALLEST))
        and int(length) >= SMALLEST
        and b"content-encoding" not in headers
        and headers.get(b"content-type", b"").startswith(_TYPES)
    )


async def _compressed(body: bytes) -> bytes:
    if len(body) < IN_A_THREAD:
        return gzip.compress(body, _LEVEL, mtime=0)
    return await run_sync(lambda: gzip.compress(body, _LEVEL, mtime=0))


def _headers(start: Message, length: int) -> list[tuple[bytes, bytes]]:
    kept = [(name, value) for name, value in start["headers"] if name not in (b"content-length", b"etag")]
    return [
        *kept,
        (b"content-encoding", b"gzip"),
        (b"vary", b"Accept-Encoding"),
        (b"content-length", str(length).encode()),
    ]
