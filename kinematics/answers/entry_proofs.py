"""Are the entries of an answer the same functions as a key's? Proofs, one by one and all together.

Most entries are polynomials in sines and cosines, or quotients of these (`kinematics.symbolic.polynomials`);
the others are sums of exponentials (`kinematics.symbolic.canonical`).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from kinematics.errors import FormSizeError
from kinematics.expressions import Expression
from kinematics.symbolic import ProofStatus
from kinematics.symbolic.canonical import compare_all
from kinematics.symbolic.polynomials import ONE, Polynomial, PolynomialReader
from kinematics.symbolic.quotients import quotient_of

PRODUCTS = 100_000
"""Products of terms that a proof may form, some 50 ms; all entries of a Jacobian of a PUMA need a tenth."""

Quotient: TypeAlias = tuple[Polynomial, Polynomial]


@dataclass(frozen=True, kw_only=True, slots=True)
class FormKey:
    """Entries in closed form, row by row, and what they are as quotients of polynomials, if they are."""

    entries: tuple[Expression, ...]
    quotients: tuple[Quotient | None, ...]
    reader: PolynomialReader

    def unlike(self, given: Sequence[Expression]) -> tuple[list[int], list[int]]:
        """Return which entries of an answer are not proved to be these, and which are proved to be others."""
        reader, unlike, refuted = self.reader.copy(), [], []
        for k, (entry, ours) in enumerate(zip(given, self.quotients, strict=True)):
            found = None if ours is None else _quotient(reader, entry)
            if found is None or ours is None:
                if entry != self.entries[k]:
                    unlike.append(k)
            elif found != ours:
                crosswise = (found[0], ours[1]), (ours[0], found[1])
                products = [p if q is ONE else reader.product((p, q)) for p, q in crosswise]
                if None in products or products[0] != products[1]:
                    unlike.append(k)
                    refuted += [] if None in products else [k]
        return unlike, refuted


def key_of(entries: tuple[Expression, ...]) -> FormKey:
    """Return entries as a key that answers are compared with."""
    reader = PolynomialReader()
    return FormKey(entries=entries, quotients=tuple(_quotient(reader, e) for e in entries), reader=reader)


def _quotient(reader: PolynomialReader, entry: Expression) -> Quotient | None:
    """Return an entry as a quotient of polynomials; None if it is none, or divides by zero."""
    found = reader.read(entry)
    if found is not None:
        return found, ONE
    top, bottoms = quotient_of(entry)
    if not bottoms:
        return None
    above, *below = (reader.read(part) for part in (top, *bottoms))
    under = reader.product([part for part in below if part])
    return (above, under) if above is not None and under and all(below) else None


def proved(pairs: Iterable[tuple[Expression, Expression]]) -> ProofStatus:
    """Return whether each pair of entries is one function."""
    try:
        return compare_all(((given, ours) for given, ours in pairs if given != ours), limit=PRODUCTS)
    except (FormSizeError, ZeroDivisionError):
        return ProofStatus.UNDECIDED
