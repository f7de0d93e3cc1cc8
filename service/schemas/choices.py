"""Which fields of a request exclude or need each other, as a JSON Schema says it.

It is said by `not` and `patternProperties` alone: generators of clients leave those aside, and take `oneOf`,
`allOf` and any `properties` for further shapes. Null counts as left out.
"""

from collections.abc import Iterable, Mapping
from itertools import combinations
from typing import Any

from pydantic import ConfigDict

_NULL = {"type": "null"}
_GIVEN = {"not": _NULL}


def together(*names: str, without: Iterable[str] = (), **others: Mapping[str, Any]) -> dict[str, Any]:
    """Return the schema of the objects that give these fields at once.

    Args:
        without: fields that are left out in them.
        others: what else holds there, a schema for each further field.
    """
    shapes = {**dict.fromkeys(names, _GIVEN), **dict.fromkeys(without, _NULL), **others}
    patterns = {f"^{name}$": shape for name, shape in shapes.items()}
    return (
        {"required": list(names), "patternProperties": patterns} if names else {"patternProperties": patterns}
    )


def several_of(*names: str) -> list[dict[str, Any]]:
    """Return schemas of the objects that give more than one of these fields."""
    return [together(*pair) for pair in combinations(names, 2)]


def not_one_of(*names: str) -> list[dict[str, Any]]:
    """Return schemas of the objects that give none of these fields, or more than one."""
    return [together(without=names), *several_of(*names)]


def forbidding(*cases: Mapping[str, Any]) -> ConfigDict:
    """Return the configuration of a model whose objects are none of these."""
    return ConfigDict(json_schema_extra={"not": {"anyOf": [dict(case) for case in cases]}})
