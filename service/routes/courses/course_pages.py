"""The lecturers' pages: the course, and the choice of an exercise for a link."""

from fastapi import APIRouter, Request, Response

from service.resources import resources_of
from service.web.responses import page_response
from service.web.shell import Page

router = APIRouter(include_in_schema=False)

CHOOSE = Page(
    name="choose", title="lecturer-choose-title", messages=("lecturer",), depth=1, styles=("lecturer",)
)
COURSE = Page(
    name="course",
    title="lecturer-title",
    messages=("lecturer", "session", "kinds"),
    styles=("scene", "exercise", "lecturer"),
)


@router.get("/course")
async def course_page(request: Request) -> Response:
    """Return the lecturers' page."""
    resources_of(request).with_courses()
    return page_response(request, COURSE)


@router.get("/lti/choose")
async def choose(request: Request) -> Response:
    """Return the page on which a teacher chooses the exercise of a link.

    Its answer is posted to the platform.
    """
    resources_of(request).with_courses()
    return page_response(request, CHOOSE, form_action="https: http:")
