"""What the text of a setting may be: addresses, hosts and origins, and lists of them."""

import os
import re
from collections.abc import Callable
from ipaddress import ip_network
from pathlib import Path
from typing import Annotated

from pydantic import AfterValidator, BeforeValidator
from pydantic_settings import NoDecode

_PORT = r"(6553[0-5]|655[0-2]\d|65[0-4]\d\d|6[0-4]\d{3}|[1-5]?\d{1,4})"
_HOST = r"(\*\.)?[A-Za-z0-9-]+(\.[A-Za-z0-9-]+)*"
_NAMED = rf"([A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*|\[[0-9A-Fa-f:.]+\])(:{_PORT})?"
_LISTENING = r"[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*|[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]*(%[A-Za-z0-9._-]+)?"
_ORIGIN = rf"\*|null|https?://({_HOST}|\[[0-9A-Fa-f:.]+\])(:{_PORT})?"
_ANCESTOR = (
    rf"'self'|'none'|\*|https?:|(?!(self|none)$)(https?://)?({_HOST}|\[[0-9A-Fa-f:.]+\])(:({_PORT}|\*))?/?"
)
"""A source of a policy; self and none without quotation marks would be hosts of these names."""
PREFIX = re.compile(r"(/(?!\.{1,2}(/|$))[A-Za-z0-9._~-]+)+")
"""A path under which a proxy may serve: nothing in it needs an escape, or is resolved by who calls."""


def _matching(pattern: str, wanted: str) -> Callable[[str], str]:
    def match(value: str) -> str:
        if not re.fullmatch(pattern, value):
            raise ValueError(f"{value!r} is not {wanted}")
        return value

    return match


def _each_matching(pattern: str, wanted: str) -> AfterValidator:
    match = _matching(pattern, wanted)

    def each(value: tuple[str, ...]) -> tuple[str, ...]:
        if "'none'" in tuple(map(match, value)) and len(value) > 1:  # only an ancestor may be none
            raise ValueError("'none' stands alone")
        return value

    return AfterValidator(each)


def _secretly_matching(pattern: str, example: str) -> AfterValidator:
    """Refuse what is no address without repeating it: a password may stand in it."""

    def match(value: str) -> str:
        if value and not re.fullmatch(pattern, value):
            raise ValueError(f"this is not an address such as {example}")
        return value

    return AfterValidator(match)


def _split(value: object) -> object:
    return tuple(value.replace(",", " ").split()) if isinstance(value, str) else value


def _networks(value: tuple[str, ...]) -> tuple[str, ...]:
    if "*" in value:
        if len(value) > 1:
            raise ValueError("* stands for every address, so it stands alone")
        return value
    for entry in value:
        ip_network(entry)  # says what is wrong, such as bits outside the mask
    return value


def _path(value: str) -> str:
    trimmed = value.strip("/")
    if not trimmed:
        return ""
    return _matching(PREFIX.pattern, "a path of letters, digits and . _ ~ -, such as /dh")(f"/{trimmed}")


def _public(value: str) -> str:
    wanted = "an address such as https://a.example/dh"
    return _matching(f"https?://{_NAMED}({PREFIX.pattern})?/?", wanted)(value) if value else ""


def _named_folder(value: object) -> object:
    if value == "":
        raise ValueError("a folder is needed, such as data")
    return value


def _web_form(value: Path | None) -> Path | None:
    if value is not None and not (value / "js").is_dir():
        shown = os.fsencode(value).decode(errors="replace")
        raise ValueError(f"{shown} is no folder of the web form: it has no folder js")
    return value


Names = Annotated[tuple[str, ...], NoDecode, BeforeValidator(_split)]
Folders = Annotated[tuple[Path, ...], NoDecode, BeforeValidator(_split)]
Networks = Annotated[Names, AfterValidator(_networks)]
Ancestors = Annotated[
    Names, _each_matching(_ANCESTOR, "'self', 'none' or an origin such as https://a.example")
]
Origins = Annotated[Names, _each_matching(_ORIGIN, "*, null, or an origin such as https://a.example")]
Platforms = Annotated[Names, _each_matching(f"https?://{_NAMED}/?", "an origin such as https://lms.example")]
Hosts = Annotated[Names, _each_matching(_NAMED, "a host such as lms.example, or lms.example:8443")]
ListeningAddress = Annotated[
    str, AfterValidator(_matching(_LISTENING, "an address or a name, such as 127.0.0.1; 0.0.0.0 for all"))
]
ProxyPath = Annotated[str, AfterValidator(_path)]
PublicAddress = Annotated[str, AfterValidator(_public)]
DatabaseAddress = Annotated[
    str, _secretly_matching(r"postgres(ql)?(\+[a-z0-9]+)?://\S*", "postgresql://user:password@host/database")
]
CollectorAddress = Annotated[
    str, _secretly_matching(r"https?://[^/\s]+\S*", "http://collector:4318/v1/traces")
]
DataFolder = Annotated[Path, BeforeValidator(_named_folder)]
WebForm = Annotated[Path | None, AfterValidator(_web_form)]
