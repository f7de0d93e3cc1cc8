"""What a link weighs: mass, centre of mass and inertia, in numbers or as expressions."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Generic, TypeAlias, TypeVar

import numpy as np

from kinematics.errors import DescriptionError, Fault
from kinematics.expressions import Expression, evaluate_each

Entry = TypeVar("Entry")

SYMMETRIC = 1e-6
"""How far an inertia may be from symmetric, and below zero, as a share of its largest entry: six decimals."""


@dataclass(frozen=True, kw_only=True, slots=True)
class RigidBody(Generic[Entry]):
    """A rigid body that moves with a frame of a DH table.

    Attributes:
        mass: m [kg].
        centre: centre of mass in the frame [m].
        inertia: 3×3 moments of inertia about the centre of mass, in the axes of the frame [kg m²].
    """

    mass: Entry
    centre: tuple[Entry, Entry, Entry]
    inertia: tuple[tuple[Entry, Entry, Entry], ...]

    def entries(self) -> Iterator[tuple[tuple[str | int, ...], Entry]]:
        """Yield every entry with its place in the link."""
        yield ("mass",), self.mass
        for i, entry in enumerate(self.centre):
            yield ("centre", i), entry
        for i, row in enumerate(self.inertia):
            for j, entry in enumerate(row):
                yield ("inertia", i, j), entry


NumericBody: TypeAlias = RigidBody[float]
SymbolicBody: TypeAlias = RigidBody[Expression]


def bind_links(links: Sequence[SymbolicBody], parameters: Mapping[str, float]) -> tuple[NumericBody, ...]:
    """Return the links in numbers.

    Args:
        links: entries exact, possibly with parameters.
        parameters: value of every parameter [kg, m, kg m²].

    Raises:
        ParameterError: a parameter has no value, or an entry has none that is finite; all faults at once,
            each at ("parameters", name) or ("links", i, …).
    """
    entries = ((("links", i, *at), entry) for i, link in enumerate(links) for at, entry in link.entries())
    values = evaluate_each(entries, parameters)
    found = []
    for i in range(0, len(values), 13):
        m, x, y, z, *rest = values[i : i + 13]
        rows = tuple((rest[k], rest[k + 1], rest[k + 2]) for k in (0, 3, 6))
        found.append(RigidBody(mass=m, centre=(x, y, z), inertia=rows))
    return tuple(found)


def check_links(links: Sequence[NumericBody]) -> None:
    """Make sure that links are bodies that can be.

    Raises:
        DescriptionError: a mass is negative, or an inertia is not symmetric or has a negative moment, each at
            ("links", i, …).
    """
    faults = []
    for i, link in enumerate(links):
        if link.mass < 0.0:
            faults.append(Fault.at("mass_negative", "links", i, "mass", mass=f"{link.mass:g}"))
        inertia = np.array(link.inertia)
        allowed = SYMMETRIC * float(np.abs(inertia).max())
        where = ("links", i, "inertia")
        if np.abs(inertia - inertia.T).max() > allowed:
            faults.append(Fault.at("inertia_not_symmetric", *where))
        elif allowed and np.linalg.eigvalsh(inertia).min() < -allowed:
            faults.append(Fault.at("inertia_negative", *where))
    if faults:
        raise DescriptionError(faults)
