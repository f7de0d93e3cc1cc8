"""Platforms that may launch, their invitations, and the keys that this service signs with."""

from dataclasses import dataclass
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses.model import Platform, PlatformStatus, Registration
from courses.people.secrets import hashed, new_token
from courses.refusals import SessionError, unknown_record
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import filled, insert_once, upsert
from kinematics.errors import Fault

INVITATION = timedelta(days=7)
"""How long a registration link is good for: it is sent to an administrator, who has other things to do."""
_PLATFORM = records.platform


@dataclass(frozen=True, kw_only=True, slots=True)
class StoredKey:
    """A key pair of this service: a private JWK as JSON, and from when on it signs."""

    kid: str
    private: str
    created: datetime
    signs_from: datetime


def add_platform(store: Store, platform: Platform, deployments: tuple[str, ...], now: datetime) -> Platform:
    """Insert a platform, or update the one with this issuer and client id; origins stay if none are named.

    Names that were stored and may no longer be are forgotten.
    One that is active and registers itself again at the same addresses stays as the operator has it: nobody
    else can launch by it than before. At other addresses it waits to be activated.
    """
    values = {name: getattr(platform, name) for name in (*_ADDRESSES, "name", "names_shared")}
    values["status"] = platform.status.value
    if platform.origins:
        values["origins"] = list(platform.origins)
    key = {"issuer": platform.issuer, "client_id": platform.client_id}
    with store.writing() as connection:
        if platform.status is PlatformStatus.PENDING:
            values |= _as_it_was(connection, platform)
        own = upsert(connection, _PLATFORM, key, values, {"created": now, "origins": []})
        stored = _platform(connection.execute(sa.select(_PLATFORM).where(_PLATFORM.c.id == own.id)).one())
        for deployment in deployments:
            insert_once(connection, records.deployment, {"platform_id": stored.id, "deployment": deployment})
        if not stored.names_shared:
            people = records.person.c.platform_id == stored.id, records.person.c.name.is_not(None)
            connection.execute(sa.update(records.person).where(*people).values(name=None))
    return stored


_ADDRESSES = ("authorization_endpoint", "token_endpoint", "token_audience", "jwks_uri")


def _as_it_was(connection: sa.Connection, platform: Platform) -> dict[str, Any]:
    """Return what the operator has chosen of a platform that registers itself again."""
    own = _PLATFORM.c.issuer == platform.issuer, _PLATFORM.c.client_id == platform.client_id
    before = connection.execute(sa.select(_PLATFORM).where(*own)).first()
    if before is None:
        return {}
    kept: dict[str, Any] = {"names_shared": before.names_shared}
    if before.status == PlatformStatus.ACTIVE and all(
        getattr(before, name) == getattr(platform, name) for name in _ADDRESSES
    ):
        kept["status"] = before.status
    return kept


def platforms(store: Store) -> list[Platform]:
    """Return every platform, in the order of their registration."""
    with store.reading() as connection:
        return [_platform(row) for row in connection.execute(sa.select(_PLATFORM).order_by(_PLATFORM.c.id))]


def platform_by_id(store: Store, platform_id: int) -> Platform:
    """Return one platform.

    Raises:
        UnknownRecordError: there is no such platform.
    """
    with store.reading() as connection:
        row = connection.execute(sa.select(_PLATFORM).where(_PLATFORM.c.id == platform_id)).first()
    if row is None:
        raise unknown_record("platform")
    return _platform(row)


def platforms_of(store: Store, issuer: str, client_id: str | None) -> list[Platform]:
    """Return platforms of an issuer, one of them if the client is named."""
    found = [each for each in platforms(store) if each.issuer == issuer]
    return [each for each in found if client_id in (None, each.client_id)]


def deployments_of(store: Store, platform_id: int) -> tuple[str, ...]:
    """Return the deployments of a platform that may launch."""
    table = records.deployment
    with store.reading() as connection:
        found = connection.scalars(
            sa.select(table.c.deployment)
            .where(table.c.platform_id == platform_id)
            .order_by(table.c.deployment)
        )
        return tuple(found)


