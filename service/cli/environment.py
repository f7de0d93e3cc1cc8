"""What commands share: the settings of the environment, and options that count something."""

from __future__ import annotations

import argparse
import difflib
import os
import sys
from collections.abc import Iterable

from pydantic import ValidationError

from service.http.api_keys import KeyFile
from service.settings import Settings

_PREFIX = "FRAMEWISE_"
_FAULTY = "These settings cannot be understood:"


def settings_of_environment() -> Settings:
    """Return the settings of the environment; what cannot be understood ends the program with its name."""
    known = {f"{_PREFIX}{name.upper()}" for name in Settings.model_fields}
    faults = [
        f"  {name}: there is no such setting{_nearest(name.upper(), known)}"
        for name in sorted(os.environ)
        if name.upper().startswith(_PREFIX) and name.upper() not in known
    ]
    try:
        settings = Settings()
    except ValidationError as error:
        faults += [
            "  " + ": ".join((*(f"{_PREFIX}{str(step).upper()}" for step in fault["loc"][:1]), fault["msg"]))
            for fault in error.errors()
        ]
    if faults:
        sys.exit("\n".join((_FAULTY, *faults)))
    return settings


def require_key_files(settings: Settings) -> None:
    """End the program if a key file is not there, with the name of its setting: without, all would be let in.

    Raises:
        UnavailableError: the file of API keys cannot be understood.
    """
    made_by = {"api_keys": "framewise keys add", "receipt_keys": "framewise receipts rotate"}
    missing = [
        f"  {_PREFIX}{name.upper()}: there is no file {path}; {command} makes it"
        for name, command in made_by.items()
        if (path := getattr(settings, name)) is not None and not path.is_file()
    ]
    if missing:
        sys.exit("\n".join((_FAULTY, *missing)))
    if settings.api_keys is not None:
        KeyFile(settings.api_keys).all()


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
