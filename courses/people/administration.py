"""Who administers an installation: whoever may run its command, for the hours of a session in the browser."""

from datetime import datetime, timedelta

from courses.people.secrets import check_code, issue_code, redeem_code
from courses.refusals import SessionError
from courses.storage.database import Store
from kinematics.errors import Fault

INVITED = timedelta(minutes=10)  # How long the address that the command prints can be opened.
SIGNED_IN = timedelta(hours=2)  # How long an administrator stays signed in: an afternoon of setting up.
_CODE, _SESSION = "administrator", "administrator-session"


def invite_administrator(store: Store, now: datetime) -> str:
    """Return a code that signs an administrator in, once."""
    return issue_code(store, _CODE, {}, now, INVITED)


def admit_administrator(store: Store, code: str, now: datetime) -> str:
    """Exchange a code for a session's token.

    Raises:
        SessionError: the code was used, is too old, or was never issued.
    """
    redeem_code(store, _CODE, code, now)
    return issue_code(store, _SESSION, {}, now, SIGNED_IN)


def check_administrator(store: Store, token: str, now: datetime) -> None:
    """Make sure that a token is an administrator's.

    Raises:
        SessionError: it is not, or no longer.
    """
    try:
        check_code(store, _SESSION, token, now)
    except SessionError:
        raise SessionError(Fault.at("administrator_unknown")) from None
