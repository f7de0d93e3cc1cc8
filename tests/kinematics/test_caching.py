"""What is remembered is bounded, however long the cells and tables are that callers send."""

import gc
import tracemalloc

from kinematics.caching import cached_by_size
from kinematics.cells import AngleUnit, RawRow, RawTable, bind_parameters, read_table
from kinematics.cells.rows import row_meaning, row_syntax
from kinematics.equivalence import BaseRule, Policy, ZeroRule
from kinematics.equivalence.home_invariants import home_invariants_of
from kinematics.equivalence.invariants import invariants_of
from kinematics.equivalence.reference import prepared
from kinematics.table import Convention, DHRow, DHTable, JointType

MOST = 5 * 1024 * 1024
"""What all that is remembered may hold [byte] while twenty tables as long as may be are read."""


def cell(number: int) -> str:
    """A cell of nearly two hundred characters that is no other one."""
    return " + ".join(f"sin({number}+a{k % 5})*L{k % 7}" for k in range(9))


def test_long_tables_are_not_hoarded() -> None:
    values = {**{f"L{k}": 1.0 for k in range(7)}, **{f"a{k}": 1.0 for k in range(5)}}
    read_and_bound(0, values)
    tracemalloc.start()
    try:
        for number in range(1, 21):
            read_and_bound(1000 * number, values)
        gc.collect()
        held, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert held < MOST


def test_long_tables_of_numbers_are_not_hoarded() -> None:
    """A number has no characters, but what is read of it takes as much room as a short text."""
    read_of_numbers(0)
    tracemalloc.start()
    try:
        for number in range(1, 101):
            read_of_numbers(number)
        row_syntax.cache_clear()  # some thousand rows, whatever the tables
        row_meaning.cache_clear()
        gc.collect()
        held, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert held < 0.5 * MOST


def read_of_numbers(number: int) -> None:
    """Read a table of 64 rows that is no other one, with decimals in all its cells but a few."""
    rows = [
        RawRow(alpha=0.25, a=number + 0.125 * k, d=number + 0.0625 * k, theta=f"q{k + 1}") for k in range(64)
    ]
    table = RawTable(convention=Convention.STANDARD, angle_unit=AngleUnit.RAD, rows=tuple(rows))
    bind_parameters(read_table(table), {})


def test_references_of_many_rows_are_not_hoarded() -> None:
    """A caller who sent nothing else made a process hold half a gigabyte of them."""
    invariants_held_of(0)
    tracemalloc.start()
    try:
        for number in range(1, 61):
            invariants_held_of(number)
        gc.collect()
        held, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert held < 1.5 * MOST


def invariants_held_of(number: int) -> None:
    """Prepare a table of 64 rows that is no other one, and what is known of it."""
    rows = [
        DHRow(joint=JointType.REVOLUTE, alpha=0.5, a=1.0 + number, d=0.25 * i, theta=0.0) for i in range(64)
    ]
    reference = prepared(DHTable(convention=Convention.STANDARD, rows=tuple(rows)))
    policy = Policy(base=BaseRule.FRAME, zero=ZeroRule.FIGURE)
    assert invariants_of(reference, policy).shapes
    assert home_invariants_of(reference, policy).shapes


def read_and_bound(number: int, values: dict[str, float]) -> None:
    rows = tuple(
        RawRow(alpha=0, a=cell(number + 2 * row), d=cell(number + 2 * row + 1), theta=f"q{row}")
        for row in range(1, 17)
    )
    read = read_table(RawTable(convention=Convention.STANDARD, rows=rows, angle_unit=AngleUnit.RAD))
    bind_parameters(read, {name: values[name] for name in read.parameters})


def test_many_short_answers_are_remembered_and_few_long_ones() -> None:
    asked: list[str] = []

    @cached_by_size(len, longest=3, most=100, few=2)
    def answer(text: str) -> str:
        asked.append(text)
        return text

    questions = ["a", "b", "c", "long one", "longer one", "longest one"]
    for _ in range(2):
        for question in questions:
            assert answer(question) == question
    assert asked == [*questions, *questions[3:]]
    assert answer("longest one") == "longest one"
    assert asked[-1] == "longest one"
    assert len(asked) == 9
    answer.cache_clear()
    answer("a")
    answer("longest one")
    assert asked[9:] == ["a", "longest one"]
