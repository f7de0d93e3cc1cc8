"""Forms as browsers and platforms post them, and the address that this service is reached under."""

from urllib.parse import parse_qsl

from starlette.requests import Request

from kinematics.errors import Fault
from service.http.problems import BodyError

LARGEST_FORM = 256 * 1024  # A launch message takes a few kilobytes [byte].
MOST_FIELDS = 100  # Fields of a form, many times what an LTI platform sends.


async def form_of(request: Request) -> dict[str, str]:
    """Return the fields of an urlencoded body; of a repeated one the last.

    Raises:
        BodyError: it is too large or not a form.
    """
    received = bytearray()
    async for piece in request.stream():
        received += piece
        if len(received) > LARGEST_FORM:
            raise BodyError(Fault.at("posted_form_too_large", limit=LARGEST_FORM))
    try:
        return dict(parse_qsl(received.decode(), keep_blank_values=True, max_num_fields=MOST_FIELDS))
    except ValueError:
        raise BodyError(Fault.at("form_invalid")) from None


def own_root(request: Request, public_url: str) -> str:
    """Return the service's address as callers see it, with a slash at its end."""
    root = public_url or str(request.base_url)
    return root.rstrip("/") + "/"
