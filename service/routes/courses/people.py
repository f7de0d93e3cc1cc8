"""One person of a course: everything that is stored, and its removal."""

from __future__ import annotations

from fastapi import Response

from courses.privacy import erase_person, export_person, person_in
from service.course_callers import json_response, staff_of
from service.http.routing import ApiRequest, DirectRoute, api_router

router = api_router("courses", route_class=DirectRoute)
router.include_in_schema = False


@router.get("/course/people/{person}")
async def export_one(request: ApiRequest) -> Response:
    """Return everything that is stored about one person of the course."""
    staff = await staff_of(request)
    key = request.path_params["person"]
    await staff.run(person_in, staff.store, staff.session.course.id, key)
    await staff.log("person", subject=key)
    return json_response(await staff.run(export_person, staff.store, key))


@router.delete("/course/people/{person}")
async def erase_one(request: ApiRequest) -> Response:
    """Remove one person of the course with everything that is stored about them."""
    staff = await staff_of(request)
    key = request.path_params["person"]
    await staff.run(person_in, staff.store, staff.session.course.id, key)
    removed = await staff.run(erase_person, staff.store, key)
    await staff.log("person erased")
    return json_response({"removed": removed})
