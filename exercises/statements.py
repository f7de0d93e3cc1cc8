"""Statements: a small, safe part of Markdown, read once and written as HTML.

Paragraphs, `-` and `1.` lists, `## headings`, *emphasis*, **strong emphasis** and `code`. Emphasis around the
name of a dimension or a point (*L1*, *P*) makes it a variable, its digits an index. Everything else is text.
"""

import re
from collections.abc import Iterator
from html import escape

from kinematics.errors import Fault

LONGEST_TITLE = 200
LONGEST_STATEMENT = 20_000  # Characters; some ten pages.

_INLINE = re.compile(r"`([^`]+)`|\*\*([^*]+)\*\*|\*([^*\s](?:[^*]*[^*\s])?)\*")
_NAME = re.compile(r"([A-Za-z]{1,3})_?([0-9]{0,2})")
_HEADING = re.compile(r"(#{2,4}) +(.+)")
_BULLET = re.compile(r"[-*] +(.+)")
_NUMBERED = re.compile(r"[0-9]+[.)] +(.+)")
_TAG = re.compile(r"<[A-Za-z/!?][^<>]{0,20}")
_CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
"""What no text needs; the last two ranges turn the direction of writing and make a text look like another."""


def to_html(markdown: str) -> str:
    """Return the statement as HTML; no markup of the source survives but what is listed above."""
    return "\n".join(_blocks(markdown))


def text_faults(text: str, longest: int) -> Iterator[Fault]:
    """Yield what a lecturer's text must not hold.

    HTML or SVG, control characters, more than so many characters.

    None of it would ever be taken for markup; it would be shown as it stands, which nobody wants to read.
    """
    if len(text) > longest:
        yield Fault.at("text_too_long", limit=longest)
    if found := _TAG.search(text):
        yield Fault.at("text_markup", found=found[0])
    if control := _CONTROL.search(text.replace("\r\n", "\n")):
        yield Fault.at("text_control_character", found=f"U+{ord(control[0]):04X}")


def variable_html(name: str) -> str:
    """Return a dimension's name, typeset: <var>L<sub>1</sub></var>."""
    match = _NAME.fullmatch(name)
    if match is None:
        return f"<var>{escape(name)}</var>"
    index = f"<sub>{match[2]}</sub>" if match[2] else ""
    return f"<var>{match[1]}{index}</var>"


def names_in(markdown: str) -> frozenset[str]:
    """Return the names of dimensions and points that a statement speaks of."""
    return frozenset(
        match[3] for match in _INLINE.finditer(markdown) if match[3] is not None and _NAME.fullmatch(match[3])
    )


def _blocks(markdown: str) -> Iterator[str]:
    for block in re.split(r"\n[ \t]*\n", markdown.strip()):
        lines = [line.strip() for line in block.strip().splitlines()]
        heading = _HEADING.fullmatch(lines[0]) if lines else None
        if heading and len(lines) == 1:
            level = len(heading[1]) + 1
            yield f"<h{level}>{_inline(heading[2])}</h{level}>"
            continue
        for tag, pattern in (("ul", _BULLET), ("ol", _NUMBERED)):
            items = [pattern.fullmatch(line) for line in lines]
            if lines and all(items):
                body = "".join(f"<li>{_inline(item[1])}</li>" for item in items if item)
                yield f"<{tag}>{body}</{tag}>"
                break
        else:
            if lines:
                yield f"<p>{_inline(' '.join(lines))}</p>"


def _inline(text: str) -> str:
    parts: list[str] = []
    end = 0
    for match in _INLINE.finditer(text):
        parts += [escape(text[end : match.start()]), _marked(match)]
        end = match.end()
    return "".join([*parts, escape(text[end:])])


def _marked(match: re.Match[str]) -> str:
    code, strong, emphasis = match.groups()
    if code is not None:
        return f"<code>{escape(code)}</code>"
    if strong is not None:
        return f"<strong>{escape(strong)}</strong>"
    return variable_html(emphasis) if _NAME.fullmatch(emphasis) else f"<em>{escape(emphasis)}</em>"


def first_sentence(markdown: str) -> str:
    """Return the first sentence of a statement as plain text."""
    block = next(
        (block for block in re.split(r"\n[ \t]*\n", markdown.strip()) if not block.startswith("#")), ""
    )
    text = _INLINE.sub(lambda match: match[1] or match[2] or match[3], " ".join(block.split()))
    end = re.search(r"[.!?](?=\s|$)", text)
    return text[: end.end()] if end else text
