"""Keys of programs that call us: a file of digests, scopes and dates."""

import hashlib
import json
import os
import secrets
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime
from enum import StrEnum
from pathlib import Path
from typing import Any

from kinematics.errors import Fault
from service.http.problems import UnavailableError

PREFIX = "fwk_"
_BYTES = 32  # 256 random bits.


class KeyScope(StrEnum):
    """What a key may be used for.

    READ: exercises, robots, descriptions.
    COMPUTE: kinematics.
    GRADE: judging answers, receipts, µEd.
    PUBLISH: publishing exercises.
    """

    READ = "read"
    COMPUTE = "compute"
    GRADE = "grade"
    PUBLISH = "publish"


@dataclass(frozen=True, kw_only=True, slots=True)
class ApiKey:
    """A key as it is stored: what it is for, and a digest from which it cannot be found.

    Attributes:
        id: name of the key in lists and logs; it is the beginning of its text and no secret.
        digest: SHA-256 of its text. The text has 256 random bits: nothing is gained by a slower digest.
        scopes: what it may be used for.
        note: whose it is.
        created: when it was made, UTC.
        expires: from when on it is refused, UTC; None for never.
        revoked: from when on it is refused, UTC; None if it is not.
        cost_per_minute: its own limit; None for the installation's.
    """

    id: str
    digest: str
    scopes: tuple[KeyScope, ...]
    note: str = ""
    created: str
    expires: str | None = None
    revoked: str | None = None
    cost_per_minute: int | None = None

    def is_valid(self, now: datetime) -> bool:
        """Return whether the key is neither expired nor revoked."""
        ends = [end for end in (self.expires, self.revoked) if end is not None]
        return all(now < datetime.fromisoformat(end) for end in ends)


class KeyFile:
    """The keys of an installation, read again when the file changes.

    Every method raises UnavailableError for a file that cannot be understood, and for one that is gone after
    it had keys: then nobody gets in.

    Args:
        path: JSON file that `framewise keys` writes.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._stamp = -1
        self._keys: Mapping[str, ApiKey] = {}

    def all(self) -> tuple[ApiKey, ...]:
        """Return every key, revoked ones too; none while there is no file."""
        return tuple(self._read().values())

    def find(self, text: str) -> ApiKey | None:
        """Return the key of a text, valid or not; None if it is none of ours."""
        return self._read().get(digest_of(text))

    def add(self, scopes: tuple[KeyScope, ...], **members: Any) -> tuple[ApiKey, str]:
        """Make a key; its text is returned this once and stored nowhere."""
        text = PREFIX + secrets.token_urlsafe(_BYTES)
        now = datetime.now(UTC).isoformat(timespec="seconds")
        key = ApiKey(
            id=text[: len(PREFIX) + 6], digest=digest_of(text), scopes=scopes, created=now, **members
        )
        self._write((*self.all(), key))
        return key, text

    def revoke(self, key_id: str) -> bool:
        """Refuse a key from now on; return whether there is one of that id."""
        now = datetime.now(UTC).isoformat(timespec="seconds")
        keys = self.all()
        changed = tuple(replace(key, revoked=now) if key.id == key_id else key for key in keys)
        self._write(changed)
        return changed != keys

    def _read(self) -> Mapping[str, ApiKey]:
        try:
            stamp = self._path.stat().st_mtime_ns
        except OSError as error:
            if isinstance(error, FileNotFoundError) and not self._keys:
                return {}
            raise key_file_unreadable(self._path, error) from error
        if stamp != self._stamp:
            try:
                document = json.loads(self._path.read_text(encoding="utf-8"))
                found = [
                    ApiKey(**{**entry, "scopes": tuple(map(KeyScope, entry["scopes"]))}) for entry in document
                ]
            except (OSError, ValueError, TypeError, KeyError) as error:
                raise key_file_unreadable(self._path, error) from error
            self._keys = {key.digest: key for key in found}
            self._stamp = stamp
        return self._keys

    def _write(self, keys: tuple[ApiKey, ...]) -> None:
        draft = self._path.with_name(f"{self._path.name}.{os.getpid()}")
        with os.fdopen(os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "w") as stream:
            json.dump([asdict(key) for key in keys], stream, indent=2)
        draft.replace(self._path)
        self._stamp = -1


def key_file_unreadable(path: Path, error: Exception) -> UnavailableError:
    """Return the refusal of a file that holds no keys, or cannot be understood."""
    return UnavailableError(Fault.at("key_file_unreadable", file=path.name, reason=str(error)))


def digest_of(text: str) -> str:
    """Return the digest under which a key is stored."""
    return hashlib.sha256(text.encode()).hexdigest()
