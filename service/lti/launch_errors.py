"""What goes wrong in launches and services.

LaunchError       a launch that is not believed (401)
LoginError        a login, or a form, that lacks what it needs (400)
PlatformError     a platform did not answer as its specification says
TokenError        a platform gives this tool no access to a service
"""

from kinematics.errors import Fault, ParamValue
from service.http.problems import BodyError, RequestError, UnauthorizedError


class LaunchError(UnauthorizedError):
    """A launch that is not believed."""


class LoginError(BodyError):
    """A login, or a form, that lacks what it needs."""


class PlatformError(RequestError):
    """A platform did not answer as its specification says.

    Attributes:
        status: HTTP status of its answer; None if there was none.
        retry_after: how long it asks to be left alone [s].
    """

    def __init__(self, fault: Fault, *, status: int | None = None, retry_after: float | None = None) -> None:
        super().__init__(fault)
        self.status, self.retry_after = status, retry_after


class TokenError(PlatformError):
    """A platform gives this tool no access to a service."""


def missing_claim(name: str) -> LaunchError:
    """Return the refusal of a message that lacks a claim."""
    return LaunchError(Fault.at("lti_claim_missing", claim=name))


def wrong_claim(name: str) -> LaunchError:
    """Return the refusal of a message whose claim does not belong to this launch."""
    return LaunchError(Fault.at("lti_claim_wrong", claim=name))


def unreachable(
    address: str, reason: ParamValue, *, status: int | None = None, retry_after: float | None = None
) -> PlatformError:
    """Return the report of an address that did not answer as it should; its query is left out."""
    fault = Fault.at("lti_unreachable", address=address.partition("?")[0], reason=reason)
    return PlatformError(fault, status=status, retry_after=retry_after)
