"""Names of claims, scopes, media types and roles."""

from collections.abc import Iterable

LTI = "https://purl.imsglobal.org/spec/lti/claim/"
DEEP_LINKING = "https://purl.imsglobal.org/spec/lti-dl/claim/"
AGS = "https://purl.imsglobal.org/spec/lti-ags/"
NRPS = "https://purl.imsglobal.org/spec/lti-nrps/"
TOOL_CONFIGURATION = "https://purl.imsglobal.org/spec/lti-tool-configuration"

ENDPOINT = f"{AGS}claim/endpoint"
NAMES_AND_ROLES = f"{NRPS}claim/namesroleservice"

LINE_ITEM_SCOPE = f"{AGS}scope/lineitem"
RESULT_SCOPE = f"{AGS}scope/result.readonly"
SCORE_SCOPE = f"{AGS}scope/score"
MEMBERSHIP_SCOPE = f"{NRPS}scope/contextmembership.readonly"

LINE_ITEM = "application/vnd.ims.lis.v2.lineitem+json"
LINE_ITEMS = "application/vnd.ims.lis.v2.lineitemcontainer+json"
SCORE = "application/vnd.ims.lis.v1.score+json"
RESULTS = "application/vnd.ims.lis.v2.resultcontainer+json"
MEMBERSHIPS = "application/vnd.ims.lti-nrps.v2.membershipcontainer+json"

RESOURCE_LINK_REQUEST = "LtiResourceLinkRequest"
DEEP_LINKING_REQUEST = "LtiDeepLinkingRequest"
DEEP_LINKING_RESPONSE = "LtiDeepLinkingResponse"

_TEACHING = {"Instructor", "TeachingAssistant", "ContentDeveloper", "Manager"}
_ADMINISTRATING = {"Administrator", "SysAdmin"}
_WATCHING = {"Observer", "ExternalObserver"}  # Sub-roles of a manager that see a course and do nothing in it.
_COURSE = "/membership"
_TEST_USER = "http://purl.imsglobal.org/vocab/lti/system/person#TestUser"


def is_staff(roles: Iterable[str]) -> bool:
    """Return whether roles are those of a course's staff.

    Teaching counts in this course alone: who teaches elsewhere in the institution may study here.
    Administrators count wherever they administrate, also without a role in the course. A sub-role counts as
    the role that it belongs to: `membership/Learner#Instructor` is a learner.
    """
    for role in roles:
        vocabulary, _, name = role.rpartition("#")
        in_course = not vocabulary or _COURSE in vocabulary
        principal = vocabulary.partition(f"{_COURSE}/")[2] or name
        if principal in _ADMINISTRATING or (in_course and principal in _TEACHING and name not in _WATCHING):
            return True
    return False


def is_test_user(roles: Iterable[str]) -> bool:
    """Return whether a platform made somebody up to try things out (LTI 1.3 Core, system roles).

    Canvas's student view and Blackboard's student preview say so, beside the role that is tried. Moodle does
    not: there a teacher switches roles.
    """
    return _TEST_USER in roles


HISTORY = "history"  # Custom parameter in which a copied link names the links that it was copied from.
HISTORY_VARIABLE = "$ResourceLink.id.history"
"""What a platform replaces by their ids, newest first, URL-encoded and separated by commas (LTI Core 1.3,
ResourceLink variables). A platform that does not know it sends it as it stands."""
