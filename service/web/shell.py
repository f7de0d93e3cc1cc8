"""HTML pages from Jinja2 templates: every text in the reader's language, every address relative.

A template says `{{ say("message-id") }}` for a message of `locales/` and `{{ name }}` for one of the page;
both are escaped. What differs from reader to reader is put into the page after that, so that the rest is made
once. Addresses start with `{{ root }}`, the relative path from the page to the service's root
("./" or "../"), so a page works under any prefix of a reverse proxy without knowing it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from urllib.parse import urlencode

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import escape

from service.messages import languages, sentence

_TEMPLATES = Environment(
    loader=FileSystemLoader(Path(__file__).resolve().parent / "templates"),
    autoescape=True,
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
    keep_trailing_newline=True,
    auto_reload=False,
)
SHARED_PAGES = 64
"""Pages in the cache that differ from reader to reader in a few places, some ten kilobytes each."""

NAVIGATION: Mapping[str, tuple[str, str]] = {
    "home": ("", "form-nav-exercises"),
    "playground": ("playground", "form-nav-playground"),
    "lesson": ("lesson", "form-nav-lesson"),
}
"""Pages that the bar of every page leads to: name, address below the root, message."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Page:
    """One kind of page.

    Attributes:
        name: stem of its template, and of its module under `static/js/pages/`.
        title: id of the message that is its title.
        messages: message files that its script needs, besides `form`.
        depth: how many folders below the root its address stands.
        styles: style sheets besides the ones every page has.
    """

    name: str
    title: str
    messages: tuple[str, ...] = ()
    depth: int = 0
    styles: tuple[str, ...] = ()


def render(
    page: Page,
    *,
    language: str,
    version: str,
    modules: tuple[str, ...],
    query: Sequence[tuple[str, str]] = (),
    values: Mapping[str, str] | None = None,
    own: Mapping[str, str] | None = None,
    linked: tuple[str, ...] = tuple(NAVIGATION),
) -> str:
    """Return a whole page.

    Args:
        language: one that has a folder of messages.
        modules: what the page's module imports, to be fetched at once.
        query: the address's query without its language; links to the other languages keep it.
        values: what the page's own template asks for; `title` overrides the page's title.
        own: the same of what differs from reader to reader, where all the rest is for many: templates
            write it down and do nothing else with it. None: nothing of the page is for anybody else.
        linked: names of the pages that the bar leads to.
    """
    rest = f"{urlencode(query)}&" if query else ""
    if own is None:
        return _written(page, language, version, modules, linked, {**(values or {}), "rest": rest})
    own = {**own, "rest": rest}
    shared = (*(values or {}).items(), *((name, _place(name)) for name in own))
    text = _shared(page, language, version, modules, linked, shared)
    for name, value in own.items():
        text = text.replace(_place(name), escape(value))
    return text


def _place(name: str) -> str:
    """What stands in a page that is made once where something of its reader's own will."""
    return f"\0{name}\0"


@lru_cache(maxsize=SHARED_PAGES)
def _shared(
    page: Page,
    language: str,
    version: str,
    modules: tuple[str, ...],
    linked: tuple[str, ...],
    values: tuple[tuple[str, str], ...],
) -> str:
    return _written(page, language, version, modules, linked, dict(values))


def _written(
    page: Page,
    language: str,
    version: str,
    modules: tuple[str, ...],
    linked: tuple[str, ...],
    values: Mapping[str, str],
) -> str:
    def say(identifier: str, language: str = language) -> str:
        return sentence(language, identifier) or identifier

    root = "../" * page.depth or "./"
    shell = {
        "say": say,
        "root": root,
        "assets": f"{root}static/{version}",
        "lang": language,
        "title": say(page.title),
        "page": page,
        "modules": modules,
        "navigation": [(name, *NAVIGATION[name]) for name in linked],
        "languages": languages(),
    }
    return _TEMPLATES.get_template(f"{page.name}.html").render({**shell, **values})
