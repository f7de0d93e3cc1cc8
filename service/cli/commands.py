"""The subcommands of `framewise`, and the one way in which their errors are told."""

import argparse
import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module

from exercises.errors import ExerciseError
from kinematics.errors import Fault, KinematicsError
from service import __version__
from service.http.problems import ServiceError, fault_sentence
from service.messages import DEFAULT_LANGUAGE, languages

COMMANDS: Mapping[str, str] = {
    "serve": "serve",
    "exercises": "exercise_commands",
    "grade": "grade_commands",
    "receipts": "receipt_commands",
    "keys": "api_keys",
    "backup": "backups",
    "restore": "backups",
    "migrate": "backups",
    "lti": "lti",
    "people": "people",
    "courses": "courses",
    "config": "config",
    "warm": "warm",
}
"""Every subcommand and the module of this package that declares it; only what is called is imported."""

FAILED, UNUSABLE = 1, 2  # Exit statuses: something was found wrong; the command could not be carried out.
REFUSALS = (ExerciseError, KinematicsError, ServiceError, OSError)
"""What is told in a line, without a stack trace."""


class SettingsError(Exception):
    """The settings of the environment cannot be used; its text names each that is wrong."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a subcommand; without one, serve.

    Returns:
        The exit status: 0, or 1 if something was found wrong, or 2 if the command cannot be carried out.
    """
    given = list(sys.argv[1:] if arguments is None else arguments)
    first = given[0].partition("=")[0] if given else "-"
    if first.startswith("-") and first not in ("-h", "--help", "--lang", "--version"):
        given = ["serve", *given]
    named = next((word for word in given if word in COMMANDS), None)
    options = _parser((COMMANDS[named],) if named else dict.fromkeys(COMMANDS.values())).parse_args(given)
    run: Callable[[argparse.Namespace], int | None] = options.run
    try:
        status = run(options) or 0
        sys.stdout.flush()  # a reader that is gone is noticed here
    except BrokenPipeError:  # what reads us, such as head, has had enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return FAILED
    except REFUSALS as error:
        tell(error, options.lang)
        return UNUSABLE
    except SettingsError as error:
        sys.stderr.write(f"{error}\n")
        return UNUSABLE
    return status


def tell(refusal: ExerciseError | KinematicsError | ServiceError | OSError, language: str) -> None:
    """Write on standard error, a line for each fault, why something cannot be carried out."""
    if isinstance(refusal, OSError):
        params = {"file": str(refusal.filename or "–"), "reason": refusal.strerror or str(refusal)}
        faults: Sequence[Fault] = (Fault.at("file_unusable", **params),)
    else:
        faults = refusal.faults
    for fault in faults:
        sys.stderr.write(f"framewise: {fault_line(fault, language)}\n")


def fault_line(fault: Fault, language: str) -> str:
    """Return a fault's place and sentence; the place as folder/file: key.key."""
    path = [str(step) for step in fault.where]
    files = next((i + 1 for i, step in enumerate(path) if "." in step), 0)
    place = ": ".join(part for part in ("/".join(path[:files]), ".".join(path[files:])) if part)
    text = fault_sentence(fault, language)
    return f"{place}: {text} [{fault.code}]" if place else f"{text} [{fault.code}]"


def _parser(modules: Iterable[str]) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="framewise", description="Kinematics over HTTP, and its exercises.")
    parser.add_argument(
        "--lang", choices=languages(), default=DEFAULT_LANGUAGE, help="language of the output (%(default)s)"
    )
    parser.add_argument("--version", action="version", version=f"%(prog)s {__version__}")
    subparsers = parser.add_subparsers(required=True, metavar="command")
    for name in modules:
        import_module(f"service.cli.{name}").add(subparsers)
    return parser
