"""The secret of an installation: what its signatures rest on."""

import logging
import os
import secrets
from functools import cache

from service.settings import Settings

VARIABLE = "FRAMEWISE_SECRET"
_BYTES = 32  # 256 random bits.

_log = logging.getLogger("framewise")


def installation_secret(settings: Settings) -> bytes:
    """Return the secret of the settings, or one that lasts as long as this process."""
    if settings.secret is not None:
        return settings.secret.get_secret_value().encode()
    return _passing_secret()


def share_secret() -> None:
    """Give the processes that this one is going to start one secret, if the operator gave none."""
    os.environ.setdefault(VARIABLE, secrets.token_hex(_BYTES))


@cache
def _passing_secret() -> bytes:
    _log.info("%s is not set: what is signed now is void after a restart", VARIABLE)
    return secrets.token_bytes(_BYTES)
