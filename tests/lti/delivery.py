"""Students of the platform, enrolled without a launch."""

from courses.model import CourseSession, Role
from courses.people.enrolment import Arrival, arrive
from courses.people.platforms import platforms_of
from courses.people.sessions import session_of
from courses.storage.database import Store
from service.course_resources import now
from tests.lti.classes import Lms
from tests.lti.platform_process import CLIENT, DEPLOYMENT


def enrolled(store: Store, lms: Lms, user: str, resource: str = "delivery") -> CourseSession:
    """A student at a link with a line item."""
    (platform,) = platforms_of(store, lms.root, CLIENT)
    told = Arrival(
        platform=platform,
        subject=user,
        role=Role.LEARNER,
        deployment=DEPLOYMENT,
        context="delivery",
        resource=resource,
        exercise_id="puma560",
        line_item=f"{lms.root}/lineitems/{resource}/lineitem?type_id=1",
    )
    token, _ = arrive(store, told, now())
    return session_of(store, token, now())
