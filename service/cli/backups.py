"""`framewise backup`, `restore`, `migrate`: the database in a file and back, and at the newest schema."""

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from courses.links.course_links import MOST_DIGITS
from courses.refusals import StorageError
from courses.storage.backup import back_up, restore
from courses.storage.database import Store, open_store, revision_of
from kinematics.errors import Fault
from service.cli.environment import Subparsers, count, settings_of_environment


def add(subparsers: Subparsers) -> None:
    """Declare `backup`, `restore` and `migrate`."""
    for name, text, run in (
        ("backup", "write courses and attempts to a file, while the service runs", _back_up),
        ("restore", "put a backup into an empty database", _restore),
    ):
        parser = subparsers.add_parser(name, help=text)
        parser.add_argument("file", type=Path)
        parser.set_defaults(run=run)
    migrating = subparsers.add_parser("migrate", help="migrate the database to the newest schema and exit")
    migrating.set_defaults(run=_migrate)


@contextmanager
def opened_store(*, only_if_there: bool = False) -> Iterator[Store]:
    """Open the database of the environment's settings.

    Args:
        only_if_there: refuse to make one: a command that reads would find nothing in it.

    Raises:
        StorageError: storage is switched off, or the database is not there or cannot be used.
    """
    settings = settings_of_environment()
    if settings.storage == "off":
        raise StorageError(Fault.at("storage_off"))
    store = open_store(settings.database_url, settings.data_folder, only_if_there=only_if_there)
    try:
        yield store
    finally:
        store.close()


def record_number(text: str) -> int:
    """Return the number of a platform or course, as a command lists it."""
    if len(text) > MOST_DIGITS:
        raise argparse.ArgumentTypeError(f"nothing here has a number such as {text}")
    return count(text)


def _back_up(options: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        count = back_up(store, options.file)
        told = sys.stdout if options.file.is_file() else sys.stderr  # the backup itself may go to the output
        told.write(f"{options.file}: {count} rows from {store.location}\n")


def _restore(options: argparse.Namespace) -> None:
    with opened_store() as store:
        count = restore(store, options.file)
        sys.stdout.write(f"{store.location}: {count} rows from {options.file}\n")


def _migrate(_: argparse.Namespace) -> None:
    with opened_store() as store:
        sys.stdout.write(f"{store.location}: {revision_of(store)}\n")
