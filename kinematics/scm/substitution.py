"""Values in the place of a chain's parameters: the toolbox's S2D for chains that stay symbolic."""

from collections.abc import Mapping
from dataclasses import replace

from kinematics.cells.substitution import valued
from kinematics.errors import Fault, ParameterError
from kinematics.expressions import ZERO, Expression
from kinematics.scm.chain import Entry, Placement, ScmChain


def with_values(chain: ScmChain, values: Mapping[str, Expression]) -> ScmChain:
    """Return the chain with some of its parameters replaced.

    Raises:
        ParameterError: an entry now has no value (1/0, the root of -1), at ("joints", i, entry),
            ("final", entry) or ("tool", entry).
    """
    if not values:
        return chain
    faults: list[Fault] = []
    rows = tuple(
        replace(row, constant=_placement(row.constant, values, ("joints", i), faults))
        for i, row in enumerate(chain.rows)
    )
    final, tool = (_placement(getattr(chain, name), values, (name,), faults) for name in ("final", "tool"))
    if faults:
        raise ParameterError(faults)
    return ScmChain(rows=rows, final=final, tool=tool)


def _placement(
    placement: Placement, values: Mapping[str, Expression], where: tuple[str | int, ...], faults: list[Fault]
) -> Placement:
    entries: dict[str, Expression] = {}
    for entry in Entry:
        try:
            entries[entry.value] = valued(placement.entry(entry), values)
        except (ZeroDivisionError, ParameterError):
            entries[entry.value] = ZERO
            faults.append(Fault.at("value_undefined", *where, entry.value))
    return Placement(**entries)
