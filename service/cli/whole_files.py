"""Files of grades that appear when they are complete: a command that fails leaves what was there."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TextIO

from kinematics.errors import Fault
from service.adapters.table_files import WORKBOOKS
from service.http.problems import RequestError


@contextmanager
def replacing(file: Path) -> Iterator[TextIO]:
    """Write text beside a file, and put it in its place at the end; write into a pipe or device at once.

    Raises:
        RequestError: the name is that of a spreadsheet, which would not open with text in it.
    """
    if file.suffix.lower() in WORKBOOKS:
        raise RequestError(Fault.at("marks_are_text", file=file.name))
    if file.exists() and not file.is_file():
        with file.open("w", encoding="utf-8", newline="") as stream:
            yield stream
        return
    whole = file.resolve()
    unfinished = whole.with_name(f"{whole.name}.part")
    try:
        stream = unfinished.open("w", encoding="utf-8", newline="")
    except OSError as error:
        error.filename = str(file)  # the name that somebody typed
        raise
    try:
        with stream:
            if whole.exists():
                shutil.copymode(whole, unfinished)
            yield stream
        unfinished.replace(whole)
    finally:
        unfinished.unlink(missing_ok=True)
