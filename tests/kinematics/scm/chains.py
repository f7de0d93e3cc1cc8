"""Chains to test with: written out by hand, and drawn by hypothesis."""

import numpy as np
from hypothesis import strategies as st

from kinematics.scm import RawChain, ReadChain, read_chain

ENTRIES = "xyzabc"


def placement(*cells):
    return dict(zip(ENTRIES, cells, strict=True))


def chain_of(*rows, final=(0,) * 6, tool=(0,) * 6) -> ReadChain:
    joints = tuple(placement(*row) for row in rows)
    return read_chain(RawChain(joints=joints, final=placement(*final), tool=placement(*tool)))


# Seed 001 eq. 3.1 and the script scm_stanford
STANFORD = (
    (0, 0, "L0", "a1", 0, 0),
    (0, "L1", 0, 0, "a2", 0),
    (0, 0, "d3", 0, 0, 0),
    (0, 0, 0, "a4", 0, 0),
    (0, 0, 0, 0, "a5", 0),
    (0, 0, "L2", "a6", 0, 0),
)
STANFORD_LENGTHS = {"L0": 0.412, "L1": 0.154, "L2": 0.263}


def elementary(entry, amount):
    """Translation along, or rotation about, one coordinate axis, written out element by element."""
    motion = np.eye(4)
    if entry in "xyz":
        motion[ENTRIES.index(entry), 3] = amount
        return motion
    c, s = np.cos(amount), np.sin(amount)
    i, j = {"a": (0, 1), "b": (2, 0), "c": (1, 2)}[entry]
    motion[i, i] = motion[j, j] = c
    motion[i, j], motion[j, i] = -s, s
    return motion


def product(cells, numbers, joint=None, q=0.0):
    """One row's motion as the product of six elementary ones; `numbers` gives names their values."""
    result = np.eye(4)
    for entry in ENTRIES:
        cell = cells[entry]
        sign = -1.0 if isinstance(cell, str) and cell.startswith("-") else 1.0
        name = cell.lstrip("-") if isinstance(cell, str) else None
        value = q if name is not None and name == joint else numbers.get(name, 0.0) if name else cell
        result = result @ elementary(entry, sign * value)
    return result


@st.composite
def strict_chains(draw):
    """Rows that `verify` accepts, 1 to 8 of them, with symbols for lengths and arbitrary turns at the end."""
    n = draw(st.integers(1, 8))
    rows = []
    for i in range(1, n + 1):
        sign = draw(st.sampled_from(["", "-"]))
        where = draw(st.sampled_from(ENTRIES))
        cells = dict.fromkeys(ENTRIES, 0)
        if where in "abc":
            cells.update(
                {e: draw(st.sampled_from([0, f"{e.upper()}{i}", f"-{e.upper()}{i}"])) for e in "xyz"}
            )
        cells[where] = f"{sign}q{i}"
        rows.append(cells)
    end = [{e: draw(st.sampled_from([0, f"{e}_{name}"])) for e in ENTRIES} for name in ("77", "88")]
    return rows, end[0], end[1]


@st.composite
def loose_chains(draw):
    """Rows of any form: constants in every entry, offsets in the variable's, 1 to 5 of them."""
    rows = []
    for i in range(1, draw(st.integers(1, 5)) + 1):
        cells = {
            e: draw(
                st.sampled_from([0, 0, 0.5, -1.25, f"{e.upper()}{i}"] if e in "xyz" else [0, 0, 0.3, "-pi/2"])
            )
            for e in ENTRIES
        }
        where = draw(st.sampled_from(ENTRIES))
        cells[where] = draw(st.sampled_from([f"q{i}", f"-q{i}", f"q{i}+0.5", f"0.25-q{i}"]))
        rows.append(cells)
    final = {e: draw(st.sampled_from([0, 0.4])) for e in ENTRIES}
    return read_chain(RawChain(joints=tuple(rows), final=final, tool={"y": 0.2, "b": "pi/3"}))
