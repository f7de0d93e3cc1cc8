"""The student web form: pages, the files they load, and the messages they speak with."""

from __future__ import annotations

import gzip
import hashlib
from functools import cache, lru_cache
from pathlib import Path

from fastapi import APIRouter, Request, Response

from service.messages import LOCALES, language_for, languages, sentence
from service.negotiation import weighted
from service.settings import Settings
from service.web.assets import Assets, static_root
from service.web.shell import Page, render

router = APIRouter(include_in_schema=False)

YEAR = 365 * 24 * 3600

HOME = Page(name="home", title="form-home-title")


def content_security_policy(settings: Settings) -> str:
    """What a page may load and who may frame it: only this origin; no inline script or style at all."""
    return "; ".join(
        (
            "default-src 'none'",
            "script-src 'self'",
            "style-src 'self'",
            "img-src 'self' data: blob:",
            "font-src 'self'",
            "connect-src 'self'",
            "base-uri 'none'",
            "form-action 'self'",
            f"frame-ancestors {' '.join(settings.frame_ancestors) or chr(39) + 'none' + chr(39)}",
        )
    )


@cache
def assets(root: Path | None) -> Assets:
    """The served files: the folder named by the settings, or the packaged one."""
    return Assets(root or static_root())


def page_language(request: Request) -> str:
    """The language that the address asks for (`?lang=`), or the browser."""
    asked = request.query_params.get("lang", "")
    return asked if asked in languages() else language_for(request.headers.get("accept-language"))


def page_response(
    request: Request, page: Page, values: dict[str, str] | None = None, *, status: int = 200
) -> Response:
    """A page as a response, in the reader's language, with the headers every page has."""
    settings: Settings = request.app.state.settings
    language = page_language(request)

    def translate(identifier: str) -> str:
        return sentence(language, identifier) or identifier

    text = render(
        page,
        language=language,
        version=assets(settings.static_directory).version,
        translate=translate,
        values=values,
    )
    headers = {
        "Content-Security-Policy": content_security_policy(settings),
        "Referrer-Policy": "no-referrer",
        "X-Content-Type-Options": "nosniff",
        "Permissions-Policy": "camera=(), geolocation=(), microphone=()",
        "Cache-Control": "no-cache",
        "Content-Language": language,
        "Vary": "Accept-Language, Accept-Encoding",
    }
    return text_response(request, text, "text/html; charset=utf-8", headers, status)


def text_response(
    request: Request, text: str, media_type: str, headers: dict[str, str], status: int = 200
) -> Response:
    """Text with a validator, compressed if the client takes it; 304 if it has it already."""
    plain = text.encode()
    headers["ETag"] = f'W/"{hashlib.sha256(plain).hexdigest()[:20]}"'
    if status == 200 and headers["ETag"] in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers=headers)
    if any(name == "gzip" and q > 0.0 for name, q in weighted(request.headers.get("accept-encoding", ""))):
        headers["Content-Encoding"] = "gzip"
        plain = _compressed(plain)
    return Response(plain, status_code=status, media_type=media_type, headers=headers)


@lru_cache(maxsize=128)
def _compressed(plain: bytes) -> bytes:
    return gzip.compress(plain, 6, mtime=0)


@router.get("/")
async def home(request: Request) -> Response:
    """The list of exercises."""
    return page_response(request, HOME)


@router.get("/static/{version}/{name:path}")
async def static_file(request: Request, version: str, name: str) -> Response:
    """A file of the form. Under the current version's address it may be kept for ever."""
    store = assets(request.app.state.settings.static_directory)
    asset = store.get(name, request.headers.get("accept-encoding", ""))
    if asset is None:
        return Response(status_code=404, headers={"Cache-Control": "no-cache"})
    current = version == store.version
    headers = {
        "Cache-Control": f"public, max-age={YEAR}, immutable" if current else "no-cache",
        "ETag": asset.etag,
        "Vary": "Accept-Encoding",
        "X-Content-Type-Options": "nosniff",
        "Access-Control-Allow-Origin": "*",
        "Content-Security-Policy": "default-src 'none'",
    }
    if asset.encoding:
        headers["Content-Encoding"] = asset.encoding
    if asset.etag in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers=headers)
    return Response(asset.body, media_type=asset.media_type, headers=headers)


@lru_cache(maxsize=64)
def _messages(language: str, rooms: tuple[str, ...]) -> str:
    paths = sorted((LOCALES / language).glob("*.ftl"))
    return "\n".join(path.read_text(encoding="utf-8") for path in paths if not rooms or path.stem in rooms)


@router.get("/locales/{language}.ftl")
async def messages(request: Request, language: str, rooms: str = "") -> Response:
    """The messages of a language, the same that the API answers with; `?rooms=form+feedback` picks files."""
    if language not in languages():
        return Response(status_code=404, headers={"Cache-Control": "no-cache"})
    text = _messages(language, tuple(rooms.split()))
    headers = {"Cache-Control": "no-cache", "Vary": "Accept-Encoding", "Access-Control-Allow-Origin": "*"}
    return text_response(request, text, "text/plain; charset=utf-8", headers)
