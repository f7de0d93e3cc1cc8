"""`framewise receipts`: verify what students handed in, and renew the keys that sign."""

import argparse
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from kinematics.errors import Fault
from service.adapters.gradebook import GradebookFormat, write_gradebook
from service.adapters.table_files import decoded
from service.cli.environment import Subparsers, settings_of_environment
from service.cli.whole_files import replacing
from service.http.problems import RequestError, fault_sentence
from service.receipts.checking import CheckedReceipt, check_receipts, entries_of, receipts_in
from service.receipts.keys import receipt_keys, rotate

_FORGED = 1
_LARGEST_FILE = 8 * 1024 * 1024  # Bytes of a file: the receipts of several thousand students.


def add(subparsers: Subparsers) -> None:
    """Declare `receipts` with what can be done with them."""
    parser = subparsers.add_parser("receipts", help="verify receipts, and renew the keys that sign them")
    commands = parser.add_subparsers(required=True, metavar="what")

    verified = commands.add_parser("verify", help="verify files of receipts with this installation's keys")
    verified.add_argument(
        "path", nargs="+", type=Path, help="files with receipts in them, or folders of files"
    )
    verified.add_argument(
        "--csv", nargs="?", type=Path, const=Path("-"), help="gradebook file; standard output, if not named"
    )
    verified.add_argument("--format", choices=tuple(map(str, GradebookFormat)), default=GradebookFormat.CSV)
    verified.set_defaults(run=_verify)

    renewed = commands.add_parser("rotate", help="put a new signing key into a file of keys")
    renewed.add_argument("file", type=Path, help="the file (FRAMEWISE_RECEIPT_KEYS); it is made if missing")
    renewed.add_argument("--retire", nargs="*", default=[], metavar="KID", help="keys that verify no longer")
    renewed.set_defaults(run=_rotate)


def _verify(options: argparse.Namespace) -> int:
    """Exit with 1 if any receipt is not ours."""
    texts: list[str] = []
    unread: list[CheckedReceipt] = []
    for file in _files(options.path):
        try:
            texts += receipts_in(_text(file))
        except RequestError as error:
            unread.append(CheckedReceipt(text=file.name, fault=error.faults[0]))
    checked = [*check_receipts(texts, receipt_keys(settings_of_environment())), *unread]
    if options.csv is None:
        for entry in checked:
            said = entry.receipt
            if said is None:
                assert entry.fault is not None
                sys.stdout.write(_line(f"✗ {entry.text[:24]}… {fault_sentence(entry.fault, options.lang)}"))
            else:
                copy = " (=)" if entry.repeated else ""
                sys.stdout.write(
                    _line(
                        f"✓ {said.name}: {said.exercise} v{said.version}, "
                        f"{said.points:g}/{said.max_points:g}, {said.time.isoformat()}{copy}"
                    )
                )
    elif str(options.csv) == "-":
        write_gradebook(entries_of(checked), sys.stdout, GradebookFormat(options.format))
    else:
        with replacing(options.csv) as stream:
            write_gradebook(entries_of(checked), stream, GradebookFormat(options.format))
    return _FORGED if any(entry.receipt is None for entry in checked) else 0


def _rotate(options: argparse.Namespace) -> None:
    sys.stdout.write(f"{rotate(options.file, options.retire).signing.kid}\n")


def _files(paths: Iterable[Path]) -> Iterator[Path]:
    """Yield files, and the files of folders."""
    for path in paths:
        yield from sorted(file for file in path.rglob("*") if file.is_file()) if path.is_dir() else [path]


def _text(file: Path) -> str:
    """Return the text of a file.

    Raises:
        RequestError: it is longer than is read, or in no encoding that is.
    """
    with file.open("rb") as stream:
        content = stream.read(_LARGEST_FILE + 1)
    if len(content) > _LARGEST_FILE:
        raise RequestError(Fault.at("file_unreadable", file=file.name, reason=f"> {_LARGEST_FILE >> 20} MiB"))
    return decoded(file.name, content)


def _line(text: str) -> str:
    """Return one line of output: a name that a student typed makes no further one, and moves no cursor."""
    return "".join(letter if letter.isprintable() else "\ufffd" for letter in text) + "\n"
