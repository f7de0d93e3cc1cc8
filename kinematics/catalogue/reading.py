"""A catalogue file to a robot: every fault at once, each with the file and the path of the key."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any, TypeVar

import numpy as np

from kinematics.catalogue.robots import Chain, Configuration, ReferencePose, Robot, Source
from kinematics.cells import AngleUnit, LengthUnit, RawRow, RawTable, ReadTable, bind_parameters, read_table
from kinematics.errors import DescriptionError, Fault, KinematicsError
from kinematics.scm import RawChain, ReadChain, read_chain
from kinematics.table import CELLS, Convention, JointType
from kinematics.transforms import check_transform

T = TypeVar("T")
Choice = TypeVar("Choice", bound=StrEnum)
Path = tuple[str | int, ...]

MESSAGES = {
    "file_not_toml": "this is not TOML: {reason}",
    "key_missing": "{key} is missing",
    "key_unknown": "there is no key {key} here; the keys are {allowed}",
    "key_type": "{key} must be {expected}",
    "joints_wrong_length": "the table has {expected} joints; give as many values",
    "limits_reversed": "joint {joint}: the lower limit must be below the upper one",
    "outside_limits": "joint {joint} of this configuration is outside its limits",
}


def read_robot(robot_id: str, text: str) -> Robot:
    """The robot that a catalogue file describes.

    Args:
        robot_id: the file's name without its ending.
        text: the file's content.

    Raises:
        DescriptionError: every fault, each at (file name, key, …).
    """
    file = f"{robot_id}.toml"
    reader = _Reader()
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise DescriptionError(_fault("file_not_toml", file, reason=str(error))) from None
    robot = reader.robot(robot_id, document)
    if robot is None or reader.faults:
        raise DescriptionError(fault.within(file) for fault in reader.faults)
    return robot


@dataclass(slots=True)
class _Reader:
    faults: list[Fault] = field(default_factory=list)

    def robot(self, robot_id: str, document: Mapping[str, Any]) -> Robot | None:
        keys = ("name", "source", "table", "reference")
        optional = ("parameters", "configurations", "limits", "chain")
        if not self._has(document, (), keys, optional):
            return None
        raw = self._table(document["table"])
        table = self._try(("table",), lambda: read_table(raw)) if raw else None
        parameters = self._numbers(document.get("parameters", {}), ("parameters",))
        if raw is None or table is None:
            return None
        self._try((), lambda: bind_parameters(table, parameters))
        limits = self._limits(document.get("limits"), table)
        source = document["source"]
        self._has(source, ("source",), ("document", "place", "figures"))
        reference = self._reference(document["reference"], table)
        if self.faults or reference is None:
            return None
        return Robot(
            id=robot_id,
            name=document["name"],
            source=Source(**source),
            raw=raw,
            table=table,
            parameters=parameters,
            configurations=self._configurations(document.get("configurations", {}), table, limits),
            limits=limits,
            chain=self._chain(document.get("chain"), raw),
            reference=reference,
        )

    def _table(self, table: Mapping[str, Any]) -> RawTable | None:
        if not self._has(table, ("table",), ("convention", "angle_unit", "length_unit", "rows")):
            return None
        rows: list[RawRow] = []
        for i, row in enumerate(table["rows"]):
            if self._has(row, ("table", "rows", i), ("joint", *CELLS)):
                cells = {name: row[name] for name in CELLS}
                joint = self._member(JointType, row["joint"], ("table", "rows", i, "joint"))
                rows.append(RawRow(joint=joint, **cells))
        convention = self._member(Convention, table["convention"], ("table", "convention"))
        angle_unit = self._member(AngleUnit, table["angle_unit"], ("table", "angle_unit"))
        length_unit = self._member(LengthUnit, table["length_unit"], ("table", "length_unit"))
        if convention is None or angle_unit is None or length_unit is None or self.faults:
            return None
        return RawTable(
            convention=convention, rows=tuple(rows), angle_unit=angle_unit, length_unit=length_unit
        )

    def _limits(
        self, limits: Mapping[str, Any] | None, table: ReadTable
    ) -> tuple[tuple[float, float], ...] | None:
        if limits is None or not self._has(limits, ("limits",), ("joints",)):
            return None
        pairs = [self._list(pair, ("limits", "joints", i), 2) for i, pair in enumerate(limits["joints"])]
        if len(pairs) != table.table.n_joints:
            self._refuse("joints_wrong_length", "limits", "joints", expected=table.table.n_joints)
        for i, pair in enumerate(pairs):
            if len(pair) == 2 and pair[0] >= pair[1]:
                self._refuse("limits_reversed", "limits", "joints", i, joint=i + 1)
        return tuple((pair[0], pair[1]) for pair in pairs if len(pair) == 2)

    def _configurations(
        self, found: Mapping[str, Any], table: ReadTable, limits: tuple[tuple[float, float], ...] | None
    ) -> dict[str, Configuration]:
        configurations = {}
        for name, entry in found.items():
            where: Path = ("configurations", name)
            if not self._has(entry, where, ("joints", "meaning")):
                continue
            joints = self._list(entry["joints"], (*where, "joints"), table.table.n_joints)
            for i, ((low, high), q) in enumerate(zip(limits or (), joints, strict=False)):
                if not low <= q <= high:
                    self._refuse("outside_limits", *where, "joints", i, joint=i + 1)
            configurations[name] = Configuration(joints=joints, meaning=entry["meaning"])
        return configurations

    def _reference(self, found: Mapping[str, Any], table: ReadTable) -> ReferencePose | None:
        if not self._has(found, ("reference",), ("derivation", "joints", "transform")):
            return None
        joints = self._list(found["joints"], ("reference", "joints"), table.table.n_joints)
        matrix = np.asarray(found["transform"], dtype=np.float64)
        transform = self._try(("reference", "transform"), lambda: check_transform(matrix))
        if transform is None:
            return None
        return ReferencePose(derivation=found["derivation"], joints=joints, transform=transform)

    def _chain(self, found: Mapping[str, Any] | None, raw: RawTable) -> Chain | None:
        if found is None or not self._has(found, ("chain",), ("joints", "final"), ("parameters",)):
            return None
        chain = RawChain(
            joints=tuple(dict(zip("xyzabc", row, strict=True)) for row in found["joints"]),
            final=dict(zip("xyzabc", found["final"], strict=True)),
            tool={},
            length_unit=raw.length_unit,
        )
        read: ReadChain | None = self._try(("chain",), lambda: read_chain(chain))
        if read is None:
            return None
        names = dict(found.get("parameters", {}))
        return Chain(read=read, parameters={name: names.get(name, name) for name in read.parameters})

    def _has(self, found: Any, where: Path, keys: tuple[str, ...], optional: tuple[str, ...] = ()) -> bool:
        if not isinstance(found, Mapping):
            self._refuse("key_type", *where, key=str(where[-1]), expected="a table")
            return False
        for key in keys:
            if key not in found:
                self._refuse("key_missing", *where, key, key=key)
        for key in found.keys() - set(keys) - set(optional):
            self._refuse("key_unknown", *where, key, key=key, allowed=", ".join((*keys, *optional)))
        return all(key in found for key in keys)

    def _list(self, found: Any, where: Path, length: int) -> tuple[float, ...]:
        if not isinstance(found, list) or not all(_is_number(value) for value in found):
            self._refuse("key_type", *where, key=str(where[-1]), expected="a list of finite numbers")
            return ()
        if len(found) != length:
            self._refuse("joints_wrong_length", *where, expected=length)
        return tuple(float(value) for value in found)

    def _numbers(self, found: Mapping[str, Any], where: Path) -> dict[str, float]:
        for name, value in found.items():
            if not _is_number(value):
                self._refuse("key_type", *where, name, key=name, expected="a finite number")
        return {name: float(value) for name, value in found.items() if _is_number(value)}

    def _member(self, kind: type[Choice], value: Any, where: Path) -> Choice | None:
        try:
            return kind(value)
        except ValueError:
            self._refuse("key_type", *where, key=str(where[-1]), expected=" or ".join(kind))
            return None

    def _try(self, where: Path, read: Callable[[], T]) -> T | None:
        try:
            return read()
        except KinematicsError as error:
            self.faults += [fault.within(*where) for fault in error.faults]
            return None

    def _refuse(self, code: str, *where: str | int, **params: str | int) -> None:
        self.faults.append(_fault(code, *where, **params))


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _fault(code: str, *where: str | int, **params: str | int) -> Fault:
    return Fault(code=code, message=MESSAGES[code].format(**params), where=where, params=params)
