"""Attempts judged again, by the exercise as it is now."""

from typing import Any

from fastapi import Response

from courses.teaching.regrading import Scope, apply, begin, changes, rejudge, unread
from service.course_callers import (
    course_router,
    grader_of,
    json_response,
    object_body,
    record_number,
    staff_of,
)
from service.course_resources import now
from service.http.routing import ApiRequest
from service.work.regrading_processes import RegradingProcesses

router = course_router()


@router.post("/course/links/{link}/regradings")
async def regrade(request: ApiRequest) -> Response:
    """Judge attempts by the exercise as it is now, and say who would change; nothing changes yet."""
    staff = await staff_of(request)
    link, body = await staff.link(), await object_body(request)
    scope = Scope.ALL if body.get("scope") == "all" else Scope.COUNTED
    grader = grader_of(request)

    def work() -> dict[str, Any]:
        version = grader.version(link.settings)
        run = begin(staff.store, link.id, scope, grader.basis(link.settings), now())
        with RegradingProcesses(grader, link.settings, request.settings) as judge:
            rejudge(staff.store, run, judge)
        told = {"changes": changes(staff.store, run), "unread": unread(staff.store, run)}
        return {"run": run, "version": version, **told}

    found = await staff.run(work)
    await staff.log("regrading", link=link.id, run=found["run"])
    return json_response(found)


@router.post("/course/links/{link}/regradings/{run}/apply")
async def apply_regrading(request: ApiRequest) -> Response:
    """Let the scores of a regrading count."""
    staff = await staff_of(request)
    link, run = await staff.link(), record_number(request, "run")
    grader = grader_of(request)

    def work() -> None:
        apply(staff.store, link.id, run, grader.basis(link.settings), now())

    await staff.run(work)
    await staff.log("regrading applied", link=link.id, run=run)
    return Response(status_code=204)
