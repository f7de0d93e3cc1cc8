"""`framewise people`: what is stored about a person, its erasure, and the end of what is old."""

import argparse
import json
import sys
from datetime import timedelta

from courses.people.privacy import erase_person, export_person, person_named, purge
from service.cli.backups import opened_store
from service.cli.environment import Subparsers, settings_of_environment
from service.course_resources import now


def add(subparsers: Subparsers) -> None:
    """Declare `people` with what it does."""
    actions = subparsers.add_parser("people", help="privacy: export, erase, purge").add_subparsers(
        required=True, metavar="action"
    )
    export = actions.add_parser("export", help="print everything that is stored about a person")
    export.add_argument("key", help="their pseudonym, or its beginning as the lecturers' page shows it")
    export.set_defaults(run=_export)
    erase = actions.add_parser("erase", help="remove a person with everything that is stored about them")
    erase.add_argument("key")
    erase.set_defaults(run=_erase)
    purging = actions.add_parser(
        "purge", help="remove what is older than FRAMEWISE_PEOPLE_DAYS and FRAMEWISE_ACCESS_DAYS"
    )
    purging.set_defaults(run=_purge)


def _export(options: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        _print(export_person(store, person_named(store, options.key)))


def _erase(options: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        _print(erase_person(store, person_named(store, options.key)))


def _purge(_: argparse.Namespace) -> None:
    settings = settings_of_environment()
    people, log = timedelta(days=settings.people_days), timedelta(days=settings.access_days)
    with opened_store(only_if_there=True) as store:
        _print(purge(store, now(), people=people, log=log))


def _print(found: object) -> None:
    sys.stdout.write(json.dumps(found, indent=2, ensure_ascii=False) + "\n")
