"""`framewise backup`, `framewise restore`: the whole database in one file, and back."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from courses.backup import back_up, restore
from courses.storage import Store, open_store
from service.cli.environment import settings_of_environment


def add(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare `backup` and `restore`."""
    for name, text, run in (
        ("backup", "write courses and attempts to a file, while the service runs", _back_up),
        ("restore", "put a backup into an empty database", _restore),
    ):
        parser = subparsers.add_parser(name, help=text)
        parser.add_argument("file", type=Path)
        parser.set_defaults(run=run)


@contextmanager
def opened_store() -> Iterator[Store]:
    """The database of the environment's settings."""
    settings = settings_of_environment()
    store = open_store(settings.database_url, settings.data_folder)
    try:
        yield store
    finally:
        store.close()


def _back_up(options: argparse.Namespace) -> int:
    with opened_store() as store:
        count = back_up(store, options.file)
        sys.stdout.write(f"{options.file}: {count} rows from {store.location}\n")
    return 0


def _restore(options: argparse.Namespace) -> int:
    with opened_store() as store:
        count = restore(store, options.file)
        sys.stdout.write(f"{store.location}: {count} rows from {options.file}\n")
    return 0
