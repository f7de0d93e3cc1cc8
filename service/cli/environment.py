"""What commands share: the settings of the environment, and options that count something."""

import argparse
import difflib
import os
from collections.abc import Callable, Iterable
from importlib.util import find_spec
from pathlib import Path
from typing import TypeAlias

from pydantic import ValidationError

from service.cli.commands import SettingsError
from service.http.api_keys import KeyFile
from service.settings import Settings

Subparsers: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"
"""Where a subcommand is declared."""

_PREFIX = "FRAMEWISE_"
_FAULTY = "These settings cannot be understood:"
_WANTED = {
    "too_short": "at least {min_length} characters are needed; openssl rand -hex {min_length} makes enough",
    "int_parsing": "a whole number is needed, such as 8",
    "int_parsing_size": "this number is too large",
    "float_parsing": "a number is needed, such as 0.5",
    "bool_parsing": "true or false is needed",
    "greater_than": "a number above {gt} is needed",
    "greater_than_equal": "a number of {ge} or more is needed",
    "less_than_equal": "a number of {le} or less is needed",
    "enum": "{expected} is needed",
    "literal_error": "{expected} is needed",
    "value_error": "{error}",
}
"""What would be right, by pydantic's name of what is wrong; its own sentences speak of input and items."""


def settings_of_environment() -> Settings:
    """Return the settings of the environment.

    Raises:
        SettingsError: some cannot be understood.
    """
    known = {f"{_PREFIX}{name.upper()}" for name in Settings.model_fields}
    faults = [
        f"  {name}: there is no such setting{_nearest(name.upper(), known)}"
        for name in sorted(os.environ)
        if name.upper().startswith(_PREFIX) and name.upper() not in known
    ]
    try:
        settings = Settings()
    except ValidationError as error:
        for fault in error.errors():
            named = [f"{_PREFIX}{str(step).upper()}" for step in fault["loc"][:1]]
            wanted = _WANTED.get(fault["type"], fault["msg"]).format_map(fault.get("ctx", {}))
            faults.append("  " + ": ".join((*named, wanted)))
    if faults:
        raise SettingsError("\n".join((_FAULTY, *faults)))
    return settings


def require_what_is_named(settings: Settings) -> None:
    """Refuse settings that name a key file, a folder or a library that is not there.

    Without a key file, all would be let in.

    Raises:
        SettingsError: something is not there.
        UnavailableError: a key file cannot be understood.
    """
    made_by = {"api_keys": "framewise keys add", "receipt_keys": "framewise receipts rotate"}
    missing = [
        f"  {_PREFIX}{name.upper()}: there is no file {path}; {command} makes it"
        for name, command in made_by.items()
        if (path := getattr(settings, name)) is not None and not path.is_file()
    ]
    missing += [
        f"  {_PREFIX}EXERCISE_FOLDERS: {reason}"
        for folder in settings.exercise_folders
        if (reason := _unusable(folder))
    ]
    if settings.traces and not _can_send_traces():
        missing.append(f"  {_PREFIX}TRACES: this needs the extra telemetry: pip install framewise[telemetry]")
    if missing:
        raise SettingsError("\n".join((_FAULTY, *missing)))
    if settings.api_keys is not None:
        KeyFile(settings.api_keys).all()
    if settings.receipt_keys is not None:
        from service.receipts.keys import read_keys  # few installations have them

        read_keys(settings.receipt_keys)


def _unusable(folder: Path) -> str | None:
    """Return why no exercises are found in a folder, if it is plain."""
    from exercises.consistency import FILE  # commands that name no folder need none of it

    if not folder.is_dir():
        return f"there is no folder {folder}"
    if (folder / FILE).is_file():
        return f"{folder} is an exercise; the folder that holds it is needed: {folder.absolute().parent}"
    return None


def _can_send_traces() -> bool:
    try:
        return find_spec("opentelemetry.exporter.otlp.proto.http") is not None
    except ModuleNotFoundError:
        return False


def _nearest(name: str, known: Iterable[str]) -> str:
    """Return what was probably meant; the prefix, which all share, would make everything look alike."""
    names = [setting.removeprefix(_PREFIX) for setting in known]
    nearest = difflib.get_close_matches(name.removeprefix(_PREFIX), names, n=1)
    return f"; did you mean {_PREFIX}{nearest[0]}?" if nearest else ""


def count(text: str) -> int:
    """Return the number that an option counts with: 1 or more."""
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"a whole number from 1 on is needed, not {text}")
    return int(text)


def count_up_to(most: int, what: str) -> Callable[[str], int]:
    """Return what reads the number that an option counts with, at most so many."""

    def read(text: str) -> int:
        if (number := count(text)) > most:
            raise argparse.ArgumentTypeError(f"at most {most} {what}, not {text}")
        return number

    return read
