"""Key sets of platforms: fetched once for all who launch, and not again and again where nothing answers."""

import json
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from jwcrypto.jwk import JWK

from courses.model import Platform
from service.lti.fetching import FetchedAnswer, Fetcher
from service.lti.launch_errors import LaunchError, PlatformError, unreachable
from service.lti.platform_keys import REFETCHED_AFTER, SHORTEST, STALE, UNANSWERED, PlatformKeys

PLATFORM = Platform(
    issuer="https://lms.example.edu",
    client_id="framewise",
    authorization_endpoint="https://lms.example.edu/auth",
    token_endpoint="https://lms.example.edu/token",
    jwks_uri="https://lms.example.edu/jwks",
)


class Slow(Fetcher):
    """Answers when it is let go, with a key set or, if it is to fail, not at all."""

    def __init__(self) -> None:
        super().__init__()
        self.asked, self.fails = 0, False
        self.go, self.begun = threading.Event(), threading.Event()
        key = JWK.generate(kty="RSA", size=2048, kid="key-1", use="sig", alg="RS256")
        self.keys = {"keys": [json.loads(key.export_public())]}

    def get_json(self, address: str) -> tuple[Any, FetchedAnswer]:
        self.asked += 1
        self.begun.set()
        assert self.go.wait(30)
        if self.fails:
            raise unreachable(address, "ReadTimeout")
        return self.keys, FetchedAnswer(address=address, status=200, headers={}, body=b"")


@pytest.mark.parametrize("fails", [False, True])
def test_many_who_launch_at_once_cost_one_fetch(fails: bool) -> None:
    """Each took a thread of all courses for as long as the platform was silent."""
    fetcher, now = Slow(), 0.0
    fetcher.fails = fails
    keys = PlatformKeys(fetcher, lambda: now)
    with ThreadPoolExecutor(16) as threads:
        waiting = [threads.submit(keys.key, PLATFORM, "key-1") for _ in range(16)]
        assert fetcher.begun.wait(30)
        fetcher.go.set()
        assert [isinstance(each.exception(), PlatformError) for each in waiting] == [fails] * 16
    assert fetcher.asked == 1
    now += UNANSWERED
    fetcher.fails = False
    assert keys.key(PLATFORM, "key-1")
    assert fetcher.asked == 1 + fails


def test_an_unknown_key_fetches_the_set_again_at_most_so_often() -> None:
    fetcher, now = Slow(), 0.0
    fetcher.go.set()
    keys = PlatformKeys(fetcher, lambda: now)
    for asked, later in ((1, 0.0), (1, 1.0), (2, REFETCHED_AFTER), (2, 1.0), (3, SHORTEST)):
        now += later
        with pytest.raises(LaunchError, match="lti_token_key"):
            keys.key(PLATFORM, "key-2")
        assert fetcher.asked == asked
    fetcher.keys = {"keys": []}
    now += SHORTEST
    with pytest.raises(LaunchError, match="lti_token_key"):
        keys.key(PLATFORM, "key-1")
    assert fetcher.asked == 4


def test_known_keys_outlast_an_outage_of_the_key_address_for_a_time() -> None:
    fetcher, now = Slow(), 0.0
    fetcher.go.set()
    keys = PlatformKeys(fetcher, lambda: now)
    known = keys.key(PLATFORM, "key-1")
    fetcher.fails = True
    now = SHORTEST + 1
    assert keys.key(PLATFORM, "key-1") is known
    assert keys.key(PLATFORM, "key-1") is known
    assert fetcher.asked == 2
    with pytest.raises(PlatformError):  # not "no such key": nobody knows
        keys.key(PLATFORM, "key-2")
    now = SHORTEST + STALE - 1
    assert keys.key(PLATFORM, "key-1") is known
    now = SHORTEST + STALE
    with pytest.raises(PlatformError):
        keys.key(PLATFORM, "key-1")
    fetcher.fails = False
    now += UNANSWERED
    assert keys.key(PLATFORM, "key-1") is not known
