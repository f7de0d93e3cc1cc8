"""Names and Role Provisioning Services 2.0: who is in a course."""

import time
from collections.abc import Mapping
from dataclasses import dataclass

from courses.model import Platform
from service.lti import claims as names
from service.lti.launch_errors import unreachable
from service.lti.services import Services

PAGES = 200  # Pages that are followed, each once.
LONGEST = 30.0
"""Seconds for all pages together: a lecturer waits for them, and a thread of everybody's courses."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Member:
    """Somebody in a course; a name only if the platform shares it."""

    user: str
    name: str | None
    is_student: bool


def members(services: Services, platform: Platform, address: str) -> list[Member]:
    """Return the active members of a course, from every page.

    Raises:
        PlatformError: the platform does not tell.
    """
    found: list[Member] = []
    page: str | None = address
    read: set[str] = set()
    end = time.monotonic() + LONGEST
    while page is not None and page not in read and len(read) < PAGES:
        read.add(page)
        if time.monotonic() > end:
            raise unreachable(page, f"> {LONGEST:g} s")
        answer = services.call(platform, names.MEMBERSHIP_SCOPE, "GET", page, accept=names.MEMBERSHIPS)
        container = answer.succeeded().json()
        listed = container.get("members") if isinstance(container, Mapping) else None
        if not isinstance(listed, list):
            raise unreachable(page, "members")
        found += [_member(entry) for entry in listed if _is_active(entry)]
        page = answer.next_page()
    return found


def _is_active(entry: object) -> bool:
    return (
        isinstance(entry, Mapping)
        and isinstance(entry.get("user_id"), str)
        and entry.get("status", "Active") == "Active"
    )


def _member(entry: Mapping[str, object]) -> Member:
    told = entry.get("roles")
    roles = [str(role) for role in told] if isinstance(told, list) else []
    name = entry.get("name")
    return Member(
        user=str(entry["user_id"]),
        name=name if isinstance(name, str) else None,
        is_student=not names.is_staff(roles) and not names.is_test_user(roles),
    )
