"""What the pages load: the files of the form, and the messages they speak with."""

from functools import lru_cache

from fastapi import APIRouter, Response

from service.http.routing import ApiRequest, DirectRoute
from service.messages import LOCALES, languages
from service.resources import resources_of
from service.web.responses import IMMUTABLE, text_response

router = APIRouter(include_in_schema=False, route_class=DirectRoute)


@router.get("/static/{version}/{name:path}")
async def static_file(request: ApiRequest) -> Response:
    """Return a file of the form. Under the current version's address it may be kept for ever."""
    store = resources_of(request).assets
    asset = store.get(request.path_params["name"], request.headers.get("accept-encoding", ""))
    if asset is None:
        return Response(status_code=404, headers={"Cache-Control": "no-cache"})
    current = request.path_params["version"] == store.version
    headers = {
        "Cache-Control": IMMUTABLE if current else "no-cache",
        "ETag": asset.etag,
        "Vary": "Accept-Encoding",
        "Access-Control-Allow-Origin": "*",
    }
    if asset.encoding:
        headers["Content-Encoding"] = asset.encoding
    if asset.etag in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers=headers)
    return Response(asset.body, media_type=asset.media_type, headers=headers)


@lru_cache(maxsize=64)
def _messages(language: str, wanted: frozenset[str]) -> str:
    paths = sorted((LOCALES / language).glob("*.ftl"))
    return "\n".join(path.read_text(encoding="utf-8") for path in paths if path.stem in wanted)


@router.get("/locales/{language}.ftl")
async def messages(request: ApiRequest) -> Response:
    """Return the messages of a language, the same that the API answers with.

    `?files=form+feedback` picks files.
    """
    language, wanted = request.path_params["language"], request.query_params.get("files", "")
    if language not in languages():
        return Response(status_code=404, headers={"Cache-Control": "no-cache"})
    files = frozenset(path.stem for path in (LOCALES / language).glob("*.ftl"))
    text = _messages(language, files.intersection(wanted.split()) if wanted else files)
    headers = {"Cache-Control": "no-cache", "Access-Control-Allow-Origin": "*"}
    return text_response(request, text, "text/plain; charset=utf-8", headers)
