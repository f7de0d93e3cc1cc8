"""What the platform around the block knows: people, blocks, and the marks that were published."""

from __future__ import annotations

import uuid
from types import SimpleNamespace
from typing import Any

from lti_consumer.exceptions import LtiError
from lti_consumer.lti_xblock import LtiConsumerXBlock
from lti_consumer.plugin import compat
from opaque_keys.edx.keys import CourseKey
from xblock.field_data import DictFieldData
from xblock.fields import ScopeIds
from xblock.runtime import DictKeyValueStore, KvsFieldData, MemoryIdManager, Runtime

COURSE = "course-v1:Framewise+Robotics+2026"


class CourseRuntime(Runtime):
    """What a block asks its platform for: who is signed in, and a gradebook."""

    def __init__(self, course: Course, user: str, role: str) -> None:
        people = SimpleNamespace(
            get_current_user=lambda: course.person(user, role),
            get_external_user_id=lambda _: course.external(user),
        )
        services = {
            "user": people,
            "rebind_user": SimpleNamespace(rebind_noauth_module_to_user=lambda *_: None),
            "field-data": KvsFieldData(DictKeyValueStore()),
        }
        ids = MemoryIdManager()
        super().__init__(ids, id_generator=ids, services=services)
        self.course, self.user_id = course, user

    def publish(self, block: Any, event_type: str, event_data: dict[str, Any]) -> None:
        if event_type == "grade":
            self.course.published.append({**event_data, "block": str(block.scope_ids.usage_id)})

    def handler_url(self, *_: Any, **__: Any) -> str:
        raise NotImplementedError("LTI 1.1")

    local_resource_url = resource_url = handler_url


class CourseBlock(LtiConsumerXBlock):
    """The block with what it inherits from a course: no closing time."""

    due = graceperiod = None


class Course:
    """What the platform around the block knows: people, blocks, and the marks that were published."""

    def __init__(self) -> None:
        self.externals: dict[str, str] = {}
        self.blocks: dict[str, dict[str, Any]] = {}
        self.published: list[dict[str, Any]] = []

    def external(self, user: str) -> str:
        """Return the pseudonym that a tool gets of somebody."""
        return self.externals.setdefault(user, str(uuid.uuid4()))

    def person(self, user: str, role: str) -> Any:
        """Return somebody as the user service of the platform describes them."""
        told = {"is_authenticated": True, "user_role": role, "user_is_staff": False, "user_id": user}
        attributes = {f"edx-platform.{name}": value for name, value in told.items()}
        return SimpleNamespace(opt_attrs=attributes, full_name=f"{user} of Open edX", emails=[])

    def block(self, location: Any, user: str = "nobody", role: str = "student") -> Any:
        """Return a block of the course, seen by somebody."""
        fields = DictFieldData(dict(self.blocks[str(location)]))
        ids = ScopeIds(user, "lti_consumer", location, location)
        return CourseBlock(CourseRuntime(self, user, role), fields, ids)

    def add(self, name: str, fields: dict[str, Any]) -> Any:
        """Put a block into the course, as an author does in Studio."""
        location = CourseKey.from_string(COURSE).make_usage_key("lti_consumer", name)
        self.blocks[str(location)] = fields
        return location

    def joined(self) -> None:
        """Answer what the block asks its platform."""
        described = SimpleNamespace(
            display_name_with_default="Robotics", display_org_with_default="Framewise"
        )
        compat.load_enough_xblock = self.block
        compat.load_block_as_user = self.block
        compat.get_course_by_id = lambda _: described
        compat.get_user_from_external_user_id = self.known
        compat.get_user_course_forum_role = lambda *_: None
        compat.user_has_studio_write_access = lambda *_: True

    def known(self, external: str) -> Any:
        """Return whom a pseudonym means."""
        for user, pseudonym in self.externals.items():
            if pseudonym == external:
                return SimpleNamespace(id=user)
        raise LtiError("Invalid User")