def add_deployment(store: Store, platform_id: int, deployment: str) -> None:
    """Let a deployment of a platform launch.

    Raises:
        UnknownRecordError: there is no such platform.
    """
    with store.writing() as connection:
        own = sa.select(_PLATFORM.c.id).where(_PLATFORM.c.id == platform_id)
        if connection.execute(own.with_for_update()).first() is None:
            raise unknown_record("platform")
        insert_once(connection, records.deployment, {"platform_id": platform_id, "deployment": deployment})


def set_status(store: Store, platform_id: int, status: PlatformStatus) -> None:
    """Let a platform launch, or no longer."""
    own = _PLATFORM.c.id == platform_id
    with store.writing() as connection:
        changed = connection.execute(sa.update(_PLATFORM).where(own).values(status=status.value)).rowcount
    if not changed:
        raise unknown_record("platform")


def remove_platform(store: Store, platform_id: int) -> None:
    """Forget a platform with all of its courses and people, and lines of the log on these or by them."""
    keys = sa.select(records.person.c.key).where(records.person.c.platform_id == platform_id)
    log = records.access.c
    with store.writing() as connection:
        theirs = sa.or_(log.subject.in_(keys), log.actor.in_(keys))
        connection.execute(sa.delete(records.access).where(theirs))
        if not connection.execute(sa.delete(_PLATFORM).where(_PLATFORM.c.id == platform_id)).rowcount:
            raise unknown_record("platform")


def _platform(row: Any) -> Platform:
    return filled(Platform, row, origins=tuple(row.origins), status=PlatformStatus(row.status))


def stored_keys(store: Store) -> list[StoredKey]:
    """Return the service's keys, oldest first."""
    table = records.tool_key
    with store.reading() as connection:
        found = connection.execute(sa.select(table).order_by(table.c.signs_from))
        return [filled(StoredKey, row) for row in found]


def add_key(store: Store, key: StoredKey, *, only_if_none: bool = False) -> None:
    """Store a key. With `only_if_none` the first of several processes that start together wins."""
    table = records.tool_key
    with store.writing() as connection:
        if store.is_postgresql:
            connection.execute(sa.text("LOCK TABLE tool_key IN EXCLUSIVE MODE"))
        if only_if_none and connection.execute(sa.select(table.c.kid).limit(1)).first() is not None:
            return
        names = ("kid", "private", "created", "signs_from")
        connection.execute(sa.insert(table).values({name: getattr(key, name) for name in names}))


def remove_keys(store: Store, kids: tuple[str, ...]) -> None:
    """Forget keys that nothing signed with them can still be valid."""
    with store.writing() as connection:
        connection.execute(sa.delete(records.tool_key).where(records.tool_key.c.kid.in_(kids)))


def invite(store: Store, note: str, now: datetime) -> str:
    """Return a one-time secret for dynamic registration; what is stored is its hash."""
    secret = new_token()
    with store.writing() as connection:
        connection.execute(
            sa.insert(records.registration).values(
                secret_hash=hashed(secret), note=note, created=now, expires=now + INVITATION
            )
        )
    return secret


def invitations(store: Store) -> list[Registration]:
    """Return every invitation, newest first."""
    table = records.registration
    with store.reading() as connection:
        found = connection.execute(sa.select(table).order_by(table.c.id.desc()))
        return [filled(Registration, row) for row in found]


def _usable(secret: str, now: datetime) -> sa.ColumnElement[bool]:
    own = records.registration.c
    return sa.and_(own.secret_hash == hashed(secret), own.used_at.is_(None), own.expires > now)


def check_invitation(store: Store, secret: str, now: datetime) -> None:
    """Make sure that an invitation may still be used.

    Raises:
        SessionError: it was used, is too old, or was never given out.
    """
    wanted = sa.select(records.registration.c.id).where(_usable(secret, now))
    with store.reading() as connection:
        if connection.execute(wanted).first() is None:
            raise SessionError(Fault.at("invitation_used"))


def use_invitation(store: Store, secret: str, now: datetime) -> None:
    """Use an invitation up.

    Raises:
        SessionError: it was used, is too old, or was never given out.
    """
    used = sa.update(records.registration).where(_usable(secret, now)).values(used_at=now)
    with store.writing() as connection:
        if connection.execute(used).rowcount != 1:
            raise SessionError(Fault.at("invitation_used"))
