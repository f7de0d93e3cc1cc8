"""What goes wrong in kinematics, and where.

    KinematicsError
    ├── CellError          a cell of a DH table cannot be read
    ├── TableError         the rows do not form a DH table
    ├── ParameterError     a parameter is missing, unused or not finite
    ├── JointValueError    joint values of the wrong number, or not finite
    ├── PoseError          a 4x4 matrix is not a rigid motion, or a pose notation is malformed
    ├── DescriptionError   a robot described by axes, an SCM chain, URDF or a catalogue file is malformed
    └── FormSizeError      a closed form would be larger than its limit

An error carries one or more faults, so that a caller sees all of them at once. Unreachable, singular and
"not the same robot" are results, never errors. No error knows an HTTP status.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

ParamValue = str | int | float | tuple[str, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Fault:
    """One thing that is wrong.

    Attributes:
        code: stable identifier in snake_case; `error-<code>` is the sentence in every language.
        where: path from the object that was read to the offending value, such as ("rows", 2, "alpha").
        params: the values that the sentence mentions, by name.
    """

    code: str
    where: tuple[str | int, ...] = ()
    params: Mapping[str, ParamValue] = field(default_factory=dict)

    @classmethod
    def at(cls, code: str, /, *where: str | int, **params: ParamValue) -> "Fault":
        """Return a fault at a place, with the values that its sentence mentions."""
        return cls(code=code, where=where, params=params)

    def __str__(self) -> str:
        """Return code, place and parameters on one line."""
        place = " at " + ".".join(str(part) for part in self.where) if self.where else ""
        values = ", ".join(f"{name}={value}" for name, value in self.params.items())
        return f"{self.code}{place}" + (f" ({values})" if values else "")

    def within(self, *prefix: str | int) -> "Fault":
        """Return the same fault, placed in an enclosing object that contains the read one at `prefix`."""
        return Fault(code=self.code, where=(*prefix, *self.where), params=self.params)


class FaultyError(Exception):
    """One or more faults; each package derives the root of its errors from it."""

    def __init__(self, faults: Fault | Iterable[Fault]) -> None:
        self.faults: tuple[Fault, ...] = (faults,) if isinstance(faults, Fault) else tuple(faults)
        super().__init__("; ".join(map(str, self.faults)))

    def __reduce__(self) -> "tuple[type[FaultyError], tuple[tuple[Fault, ...]]]":
        """Errors travel from worker processes with their faults."""
        return type(self), (self.faults,)

    @property
    def code(self) -> str:
        """The code of the first fault."""
        return self.faults[0].code


class KinematicsError(FaultyError):
    """Root of this package's errors."""


class CellError(KinematicsError):
    """A cell of a DH table cannot be read."""


class TableError(KinematicsError):
    """The rows do not form a DH table."""


class ParameterError(KinematicsError):
    """A parameter is missing, unused or not finite."""


class JointValueError(KinematicsError):
    """Joint values of the wrong number or shape, or not finite."""


class PoseError(KinematicsError):
    """A matrix is not a rigid motion, or a pose notation is malformed."""


class DescriptionError(KinematicsError):
    """A robot described by axes, an SCM chain, URDF or a catalogue file is malformed."""


class FormSizeError(KinematicsError):
    """A closed form would be larger than its limit."""
