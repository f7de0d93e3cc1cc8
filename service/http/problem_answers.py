"""A refusal as it is answered: the problem document (RFC 9457) in the caller's language."""

from starlette.requests import Request
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from kinematics.errors import KinematicsError
from service.http.languages import language_for
from service.http.problem_documents import PROBLEM_JSON, problem_of
from service.http.problems import ServiceError

REQUEST_ID = "request_id"  # Key of the request's id in its scope.


def refusal(request: Request, error: ServiceError | KinematicsError) -> Response:
    """Return the problem document in the caller's language."""
    problem = problem_of(error, request.scope.get(REQUEST_ID, ""))
    language = language_for(request.headers.get("accept-language"))
    resources = request.app.state.resources
    resources.metrics.refused(problem.faults[0].code)
    prefix = request.scope.get("root_path", "")
    body = problem.encoded(language, prefix=prefix, fault_limit=resources.settings.fault_limit)
    told = {"Content-Language": language, "Vary": "Accept-Language", "Cache-Control": "no-store"}
    return Response(body, problem.status, {**problem.headers, **told}, PROBLEM_JSON)


async def refuse(error: ServiceError, scope: Scope, receive: Receive, send: Send) -> None:
    """Answer a request with a refusal."""
    await refusal(Request(scope), error)(scope, receive, send)
