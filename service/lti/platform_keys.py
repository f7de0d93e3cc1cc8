"""Keys of platforms, fetched from the address that was registered and from nowhere else."""

import re
import threading
import time
from collections.abc import Callable, Mapping
from typing import Any

from joserfc.errors import JoseError
from joserfc.jwk import RSAKey

from courses.model import Platform
from kinematics.errors import Fault
from service.lti.fetching import Fetcher
from service.lti.launch_errors import LaunchError, PlatformError, unreachable

SHORTEST, LONGEST = 600.0, 3600.0  # Bounds of how long a key set is cached [s], whatever Cache-Control says.
REFETCHED_AFTER = 30.0  # An unknown key fetches the set again at most so often [s].
UNANSWERED = 10.0
"""A set that could not be fetched is not asked for again for so long [s]: whoever launches meanwhile takes no
thread from those who come from other platforms."""
STALE = 3600.0
"""How much longer keys hold whose set cannot be fetched anew [s] (stale-if-error, RFC 5861): a platform whose
key address has an outage while an exam starts goes on launching."""
KeySet = tuple[dict[str, RSAKey], float, float]
"""Keys by their names, when they were fetched and until when they are cached."""
_NONE: KeySet = ({}, float("-inf"), float("-inf"))
_MAX_AGE = re.compile(r"max-age=(\d{1,9})")


class PlatformKeys:
    """Caches the key sets of platforms."""

    def __init__(self, fetcher: Fetcher, clock: Callable[[], float] = time.monotonic) -> None:
        self._fetcher, self._clock = fetcher, clock
        self._lock = threading.Lock()
        self._sets: dict[str, KeySet] = {}
        self._asking: dict[str, threading.Lock] = {}
        self._failed: dict[str, tuple[PlatformError, float]] = {}

    def key(self, platform: Platform, kid: str) -> RSAKey:
        """Return the platform's key of a name; a name that is not known fetches the set once more.

        Raises:
            LaunchError: the platform publishes no such key.
            PlatformError: its keys cannot be fetched.
        """
        with self._lock:
            asking = self._asking.setdefault(platform.jwks_uri, threading.Lock())
        keys = self._known(platform.jwks_uri, kid)
        if keys is None:
            with asking:  # of many who launch at once, one fetches
                keys = self._known(platform.jwks_uri, kid)
                keys = self._fetch_or_stale(platform.jwks_uri, kid) if keys is None else keys
        if kid not in keys:
            raise LaunchError(Fault.at("lti_token_key"))
        return keys[kid]

    def _known(self, address: str, kid: str) -> dict[str, RSAKey] | None:
        """The set at an address; None if it has to be fetched, for its age or for a key."""
        now = self._clock()
        with self._lock:
            keys, fetched, until = self._sets.get(address, _NONE)
        stale = now >= until or (kid not in keys and now - fetched >= REFETCHED_AFTER)
        return None if stale else keys

    def _fetch_or_stale(self, address: str, kid: str) -> dict[str, RSAKey]:
        """The set at an address; where it cannot be had, one with the key that ran out a short time ago."""
        try:
            return self._fetch(address)
        except PlatformError:
            with self._lock:
                keys, _, until = self._sets.get(address, _NONE)
            if kid in keys and self._clock() < until + STALE:
                return keys
            raise

    def _fetch(self, address: str) -> dict[str, RSAKey]:
        with self._lock:
            error, until = self._failed.get(address, (None, float("-inf")))
        if error is not None and self._clock() < until:
            raise PlatformError(error.faults[0], status=error.status, retry_after=error.retry_after)
        try:
            keys, life = self._asked(address)
        except PlatformError as failure:
            with self._lock:
                self._failed[address] = (failure, self._clock() + UNANSWERED)
            raise
        with self._lock:
            self._sets[address] = (keys, self._clock(), self._clock() + life)
        return keys

    def _asked(self, address: str) -> tuple[dict[str, RSAKey], float]:
        """The set that stands at an address, and how long it is cached [s]."""
        found, answer = self._fetcher.get_json(address)
        if not isinstance(found, Mapping) or not isinstance(found.get("keys"), list):
            raise unreachable(address, "keys")
        match = _MAX_AGE.search(answer.headers.get("cache-control", ""))
        life = min(max(float(match[1]) if match else SHORTEST, SHORTEST), LONGEST)
        return dict(_usable(found["keys"])), life


def _usable(found: list[Any]) -> list[tuple[str, RSAKey]]:
    """RSA keys for signatures, by their names; what else a set holds is left out."""
    keys = []
    for entry in found:
        if not isinstance(entry, dict) or entry.get("kty") != "RSA" or not isinstance(entry.get("kid"), str):
            continue
        if entry.get("use", "sig") != "sig":
            continue
        try:
            keys.append((entry["kid"], RSAKey.import_key(entry)))
        except (JoseError, ValueError, KeyError, TypeError):
            continue
    return keys
