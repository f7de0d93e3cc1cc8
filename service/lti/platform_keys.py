"""Keys of platforms, fetched from the address that was registered and from nowhere else."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Callable, Mapping
from typing import Any, Protocol

from joserfc.errors import JoseError
from joserfc.jwk import RSAKey

from kinematics.errors import Fault
from service.lti.fetching import Fetcher
from service.lti.launch_errors import LaunchError, unreachable

SHORTEST, LONGEST = 600.0, 3600.0
"""Bounds of how long a key set is cached [s], whatever Cache-Control says."""
REFETCHED_AFTER = 30.0
"""An unknown key fetches the set again at most so often [s]."""
_MAX_AGE = re.compile(r"max-age=(\d{1,9})")


class LtiPlatform(Protocol):
    """What the protocol needs to know of a platform."""

    @property
    def id(self) -> int:
        """Its number here."""

    @property
    def issuer(self) -> str:
        """Its identifier."""

    @property
    def client_id(self) -> str:
        """What it calls this tool."""

    @property
    def authorization_endpoint(self) -> str:
        """Where logins go."""

    @property
    def token_endpoint(self) -> str:
        """Where tokens for services come from."""

    @property
    def token_audience(self) -> str | None:
        """The audience of token requests, where it is not the endpoint."""

    @property
    def jwks_uri(self) -> str:
        """Where its keys are."""


class PlatformKeys:
    """Caches the key sets of platforms."""

    def __init__(self, fetcher: Fetcher, clock: Callable[[], float] = time.monotonic) -> None:
        self._fetcher = fetcher
        self._clock = clock
        self._lock = threading.Lock()
        self._sets: dict[str, tuple[dict[str, RSAKey], float, float]] = {}

    def key(self, platform: LtiPlatform, kid: str) -> RSAKey:
        """Return the platform's key of a name; a name that is not known fetches the set once more.

        Raises:
            LaunchError: the platform publishes no such key.
            PlatformError: its keys cannot be fetched.
        """
        now = self._clock()
        with self._lock:
            keys, fetched, until = self._sets.get(platform.jwks_uri, ({}, float("-inf"), float("-inf")))
        if now >= until or (kid not in keys and now - fetched >= REFETCHED_AFTER):
            keys = self._fetch(platform.jwks_uri, now)
        if kid not in keys:
            raise LaunchError(Fault.at("lti_token_key"))
        return keys[kid]

    def _fetch(self, address: str, now: float) -> dict[str, RSAKey]:
        found, answer = self._fetcher.get_json(address)
        if not isinstance(found, Mapping) or not isinstance(found.get("keys"), list):
            raise unreachable(address, "keys")
        keys = dict(_usable(found["keys"]))
        match = _MAX_AGE.search(answer.headers.get("cache-control", ""))
        life = min(max(float(match[1]) if match else SHORTEST, SHORTEST), LONGEST)
        with self._lock:
            self._sets[address] = (keys, now, now + life)
        return keys


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
