"""`framewise keys`: keys for programs that call the API."""

import argparse
import sys
from datetime import UTC, datetime, timedelta

from kinematics.errors import Fault
from service.cli.environment import Subparsers, count, count_up_to, settings_of_environment
from service.http.api_keys import KeyFile, KeyScope
from service.http.problems import RequestError

MOST_DAYS = 36_500  # A century; dates end after the year 9999.


def add(subparsers: Subparsers) -> None:
    """Declare `keys` with what can be done with them."""
    parser = subparsers.add_parser("keys", help="keys for programs that call the API (FRAMEWISE_API_KEYS)")
    commands = parser.add_subparsers(required=True, metavar="what")

    made = commands.add_parser("add", help="make a key; its text is shown this once")
    made.add_argument(
        "--scope", nargs="+", choices=[scope.value for scope in KeyScope], default=list(KeyScope)
    )
    made.add_argument("--note", default="", help="whose it is")
    made.add_argument(
        "--days", type=count_up_to(MOST_DAYS, "days are possible"), help="days after which it is refused"
    )
    made.add_argument("--cost-per-minute", type=count, help="its own limit")
    made.set_defaults(run=_add)

    commands.add_parser("list", help="all keys").set_defaults(run=_list)

    revoked = commands.add_parser("revoke", help="refuse a key from now on")
    revoked.add_argument("id", help="its id, as `list` shows it")
    revoked.set_defaults(run=_revoke)


def _file() -> KeyFile:
    path = settings_of_environment().api_keys
    if path is None:
        raise RequestError(Fault.at("setting_missing", name="FRAMEWISE_API_KEYS"))
    return KeyFile(path)


def _add(options: argparse.Namespace) -> None:
    expires = None
    if options.days is not None:
        expires = (datetime.now(UTC) + timedelta(days=options.days)).isoformat(timespec="seconds")
    _, text = _file().add(
        tuple(map(KeyScope, options.scope)),
        note=options.note,
        expires=expires,
        cost_per_minute=options.cost_per_minute,
    )
    sys.stdout.write(f"{text}\n")


def _list(options: argparse.Namespace) -> None:
    now = datetime.now(UTC)
    for key in _file().all():
        state = "valid" if key.is_valid(now) else "revoked" if key.revoked else "expired"
        scopes = ",".join(key.scopes)
        sys.stdout.write(
            f"{key.id}  {state:8} {scopes:20} {key.created}  {key.expires or '-':25} {key.note}\n"
        )


def _revoke(options: argparse.Namespace) -> None:
    if not _file().revoke(options.id):
        raise RequestError(Fault.at("api_key_unknown", id=options.id))
