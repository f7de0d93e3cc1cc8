"""HTML pages from templates: every text in the reader's language, every address relative.

A template holds `${message-id}` for a message of `locales/*/form.ftl` (or another room's) and `${.name}` for
a value that the page is made with. Both are escaped; `${.name!}` takes markup that is already safe.
Addresses start with `${.root}`, the relative way from the page to the service's root ("./" or "../"), so a
page works under any prefix of a reverse proxy without knowing it.
"""

from __future__ import annotations

import html
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from urllib.parse import urlencode

from service.messages import languages, sentence

TEMPLATES = Path(__file__).resolve().parent / "templates"
FIELD = re.compile(r"\$\{(?P<value>\.)?(?P<name>[a-z][a-z0-9_-]*)(?P<safe>!)?\}")

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
        rooms: message files that its script needs, besides `form`.
        depth: how many folders below the root its address stands.
        styles: style sheets besides the ones every page has.
    """

    name: str
    title: str
    rooms: tuple[str, ...] = ()
    depth: int = 0
    styles: tuple[str, ...] = ()


@lru_cache(maxsize=64)
def _template(name: str, stamp: int) -> str:
    return (TEMPLATES / f"{name}.html").read_text(encoding="utf-8")


def template(name: str) -> str:
    """Return the text of a template, read again when its file changes."""
    return _template(name, (TEMPLATES / f"{name}.html").stat().st_mtime_ns)


def told(identifier: str, language: str) -> str:
    """Return the text of a message; the message's own name where there is none."""
    return sentence(language, identifier) or identifier


def fill(text: str, language: str, values: Mapping[str, str]) -> str:
    """Return a template with its messages and values put in, escaped."""
    literals, fields = _translated(text, language)
    put = [values[name] if safe else html.escape(values[name]) for name, safe in fields]
    return "".join(part for pair in zip(literals, [*put, ""], strict=True) for part in pair)


@lru_cache(maxsize=128)
def _translated(text: str, language: str) -> tuple[tuple[str, ...], tuple[tuple[str, bool], ...]]:
    """A template with its messages put in: what stands around its values, and their names."""
    literals, fields = [""], []
    end = 0
    for match in FIELD.finditer(text):
        literals[-1] += text[end : match.start()]
        end = match.end()
        if match["value"]:
            fields.append((match["name"], match["safe"] is not None))
            literals.append("")
        else:
            literals[-1] += html.escape(told(match["name"], language))
    literals[-1] += text[end:]
    return tuple(literals), tuple(fields)


def render(
    page: Page,
    *,
    language: str,
    version: str,
    modules: Sequence[str],
    query: Sequence[tuple[str, str]] = (),
    values: Mapping[str, str] | None = None,
    rooms_open: Sequence[str] = tuple(NAVIGATION),
) -> str:
    """Return a whole page.

    Args:
        page: which kind.
        language: one that has a folder of messages.
        version: the assets' version.
        modules: what the page's module imports, to be fetched at once.
        query: the address's query without its language; links to the other languages keep it.
        values: what the page's own template asks for; `title` overrides the page's title.
        rooms_open: names of the pages that the bar leads to.
    """
    root = "../" * page.depth or "./"
    own = {"root": root, "assets": f"{root}static/{version}", "lang": language, **(values or {})}
    body = fill(template(page.name), language, own)
    return fill(
        template("shell"),
        language,
        {
            "title": told(page.title, language),
            **own,
            "page": page.name,
            "rooms": "+".join(("form", *page.rooms)),
            "body": body,
            "styles": "".join(_style(own["assets"], name) for name in page.styles),
            "preload": "".join(_preload(own["assets"], name) for name in modules),
            "navigation": "".join(_entry(name, root, language) for name in rooms_open),
            "language": _own_name(language),
            "languages": _language_links(language, query),
        },
    )


def _entry(name: str, root: str, language: str) -> str:
    address = html.escape(f"{root}{NAVIGATION[name][0]}?lang={language}")
    text = html.escape(told(NAVIGATION[name][1], language))
    return f'<a href="{address}" data-nav="{name}">{text}</a>'


def _style(assets: str, name: str) -> str:
    return f'<link rel="stylesheet" href="{assets}/css/{name}.css">\n'


def _preload(assets: str, name: str) -> str:
    return f'<link rel="modulepreload" href="{assets}/{name}">\n'


def _language_links(language: str, query: Sequence[tuple[str, str]]) -> str:
    """A link to this page in every language, with the rest of its query."""
    links = []
    rest = f"{urlencode(query)}&" if query else ""
    for code in languages():
        address = html.escape(f"?{rest}lang={code}")
        current = ' aria-current="true"' if code == language else ""
        links.append(
            f'<li><a href="{address}" lang="{code}" hreflang="{code}"{current}>'
            f"{html.escape(_own_name(code))}</a></li>"
        )
    return "".join(links)


def _own_name(language: str) -> str:
    """Return the name that a language gives itself."""
    return sentence(language, "language-name") or language
