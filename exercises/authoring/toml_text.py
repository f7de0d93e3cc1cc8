"""A definition as TOML, in one form: the same definition gives the same text, and a change changes few lines.

What stands at the top of a definition comes first, then its tables in the order in which they are given. A
table of tables is written where people read it best: dimensions and their like line by line, rows and
points on a line each, parts under headings of their own.
"""

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any

WIDTH = 100  # Longer lists are broken into lines.

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_HEADINGS = frozenset({("figure", "points"), ("figure", "joints")})
"""Tables inside a table that have a heading of their own."""
_LISTS = frozenset({("parts",), ("figure", "dimensions"), ("tests", "samples")})
"""Lists whose entries have a heading each."""
_DOTTED = frozenset({("parameters",), ("remarks",)})
"""Tables of tables whose entries are written line by line: L1.value = 2."""
_BY_ROW = frozenset({"rows"})  # Lists with a line for each entry.


def toml_text(definition: Mapping[str, Any]) -> str:
    """Return the text of a definition.

    Raises:
        ValueError: a value is none that TOML knows, such as None.
    """
    top = {key: value for key, value in definition.items() if not _is_section((key,), value)}
    blocks = ["\n".join(_line(key, value) for key, value in top.items())]
    for key, value in definition.items():
        if key not in top:
            blocks += _section((key,), value)
    return "\n\n".join(block for block in blocks if block) + "\n"


def _is_section(where: tuple[str, ...], value: object) -> bool:
    if where in _LISTS:
        return isinstance(value, list) and bool(value) and all(isinstance(entry, dict) for entry in value)
    return isinstance(value, dict) and (len(where) == 1 or where in _HEADINGS)


def _section(where: tuple[str, ...], value: Any) -> Iterator[str]:
    if where in _LISTS:
        for entry in value:
            yield _block(f"[[{_path(where)}]]", entry)
        return
    inside = {key: entry for key, entry in value.items() if _is_section((*where, key), entry)}
    own = {key: entry for key, entry in value.items() if key not in inside}
    if own or not inside:
        yield _block(f"[{_path(where)}]", own, dotted=where in _DOTTED)
    for key, entry in inside.items():
        yield from _section((*where, key), entry)


def _block(heading: str, table: Mapping[str, Any], *, dotted: bool = False) -> str:
    lines = [heading]
    for key, value in table.items():
        if dotted and isinstance(value, dict) and value:
            lines += [_line(inner, entry, key) for inner, entry in value.items()]
        else:
            lines.append(_line(key, value))
    return "\n".join(lines)


def _line(key: str, value: object, *before: str) -> str:
    name = _path((*before, key))
    flat = f"{name} = {_value(value)}"
    if isinstance(value, list) and (key in _BY_ROW or len(flat) > WIDTH) and value:
        return f"{name} = [\n{_broken(key, value)}]"
    return flat


def _broken(key: str, entries: list[Any]) -> str:
    """Return the entries of a list: rows on a line each, others as many on a line as fit."""
    texts = [_value(entry) for entry in entries]
    lines = [""]
    for text in texts:
        if lines[-1] and (key in _BY_ROW or len(lines[-1]) + len(text) + 4 > WIDTH):
            lines.append("")
        lines[-1] += f"{' ' if lines[-1] else ''}{text},"
    return "".join(f"  {line}\n" for line in lines)


def _path(where: tuple[str, ...]) -> str:
    return ".".join(key if _BARE.fullmatch(key) else _text(key) for key in where)


def _value(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return _number(value)
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, list | tuple):
        return "[" + ", ".join(_value(entry) for entry in value) + "]"
    if isinstance(value, Mapping):
        inner = ", ".join(f"{_path((key,))} = {_value(entry)}" for key, entry in value.items())
        return f"{{ {inner} }}" if inner else "{}"
    raise ValueError(f"{type(value).__name__} is no value of TOML")


def _number(value: float) -> str:
    """Return a number; 2.0 is written 2, as readers take either."""
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return repr(value)


def _text(value: str) -> str:
    """Return a basic string: JSON's escapes are TOML's, except for DEL and half characters."""
    if any("\ud800" <= character <= "\udfff" for character in value):
        raise ValueError("half of a character is no text of TOML")
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007F")
