"""Workbooks of strangers, read in a process that may take so much memory and time.

The reader makes every cell of the rectangle about those with something in them. In a format that is no XML
two cells of a small file are enough for gigabytes, and it ends its process where there are none left.
"""

import atexit
import io
import os
import pickle
from functools import lru_cache
from typing import Any, TypeAlias

from python_calamine import CalamineWorkbook

from service.adapters.workbook_extent import ExtentError, check_extent
from service.work.processes import Confinement, ProcessDiedError, UnansweredError, WorkerProcess
from service.work.worker_process import WorkOutcome

Sheet: TypeAlias = tuple[str, list[list[Any]]]

_CONFINED = Confinement(memory=1 << 30, seconds=20.0, niceness=0)
"""A process takes a third of this memory before it reads; the largest workbook here, less than the time."""
_TOO_MUCH = f"> {_CONFINED.memory >> 30} GiB, > {_CONFINED.seconds:.0f} s"
_PATIENCE = 120.0  # A process that has not answered for so long [s] is given up: the machine is overloaded.


class UnreadableError(Exception):
    """A workbook is damaged, or takes more than it may."""


def sheets_of(content: bytes, rows: int, cells: int) -> list[Sheet]:
    """Return the titles of a workbook's sheets, and what stands in their cells.

    Raises:
        UnreadableError: it is no workbook, a damaged one, or one that takes too much.
    """
    process = _process()
    task = pickle.dumps((_read_there, (content, rows, cells)), pickle.HIGHEST_PROTOCOL)
    try:
        outcome, value = pickle.loads(process.perform(task, _PATIENCE))  # noqa: S301  from our own process
    except (ProcessDiedError, UnansweredError) as error:
        _process.cache_clear()
        process.close()
        raise UnreadableError(_TOO_MUCH) from error
    if outcome == WorkOutcome.RESULT:
        found: list[Sheet] = value
        return found
    raise UnreadableError(str(value)[:200] if outcome == WorkOutcome.ERROR else _TOO_MUCH)


@lru_cache(maxsize=1)
def _process() -> WorkerProcess:
    """Return the process that reads; it starts with the first workbook, and again where one has ended it."""
    process = WorkerProcess(_CONFINED)
    atexit.register(process.close)
    return process


def _read_there(content: bytes, rows: int, cells: int) -> list[Sheet]:
    _be_silent()
    check_extent(content, cells)
    workbook = CalamineWorkbook.from_filelike(io.BytesIO(content))
    found = []
    left = cells
    for title in workbook.sheet_names:
        sheet = workbook.get_sheet_by_name(title)
        left -= sheet.total_height * sheet.total_width
        if left < 0:
            raise ExtentError(f"{sheet.total_height} × {sheet.total_width}")
        found.append((title, sheet.to_python(nrows=rows)))
    return found


def _be_silent() -> None:
    """What the reader says at its end is not for the person who grades."""
    with open(os.devnull, "wb") as nothing:
        os.dup2(nothing.fileno(), 2)
