"""One person of a course: everything that is stored, and its removal."""

from fastapi import Response

from courses.people.privacy import erase_person, export_person, person_named
from service.course_callers import course_router, json_response, staff_of
from service.http.routing import ApiRequest

router = course_router()


@router.get("/course/people/{person}")
async def export_one(request: ApiRequest) -> Response:
    """Return everything that the course has stored about one of its people."""
    staff = await staff_of(request)
    course = staff.session.course.id
    key = await staff.run(person_named, staff.store, request.path_params["person"], course)
    await staff.log("person", subject=key)
    return json_response(await staff.run(export_person, staff.store, key, course))


@router.delete("/course/people/{person}")
async def erase_one(request: ApiRequest) -> Response:
    """Remove what the course has stored about one of its people."""
    staff = await staff_of(request)
    course = staff.session.course.id
    key = await staff.run(person_named, staff.store, request.path_params["person"], course)
    removed = await staff.run(erase_person, staff.store, key, course)
    await staff.log("person erased")
    return json_response({"removed": removed})
