"""Pages as responses: language, content security policy, validators, compression."""

import gzip
import hashlib
from collections.abc import Mapping
from functools import lru_cache
from pathlib import PurePosixPath
from urllib.parse import quote

from fastapi import Request, Response
from fastapi.responses import RedirectResponse

from exercises.access import Tool
from service.http.languages import language_for
from service.http.link_guard import context_of, may_open
from service.http.metering import path_of
from service.http.negotiation import weighted
from service.http.problems import ServiceError, fault_sentence, status_of
from service.messages import languages, sentence
from service.resources import resources_of
from service.settings import Settings
from service.web.shell import NAVIGATION, Page, render

IMMUTABLE = "public, max-age=31536000, immutable"
"""Cache-Control of what never changes at its address: a year is the longest that caches heed."""
PAGE_LEVEL = 3  # Of gzip: a page of 10 kB takes half the time of level 6, and is 7 % longer.


def content_security_policy(
    settings: Settings,
    *,
    in_any_frame: bool = False,
    platforms: tuple[str, ...] = (),
    form_action: str = "'self'",
) -> str:
    """Return what a page may load and who may frame it: only this origin; no inline script or style at all.

    `in_any_frame` is stronger than the settings; learning platforms may frame every page.
    """
    ancestors = ("*",) if in_any_frame else (*settings.frame_ancestors, *platforms)
    return "; ".join(
        (
            "default-src 'none'",
            "script-src 'self'",
            "style-src 'self'",
            "img-src 'self' data: blob:",
            "font-src 'self'",
            "connect-src 'self'",
            "base-uri 'none'",
            f"form-action {form_action}",
            "frame-ancestors " + (" ".join(ancestors) or "'none'"),
        )
    )


def page_language(request: Request) -> str:
    """Return the language that the address asks for (`?lang=`), or the browser."""
    asked = request.query_params.get("lang", "")
    return asked if asked in languages() else language_for(request.headers.get("accept-language"))


def page_response(
    request: Request,
    page: Page,
    values: Mapping[str, str] | None = None,
    *,
    own: Mapping[str, str] | None = None,
    status: int = 200,
    in_any_frame: bool = False,
    form_action: str = "'self'",
    off: frozenset[Tool] = frozenset(),
) -> Response:
    """Return a page in the reader's language, with the headers that every page has.

    `values` and `own` are what its template asks for, see `render`; anybody may frame it, if told so.
    """
    resources = resources_of(request)
    settings, courses = resources.settings, resources.courses
    platforms = courses.frame_origins() if courses is not None else ()
    language = page_language(request)

    store = resources.assets
    text = render(
        page,
        language=language,
        version=store.version,
        modules=store.imports(f"js/pages/{page.name}.js"),
        query=[item for item in request.query_params.multi_items() if item[0] != "lang"],
        values=values,
        own=own,
        linked=tuple(_linked(request, off)),
    )
    headers = {
        "Content-Security-Policy": content_security_policy(
            settings, in_any_frame=in_any_frame, platforms=platforms, form_action=form_action
        ),
        "Permissions-Policy": "camera=(), geolocation=(), microphone=()",
        "Cache-Control": "no-cache",
        "Content-Language": language,
        "Vary": "Accept-Language",
    }
    return text_response(request, text, "text/html; charset=utf-8", headers, status)


def _linked(request: Request, off: frozenset[Tool]) -> list[str]:
    """The pages that the bar may lead to: not what is switched off."""
    context, library = context_of(request), resources_of(request).exercises
    return [
        name
        for name, (path, _) in NAVIGATION.items()
        if (context is None or may_open(path, context, library))
        and not (name == "playground" and Tool.PLAYGROUND in off)
    ]


def missing_page(request: Request) -> Response:
    """Return the page that says that there is no such page; an address that ends in a slash leads on."""
    path, query = path_of(request.scope), request.url.query
    if (name := PurePosixPath(path).name) and path.endswith(f"/{name}/"):
        return RedirectResponse(f"../{quote(name)}{query and '?'}{query}", 308)
    text = sentence(page_language(request), "form-missing-text") or ""
    return page_response(request, _without_content(request), {"text": text}, status=404)


def refusal_page(request: Request, error: ServiceError) -> Response:
    """Return the page that tells a person why a page is not for them."""
    fault, status, language = error.faults[0], status_of(error), page_language(request)
    resources_of(request).metrics.refused(fault.code)
    title = sentence(language, f"problem-title-{status}") or fault.code
    values = {"title": title, "text": fault_sentence(fault, language)}
    return page_response(request, _without_content(request), values, status=status)


def _without_content(request: Request) -> Page:
    depth = path_of(request.scope).count("/") - 1
    return Page(name="missing", title="form-missing-title", depth=depth)


def text_response(
    request: Request, text: str | bytes, media_type: str, headers: Mapping[str, str], status: int = 200
) -> Response:
    """Return the text with a validator, compressed if the client takes it; 304 if it has it already.

    The validator is weak, because it is the same for the text and for its compressed form; caches keep the
    two apart by `Vary`.
    """
    body = text.encode() if isinstance(text, str) else text
    tag = f'W/"{hashlib.sha256(body).hexdigest()[:20]}"'
    varies = ", ".join(dict.fromkeys([*filter(None, [headers.get("Vary")]), "Accept-Encoding"]))
    sent = {**headers, "ETag": tag, "Vary": varies}
    if status == 200 and _has(tag, request.headers.get("if-none-match", "")):
        return Response(status_code=304, headers=sent)
    if takes_gzip(request):
        sent["Content-Encoding"] = "gzip"
        body = _compressed(body)
    return Response(body, status_code=status, media_type=media_type, headers=sent)


def packed_response(
    request: Request, packed: bytes, tag: str, media_type: str, headers: Mapping[str, str]
) -> Response:
    """Return what is kept gzipped, under its validator, to those who take it so and to those who don't."""
    varies = ", ".join(dict.fromkeys([*filter(None, [headers.get("Vary")]), "Accept-Encoding"]))
    sent = {**headers, "ETag": f'W/"{tag}"', "Vary": varies}
    if _has(sent["ETag"], request.headers.get("if-none-match", "")):
        return Response(status_code=304, headers=sent)
    if takes_gzip(request):
        sent["Content-Encoding"] = "gzip"
        return Response(packed, media_type=media_type, headers=sent)
    return Response(gzip.decompress(packed), media_type=media_type, headers=sent)


def takes_gzip(request: Request) -> bool:
    """Return whether the client takes what is gzipped."""
    accepted = dict(reversed(weighted(request.headers.get("accept-encoding", ""))))
    return accepted.get("gzip", accepted.get("*", 0.0)) > 0.0


def _has(tag: str, asked: str) -> bool:
    """Whether If-None-Match names the tag; weak and strong ones are compared alike (RFC 9110 §13.1.2)."""
    held = {item.strip().removeprefix("W/") for item in asked.split(",")}
    return "*" in held or tag.removeprefix("W/") in held


@lru_cache(maxsize=128)
def _compressed(body: bytes) -> bytes:
    return gzip.compress(body, PAGE_LEVEL, mtime=0)
