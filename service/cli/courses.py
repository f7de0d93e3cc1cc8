"""`framewise courses`: what is stored of each course, and its erasure."""

import argparse
import json
import sys
from dataclasses import asdict

from courses.teaching.course_erasure import erase_course, held_courses
from service.cli.backups import opened_store, record_number
from service.cli.environment import Subparsers
from service.course_resources import now


def add(subparsers: Subparsers) -> None:
    """Declare `courses` with what it does."""
    actions = subparsers.add_parser("courses", help="list and erase courses").add_subparsers(
        required=True, metavar="action"
    )
    actions.add_parser("list", help="print what is stored of each course, as a line of JSON").set_defaults(
        run=_list
    )
    erase = actions.add_parser("erase", help="remove a course with all that it has stored of its people")
    erase.add_argument("course", type=record_number, help="its number: `id` in the list")
    erase.add_argument("--yes", action="store_true", required=True, help="attempts and grades are lost")
    erase.add_argument(
        "--with-unsent", action="store_true", help="also scores that the gradebook has not received"
    )
    erase.set_defaults(run=_erase)


def _list(_: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        for course in held_courses(store):
            sys.stdout.write(json.dumps(asdict(course), ensure_ascii=False) + "\n")


def _erase(options: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        removed = erase_course(store, options.course, now(), with_unsent=options.with_unsent)
    sys.stdout.write(json.dumps(removed, indent=2) + "\n")
