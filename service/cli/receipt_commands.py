"""`framewise receipts`: verify what students handed in, and renew the keys that sign."""

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

from service.adapters.gradebook import GradebookFormat, write_gradebook
from service.adapters.judging import told_fault
from service.cli.environment import Subparsers, settings_of_environment
from service.cli.whole_files import replacing
from service.receipts.checking import check_receipts, entries_of, receipts_in
from service.receipts.keys import receipt_keys, rotate

_FORGED = 1
_LARGEST_FILE = 1024 * 1024  # Bytes read of a file: the receipts of a thousand students.


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
    texts = [text for path in options.path for text in _receipts(path)]
    checked = check_receipts(texts, receipt_keys(settings_of_environment()))
    if options.csv is None:
        for entry in checked:
            said = entry.receipt
            if said is None:
                assert entry.fault is not None
                sys.stdout.write(f"✗ {entry.text[:24]}… {told_fault(entry.fault, options.lang)}\n")
            else:
                copy = " (=)" if entry.repeated else ""
                sys.stdout.write(
                    f"✓ {said.name}: {said.exercise} v{said.version}, {said.points:g}/{said.max_points:g}, "
                    f"{said.time.isoformat()}{copy}\n"
                )
    elif str(options.csv) == "-":
        write_gradebook(entries_of(checked), sys.stdout, GradebookFormat(options.format))
    else:
        with replacing(options.csv) as stream:
            write_gradebook(entries_of(checked), stream, GradebookFormat(options.format))
    return _FORGED if any(entry.receipt is None for entry in checked) else 0


def _rotate(options: argparse.Namespace) -> None:
    sys.stdout.write(f"{rotate(options.file, options.retire).signing.kid}\n")


def _receipts(path: Path) -> Iterator[str]:
    """Yield the receipts in a file, or in the files of a folder."""
    files = sorted(file for file in path.rglob("*") if file.is_file()) if path.is_dir() else [path]
    for file in files:
        with file.open("rb") as stream:
            yield from receipts_in(stream.read(_LARGEST_FILE).decode("utf-8", errors="replace"))
