"""What somebody may have meant who typed a name that does not exist."""

import re
from collections.abc import Collection

from kinematics.cells.scanner import canonical_name

_CONFUSED = str.maketrans("oOlI", "0011")  # Letters that are taken for digits: O for 0, l and I for 1.
_DIGITS = re.compile(r"[0-9]+")
_RATE = re.compile(
    r"d(?:theta|th)_?([0-9]+)|(?:q|theta|th)_?(?:dot|p)_?([0-9]+)|(?:q|theta|th)_?([0-9]+)_?(?:dot|p)"
)
"""What a joint's rate is called elsewhere: dtheta1, qdot1, q1_dot, qp1."""
_MARKED_RATE = re.compile(
    r"(?<![A-Za-z0-9_])(?:"
    r"d ?(?:q|θ|ϑ|theta|th)_?([0-9]+) ?/ ?dt(?![A-Za-z0-9_])"
    r"|d ?[θϑ]_?([0-9]+)(?![0-9_])"
    r"|(?:q|θ|ϑ|theta|th)_?([0-9]+) ?['’′](?!['’′])"
    r")"
)
"""A joint's rate in marks that no cell has: dq1/dt, dθ1, q1'; two primes are its acceleration."""


def nearest_name(name: str, known: Collection[str]) -> str | None:
    """Return the known name that a name most likely stands for, or None where there is none, or several.

    Names are the same but for case or underscores (A2 for a2, F_x for fx), for letters that look like digits
    (L0 for LO), or for one letter left out, put in, changed or exchanged with its neighbour; their numbers
    agree. Or both are the rate of one joint (q1_dot for dq1), or an a is written as α where no name is (α2).
    """
    typed = canonical_name(name) or name
    names = {canonical_name(candidate) or candidate for candidate in known}
    if typed in names:
        return typed
    for same in (_ignoring_case, _looking_alike, _one_rate, _one_slip_apart):
        found = {candidate for candidate in names if same(typed, candidate)}
        if found:
            return found.pop() if len(found) == 1 else None
    if typed.startswith("alpha") and not any(candidate.startswith("alpha") for candidate in names):
        latin = typed.removeprefix("alph")
        return latin if latin in names else None
    return None


def rate_in_marks(text: str, known: Collection[str]) -> tuple[str, str] | None:
    """Return the first joint rate in a cell that is in marks of calculus, as typed and as it is named here.

    None where there is none, where its name means nothing, or where d or dt is a name of its own.

    Args:
        text: the cell: dq1/dt, dθ1 and q1' all stand for dq1.
        known: the names that mean something.
    """
    if not {"d", "dt"}.isdisjoint(known):
        return None
    for found in _MARKED_RATE.finditer(text):
        name = f"dq{next(filter(None, found.groups()))}"
        if name in known:
            return found[0], name
    return None


def _ignoring_case(a: str, b: str) -> bool:
    return a.replace("_", "").lower() == b.replace("_", "").lower()


def _looking_alike(a: str, b: str) -> bool:
    return a.translate(_CONFUSED).lower() == b.translate(_CONFUSED).lower()


def _one_rate(a: str, b: str) -> bool:
    found = _RATE.fullmatch(a.lower())
    return found is not None and b == f"dq{next(filter(None, found.groups()))}"


def _one_slip_apart(a: str, b: str) -> bool:
    if _DIGITS.findall(a) != _DIGITS.findall(b) or max(len(a), len(b)) < 3:
        return False
    a, b = sorted((a.lower(), b.lower()), key=len)
    if len(b) - len(a) > 1:
        return False
    start = next((i for i, (x, y) in enumerate(zip(a, b, strict=False)) if x != y), len(a))
    if len(a) < len(b):
        return a[start:] == b[start + 1 :]
    exchanged = a[:start] + a[start : start + 2][::-1] + a[start + 2 :]
    return a[start + 1 :] == b[start + 1 :] or exchanged == b
