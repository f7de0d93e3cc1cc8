"""The tool's own keys: what is published of them, and how often a private one is imported."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

import pytest
from joserfc import jwt
from joserfc.jwk import KeySet, RSAKey

from service.lti import signing_keys
from service.lti.signing_keys import ALGORITHM, key_set, new_private_key, signed


@dataclass(frozen=True)
class Stored:
    kid: str
    private: str
    signs_from: datetime


@pytest.fixture(scope="module")
def key() -> Stored:
    return Stored(*new_private_key(), datetime(2026, 1, 1, tzinfo=UTC))


@pytest.fixture
def imported(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[Any]]:
    """The keys that were imported: each takes OpenSSL 40 ms."""
    found: list[Any] = []

    class Counted(RSAKey):
        @classmethod
        def import_key(cls, value: Any, *others: Any, **named: Any) -> RSAKey:  # type: ignore[override]
            found.append(value)
            return RSAKey.import_key(value, *others, **named)

    monkeypatch.setattr(signing_keys, "RSAKey", Counted)
    signing_keys._imported.cache_clear()
    yield found
    signing_keys._imported.cache_clear()


def test_what_anybody_may_ask_for_imports_no_private_key(key: Stored, imported: list[Any]) -> None:
    assert key_set([key]) == {"keys": [RSAKey.import_key(json.loads(key.private)).as_dict(private=False)]}
    assert not imported


def test_a_key_is_imported_once_and_signs_what_its_public_half_verifies(
    key: Stored, imported: list[Any]
) -> None:
    published = KeySet.import_key_set(key_set([key]))
    for number in range(3):
        token = jwt.decode(signed({"number": number}, key), published, algorithms=[ALGORITHM])
        assert token.claims == {"number": number}
    assert len(imported) == 1
