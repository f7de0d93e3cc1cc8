"""Who counts as staff, by the roles of LTI 1.3 Core's vocabularies."""

import pytest

from service.lti.claims import is_staff, is_test_user

LIS = "http://purl.imsglobal.org/vocab/lis/v2"
SYSTEM = "http://purl.imsglobal.org/vocab/lti/system/person"


@pytest.mark.parametrize(
    "role",
    [
        f"{LIS}/membership#Instructor",
        f"{LIS}/membership#ContentDeveloper",
        f"{LIS}/membership#Administrator",
        f"{LIS}/membership#Manager",
        f"{LIS}/membership/Instructor#TeachingAssistant",
        f"{LIS}/membership/Instructor#Grader",
        f"{LIS}/membership/Administrator#Support",
        f"{LIS}/membership/ContentDeveloper#Librarian",
        f"{LIS}/membership/Manager#CourseCoordinator",
        f"{LIS}/institution/person#Administrator",
        f"{LIS}/system/person#SysAdmin",
        "Instructor",
        "TeachingAssistant",
    ],
)
def test_staff(role: str) -> None:
    assert is_staff([f"{LIS}/institution/person#Student", role])


@pytest.mark.parametrize(
    "role",
    [
        f"{LIS}/membership#Learner",
        f"{LIS}/membership#Mentor",
        f"{LIS}/membership/Learner#Instructor",
        f"{LIS}/membership/Mentor#Auditor",
        f"{LIS}/membership/Manager#Observer",
        f"{LIS}/membership/Manager#ExternalObserver",
        f"{LIS}/institution/person#Instructor",
        f"{LIS}/institution/person#Faculty",
        f"{SYSTEM}#TestUser",
        "Learner",
        "",
        "#",
    ],
)
def test_no_staff(role: str) -> None:
    """A learner with the sub-role Instructor was let onto the lecturers' pages."""
    assert not is_staff([role])


def test_a_user_made_up_to_try_things_out_says_so_beside_the_role_that_is_tried() -> None:
    assert is_test_user([f"{LIS}/membership#Learner", f"{SYSTEM}#TestUser"])
    assert not is_test_user([f"{LIS}/membership#Learner", f"{LIS}/membership/Learner#NonCreditLearner", ""])
