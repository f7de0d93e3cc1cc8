"""The document, narrowed to what callers mostly send: bodies of it come past the cells and names.

A string that is drawn from all strings is never the id of a robot and hardly ever a cell; drawn from this
document, it is. Whatever this document allows, the service's own allows.
"""

import copy
from typing import Any

from kinematics.catalogue import robot_ids
from tests.examples import SCARA_CHAIN, TWO_LINKS

CELLS = [0, 1, -0.5, 0.3, "pi/2", "-pi/2", "L1", "2*L1 + 0.1", "L2", "sqrt(2)/2"]
TURNS = ["q1", "q2", "q3 + pi/2", "0"]
_REAL = {"type": "number", "minimum": -4, "maximum": 4}
_NUMBERS_6 = {"type": "array", "items": _REAL, "minItems": 6, "maxItems": 6}
_STRAIGHT = [[1, 0, 0, 0.4], [0, 1, 0, 0.2], [0, 0, 1, 0.5], [0, 0, 0, 1]]
_TURNED = [[0, -1, 0, 0.3], [1, 0, 0, 0], [0, 0, 1, 0.1], [0, 0, 0, 1]]
_ROW = {
    "type": "object",
    "properties": {
        "joint": {"enum": ["revolute", "prismatic"]},
        "alpha": {"enum": [0, "pi/2", "-pi/2", 0.3]},
        "a": {"enum": CELLS},
        "d": {"enum": CELLS},
        "theta": {"enum": [0, "pi/2", 0.7]},
    },
    "required": ["joint", "alpha", "a", "d", "theta"],
    "additionalProperties": False,
}
_PARAMETERS = {
    "type": "object",
    "properties": {"L1": {"enum": [0.4, 1]}, "L2": {"enum": [0.3, 2]}},
    "required": ["L1", "L2"],
    "additionalProperties": False,
}


_WHOLE: dict[str, Any] = {
    "Table": TWO_LINKS,
    "ScmChainModel": SCARA_CHAIN,
    "ScrewProduct": {"screws": [{"linear": [0, 0, 0], "angular": [0, 0, 1]}], "home": _STRAIGHT},
}
"""One of each robot that bodies hold."""
_BESIDE = {"parameters": {"L1": 0.4, "L2": 0.3}, "limits": [[-1, 1], [-1, 1]], "name": "arm"}
"""What stands beside a robot."""


def with_whole_robots(document: dict[str, Any]) -> dict[str, Any]:
    """Return the document with an example of each robot, of each pose and of what goes with them.

    What is covered is one field at a time, beside a whole body; drawing a new robot and new poses for every
    such body would take nine tenths of the time, and hardly one of them would be computed with.
    """
    exemplary = copy.deepcopy(document)
    shapes = exemplary["components"]["schemas"]
    for name, example in _WHOLE.items():
        shapes[name]["example"] = example
    for shape in shapes.values():
        for name, field in shape.get("properties", {}).items():
            if name in _BESIDE:
                field["example"] = _BESIDE[name]
            elif _is_one_pose(field):
                field["example"] = [0.1, 0.2, 0.3, 0, 0, 0]
    shapes["ConvertRequest"] = _by_source(shapes["ConvertRequest"])
    return exemplary


def _by_source(shape: dict[str, Any]) -> dict[str, Any]:
    """Return the shape of a body that gives one of several fields as the shapes with each of them.

    It is the same, but for bodies that give two or none; drawing beside what 22 cases forbid takes eight
    times as long as all else.
    """
    forbidden = shape["not"]["anyOf"]
    (none_given,) = (case for case in forbidden if "required" not in case)
    sources = {name.strip("^$") for name in none_given["patternProperties"]}
    null = {"type": "null"}
    shapes = []
    for source in sorted(sources):
        others = sources - {source}
        properties = {name: field for name, field in shape["properties"].items() if name not in others}
        properties[source] = next(way for way in properties[source]["anyOf"] if way != null)
        cases = []
        for case in forbidden:
            told = {name.strip("^$"): value for name, value in case["patternProperties"].items()}
            if told.get(source) == null or any(told.get(name, null) != null for name in others):
                continue  # it never holds where this one alone is given
            left = {f"^{name}$": value for name, value in told.items() if name not in sources}
            cases.append(
                {"required": [*(n for n in case["required"] if n != source)], "patternProperties": left}
            )
        required = [*shape["required"], source]
        shapes.append({**shape, "properties": properties, "required": required, "not": {"anyOf": cases}})
    return {"anyOf": shapes}


def _is_one_pose(field: dict[str, Any]) -> bool:
    return any("a pose: 4×4" in entry.get("description", "") for entry in (field, *field.get("anyOf", ())))


def likely(document: dict[str, Any]) -> dict[str, Any]:
    """Return the document with tables of numbers, robots of the catalogue and lengths of a few metres."""
    narrowed = copy.deepcopy(document)
    for shape in narrowed["components"]["schemas"].values():
        _narrow(shape)
    narrowed["components"]["schemas"]["Row"] = _ROW
    return narrowed


def _narrow(shape: dict[str, Any]) -> None:
    for name, field in shape.get("properties", {}).items():
        if name == "robot":
            field["anyOf"] = [{"enum": list(robot_ids())}, {"type": "null"}]
        elif name == "parameters" and "additionalProperties" in field:
            shape["properties"][name] = _PARAMETERS
        elif name == "rows" and field.get("type") == "array":
            field["maxItems"] = 4
        elif "a pose: 4×4" in str(field):
            shape["properties"][name] = _poses(field)
    _bound(shape)


def _poses(field: dict[str, Any]) -> dict[str, Any]:
    one = {"anyOf": [{"enum": [_STRAIGHT, _TURNED]}, _NUMBERS_6]}
    choices = field.get("anyOf", [])
    if any(choice.get("type") == "array" and "description" in choice.get("items", {}) for choice in choices):
        return {"type": "array", "items": one, "minItems": 1, "maxItems": 3}
    return one


def _bound(node: Any) -> None:
    """Keep numbers without bounds small, and lists short; let cells be cells."""
    if isinstance(node, list):
        for entry in node:
            _bound(entry)
    if not isinstance(node, dict):
        return
    if node.get("description") == "a number or an expression":
        node.pop("anyOf", None)
        node["enum"] = CELLS
    if node.get("type") == "number" and not {"maximum", "exclusiveMaximum"} & set(node):
        node |= _REAL
    if node.get("type") == "array":
        node["maxItems"] = min(node.get("maxItems", 6), max(6, node.get("minItems", 0)))
    for key, entry in list(node.items()):
        if key not in ("enum", "const", "example", "examples"):
            _bound(entry)
