"""What is remembered of cells is bounded by its length, however long the cells are that callers send."""

from __future__ import annotations

import gc
import tracemalloc

from kinematics.cells import AngleUnit, RawRow, RawTable, bind_parameters, read_table
from kinematics.cells.remembering import remembered
from kinematics.table import Convention

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


def read_and_bound(number: int, values: dict[str, float]) -> None:
    rows = tuple(
        RawRow(alpha=0, a=cell(number + 2 * row), d=cell(number + 2 * row + 1), theta=f"q{row}")
        for row in range(1, 17)
    )
    read = read_table(RawTable(convention=Convention.STANDARD, rows=rows, angle_unit=AngleUnit.RAD))
    bind_parameters(read, {name: values[name] for name in read.parameters})


def test_many_short_answers_are_remembered_and_few_long_ones() -> None:
    asked: list[str] = []

    @remembered(len, longest=3, most=100, few=2)
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
