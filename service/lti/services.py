"""Calls to a platform's services with an access token (Security Framework 1.1 §4.1)."""

import threading
import time
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from urllib.parse import urlencode

import orjson

from courses.model import Platform
from courses.people.platforms import StoredKey
from courses.people.secrets import new_token
from service.lti.fetching import FetchedAnswer, Fetcher
from service.lti.launch_errors import PlatformError, TokenError, unreachable
from service.lti.signing_keys import signed

ASSERTION_LIFE = 60  # Seconds for which the assertion that asks for a token is valid: it is used at once.
RENEWED_BEFORE = 60.0  # A token is used until so long before its end [s].
_UNAUTHORIZED = 401
_TRANSIENT = (408, 425, 429)  # Refusals that say nothing of who asks.
_ASSERTION = "urn:ietf:params:oauth:client-assertion-type:jwt-bearer"


class Services:
    """Calls services; tokens are asked for once and shared."""

    def __init__(self, fetcher: Fetcher, key: Callable[[], StoredKey]) -> None:
        self._fetcher, self._key = fetcher, key
        self._lock = threading.Lock()
        self._asking: dict[tuple[str, ...], threading.Lock] = {}
        self._tokens: dict[tuple[str, ...], tuple[str, float]] = {}

    def call(
        self,
        platform: Platform,
        scope: str,
        method: str,
        address: str,
        *,
        accept: str,
        content: object = None,
        content_type: str = "",
    ) -> FetchedAnswer:
        """Return the service's answer, whatever its status; a token that is refused is asked for once more.

        Raises:
            PlatformError: no token is given, or the service does not answer.
        """
        body = None if content is None else orjson.dumps(content)
        for renew in (False, True):
            headers = {
                "Authorization": f"Bearer {self._token(platform, scope, renew=renew)}",
                "Accept": accept,
            }
            if body is not None:
                headers["Content-Type"] = content_type
            answer = self._fetcher.send(method, address, headers=headers, content=body)
            if answer.status != _UNAUTHORIZED:
                break
        return answer

    def _token(self, platform: Platform, scope: str, *, renew: bool) -> str:
        key = (platform.token_endpoint, platform.client_id, scope)  # numbers of platforms are given again
        with self._lock:
            asking = self._asking.setdefault(key, threading.Lock())
        with asking:
            token, until = self._tokens.get(key, ("", 0.0))
            if renew or time.monotonic() >= until:
                token, life = self._ask(platform, scope)
                self._tokens[key] = (token, time.monotonic() + max(0.0, life - RENEWED_BEFORE))
            return token

    def _ask(self, platform: Platform, scope: str) -> tuple[str, float]:
        issued = int(datetime.now(UTC).timestamp())
        assertion = signed(
            {
                "iss": platform.client_id,
                "sub": platform.client_id,
                "aud": platform.token_audience or platform.token_endpoint,
                "iat": issued,
                "exp": issued + ASSERTION_LIFE,
                "jti": new_token(),
            },
            self._key(),
        )
        form = {
            "grant_type": "client_credentials",
            "client_assertion_type": _ASSERTION,
            "client_assertion": assertion,
            "scope": scope,
        }
        answer = self._fetcher.send(
            "POST",
            platform.token_endpoint,
            headers={"Content-Type": "application/x-www-form-urlencoded"},
            content=urlencode(form).encode(),
        )
        found = _given(answer).json()
        if not isinstance(found, Mapping) or not isinstance(found.get("access_token"), str):
            raise unreachable(platform.token_endpoint, "access_token")
        life = found.get("expires_in")
        return found["access_token"], float(life) if isinstance(life, (int, float)) else 3600.0


def _given(answer: FetchedAnswer) -> FetchedAnswer:
    try:
        return answer.succeeded()
    except PlatformError as error:
        if answer.status // 100 != 4 or answer.status in _TRANSIENT:
            raise
        raise TokenError(*error.faults, status=answer.status) from None
