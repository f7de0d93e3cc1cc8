"""The kinds of part that there are: every module of this package and those in it that defines `PART`."""

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pkgutil import walk_packages
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from exercises.parts.protocol import PartType

PACKAGE = "exercises.parts"


@cache
def part_types() -> "Mapping[str, PartType[Any, Any, Any]]":
    """Return every part type by its kind, in alphabetical order."""
    path = import_module(PACKAGE).__path__
    modules = (import_module(found.name) for found in walk_packages(path, f"{PACKAGE}."))
    types: list[PartType[Any, Any, Any]] = [module.PART for module in modules if hasattr(module, "PART")]
    return MappingProxyType({found.kind: found for found in sorted(types, key=lambda found: found.kind)})


def part_type(kind: str) -> "PartType[Any, Any, Any]":
    """Return the part type of a kind.

    Raises:
        KeyError: there is none.
    """
    return part_types()[kind]
