"""`framewise config`: the settings as the service would read them."""

import argparse
import json
import re
import sys

from pydantic import SecretStr

from service.cli.environment import Subparsers, require_what_is_named, settings_of_environment

HIDDEN = "********"
_SECRET = re.compile(r"([?&][^=&]*(?:password|token|secret|key)=)[^&]*", re.IGNORECASE)
"""Values of an address's query that are not shown: of a database, and of a collector."""


def add(subparsers: Subparsers) -> None:
    """Declare `config`."""
    parser = subparsers.add_parser("config", help="print the settings, or say which cannot be understood")
    parser.set_defaults(run=_print)


def _print(_options: argparse.Namespace) -> None:
    settings = settings_of_environment()
    for name in type(settings).model_fields:
        value = getattr(settings, name)
        shown = HIDDEN if isinstance(value, SecretStr) and value.get_secret_value() else value
        unset = "# " if value is None else ""
        sys.stdout.write(f"{unset}FRAMEWISE_{name.upper()}={_written(shown)}\n")
    require_what_is_named(settings)


def _written(value: object) -> str:
    """A value as the environment takes it."""
    if isinstance(value, tuple):
        return " ".join(map(str, value))
    if isinstance(value, bool):
        return json.dumps(value)
    return "" if value is None else _without_password(str(value))


def _without_password(address: str) -> str:
    """What is printed is shown to others: hide the password of an address, wherever it stands."""
    hidden = re.sub(r"(://[^:/?#]*):.*@", rf"\1:{HIDDEN}@", address)
    return re.sub(_SECRET, rf"\1{HIDDEN}", hidden)
