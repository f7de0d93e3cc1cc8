"""What the links of an arm weigh: as a definition says it, and as a page shows it."""

from collections.abc import Sequence

from exercises.definition import DrawnParameter
from exercises.draws import read_draw
from exercises.parts.task import GivenNumbers
from exercises.reading import KeyShape, Reader
from kinematics.cells import Cell
from kinematics.dynamics.reading import NOTHING, RawBody

_COLUMNS = ("m [kg]", "x", "y", "z", "Ixx", "Iyy", "Izz")


def read_links(reader: Reader) -> tuple[RawBody, ...]:
    """Return what the links weigh, in cells; faults go to the reader."""
    reader.note("links", KeyShape.BODIES)
    links = []
    for entry in reader.entries("links", needed=True):
        links.append(
            RawBody(
                mass=_cell(entry, "mass"),
                centre=read_three(entry, "centre"),
                inertia=tuple(
                    tuple(value if i == k else 0 for k in range(3))
                    for i, value in enumerate(read_three(entry, "moments"))
                ),
            )
        )
        entry.finish()
    return tuple(links)


def read_weights(reader: Reader) -> tuple[DrawnParameter, ...]:
    """Return the values of the names in these; faults go to the reader."""
    reader.note("weights", KeyShape.QUANTITIES)
    weights = []
    for name, inner in reader.tables("weights"):
        weights.append(
            DrawnParameter(name=inner.name(name), value=inner.exact("value"), draw=read_draw(inner, "draw"))
        )
        inner.finish()
    return tuple(weights)


def given_links(links: Sequence[RawBody], unit: str) -> GivenNumbers:
    """Return what the links weigh, without the columns in which everything is zero."""
    table = [(link.mass, *link.centre, *(link.inertia[i][i] for i in range(3))) for link in links]
    kept = [k for k in range(len(_COLUMNS)) if k == 0 or any(row[k] != 0 for row in table)]
    labels = tuple(f"{name} [{unit}]" if name in ("x", "y", "z") else name for name in _COLUMNS)
    return GivenNumbers(
        name="link-weights",
        labels=("i", *(labels[k] for k in kept)),
        rows=tuple((str(i), *(str(row[k]) for k in kept)) for i, row in enumerate(table, 1)),
        values={"unit": unit},
    )


def units_of_names(links: Sequence[RawBody], gravity: Sequence[Cell], unit: str) -> dict[str, str]:
    """Return the unit of each name that stands alone for one kind: mass, length, moment or acceleration."""
    places = [(cell, f"{unit}/s²") for cell in gravity]
    for link in links:
        places += [(link.mass, "kg"), *((cell, unit) for cell in link.centre)]
        places += [(cell, f"kg {unit}²") for row in link.inertia for cell in row]
    found: dict[str, set[str]] = {}
    for cell, measured in places:
        found.setdefault(str(cell).lstrip("+- "), set()).add(measured)
    return {name: units.pop() for name, units in found.items() if len(units) == 1}


def _cell(reader: Reader, key: str) -> Cell:
    value = reader.values.get(key) if reader.given(key) else 0
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        reader.fault("motion_cell", key)
        return 0
    return value


def read_three(reader: Reader, key: str) -> tuple[Cell, ...]:
    """Return three cells; zeros where they are left out."""
    reader.note(key, KeyShape.CELLS, ("x", "y", "z"))
    value = reader.values.get(key) if reader.given(key) else NOTHING
    entries = tuple(value) if isinstance(value, list | tuple) else ()
    good = all(isinstance(entry, int | float | str) and not isinstance(entry, bool) for entry in entries)
    if len(entries) != len(NOTHING) or not good:
        reader.fault("motion_cell", key)
        return NOTHING
    return entries
