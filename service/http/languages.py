"""The language of an answer: what the address asks for, or else the header Accept-Language."""

from typing import Annotated, TypeAlias

from fastapi import Query
from pydantic import WithJsonSchema
from starlette.requests import Request

from kinematics.errors import Fault
from service.http.negotiation import preferred_language
from service.http.problems import RequestError, RequestPart
from service.messages import DEFAULT_LANGUAGE, languages

Language: TypeAlias = Annotated[
    str | None,
    Query(description="en, es, fr, pt, ro or uk; else Accept-Language decides"),
    WithJsonSchema({"type": "string", "enum": list(languages())}),
]
"""The query parameter `lang`; what is asked for is read, and refused, by `language_of`."""


def language_for(accept_language: str | None) -> str:
    """Return the language that the header Accept-Language asks for; English when there is no better one."""
    return preferred_language(accept_language, languages()) if accept_language else DEFAULT_LANGUAGE


def language_of(request: Request) -> str:
    """Return the language to answer in.

    Raises:
        RequestError: the query parameter `lang` names a language that is not spoken here.
    """
    # Hardly any request has a query, and to parse none takes 10 µs.
    asked = request.query_params.get("lang") if request.scope["query_string"] else None
    if asked is None:
        return language_for(request.headers.get("accept-language"))
    if asked not in languages():
        known = ", ".join(languages())
        raise RequestError(
            Fault.at("language_unknown", "lang", language=asked[:20], known=known), part=RequestPart.QUERY
        )
    return asked
