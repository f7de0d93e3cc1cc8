"""The answer to a deep linking request (Deep Linking 2.0 §4.5)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

from courses.model import Platform
from courses.people.platforms import StoredKey
from courses.people.secrets import new_token
from service.lti import claims as names
from service.lti.signing_keys import signed

LIFE = 300  # Seconds that a browser has to carry an answer to its platform.


@dataclass(frozen=True, kw_only=True, slots=True)
class ContentItem:
    """A link to an exercise.

    Attributes:
        custom: what launches of the link bring back; it survives the copy of a course.
        points: what a full score is worth; None if the platform takes no line items.
        tag: names the exercise in the gradebook.
    """

    address: str
    title: str
    text: str
    custom: Mapping[str, str] = field(default_factory=dict)
    points: float | None = None
    tag: str = ""

    def written(self) -> dict[str, Any]:
        """Return the item as the specification writes it."""
        item: dict[str, Any] = {
            "type": "ltiResourceLink",
            "url": self.address,
            "title": self.title,
            "text": self.text,
            "custom": dict(self.custom),
        }
        if self.points is not None:
            line = {"scoreMaximum": self.points, "label": self.title, "resourceId": self.tag, "tag": self.tag}
            item["lineItem"] = line
        return item


def takes_line_items(settings: Mapping[str, Any]) -> bool:
    """Return whether links may come with line items; what does not say otherwise takes them."""
    return settings.get("accept_lineitem") is not False


def response_token(
    platform: Platform,
    deployment: str,
    settings: Mapping[str, Any],
    items: Sequence[ContentItem],
    key: StoredKey,
    now: datetime,
) -> str:
    """Return the signed answer; it is posted as `JWT` to the request's `deep_link_return_url`."""
    issued = int(now.timestamp())
    claims: dict[str, Any] = {
        "iss": platform.client_id,
        "aud": platform.issuer,
        "iat": issued,
        "exp": issued + LIFE,
        "nonce": new_token(),
        f"{names.LTI}deployment_id": deployment,
        f"{names.LTI}message_type": names.DEEP_LINKING_RESPONSE,
        f"{names.LTI}version": "1.3.0",
        f"{names.DEEP_LINKING}content_items": [item.written() for item in items],
    }
    if "data" in settings:
        claims[f"{names.DEEP_LINKING}data"] = settings["data"]
    return signed(claims, key)
