"""Obeys the signed context of a link: under it, only what it leaves on can be called.

It lists what may be called, not what may not: an address that is added later is off until somebody decides.
"""

from collections.abc import Callable, Mapping

from starlette.requests import Request
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from exercises.access import Tool
from exercises.library import Library
from kinematics.errors import Fault
from service.http.link_context import COOKIE, QUERY, LinkContext, kept_token, token_of, verified
from service.http.problems import ForbiddenError, RequestPart, ServiceError

CONTEXT = "link_context"  # Key of the context in a request's scope.

_CALLS: Mapping[str, tuple[Tool, ...]] = {
    "robots": (Tool.CATALOGUE,),
    "forward-kinematics": (Tool.PLAYGROUND, Tool.MATRICES),
    "inverse-kinematics": (Tool.PLAYGROUND,),
    "jacobian": (Tool.PLAYGROUND, Tool.MATRICES),
    "symbolic": (Tool.PLAYGROUND, Tool.MATRICES),
    "dynamics": (Tool.PLAYGROUND, Tool.MATRICES),
    "convert": (Tool.PLAYGROUND, Tool.MATRICES),
    "workspace": (Tool.PLAYGROUND,),
    "trajectory": (Tool.PLAYGROUND,),
    "rates": (Tool.PLAYGROUND, Tool.MATRICES),
    "scm": (Tool.PLAYGROUND, Tool.MATRICES),
    "assign-frames": (Tool.TRAINER,),
    "check-frames": (Tool.TRAINER,),
    "rotations": (Tool.PLAYGROUND,),
    "check-rotation": (Tool.PLAYGROUND,),
    "check-jacobian": (Tool.PLAYGROUND,),
    "check-jacobian-form": (Tool.PLAYGROUND,),
    "check-singularities": (Tool.PLAYGROUND,),
    "check-dynamics": (Tool.PLAYGROUND,),
    "check-screws": (Tool.PLAYGROUND,),
    "compare-tables": (Tool.PLAYGROUND,),
    "other-tables": (Tool.PLAYGROUND, Tool.MATRICES),
    "check-inverse-kinematics": (Tool.PLAYGROUND,),
    "understand": (),
    "session": (),
    "problems": (),
}
"""Calls of the API by the first step of their path, and the switches that turn them off."""

_PAGES: Mapping[str, tuple[Tool, ...]] = {
    "playground": (Tool.PLAYGROUND,),
    "trainer": (Tool.TRAINER,),
    "lesson": (),
    "static": (),
    "locales": (),
    "healthz": (),
    "lti": (),
}
"""Pages and files by the first step of their path; what platforms and sessions call is not the student's."""


_LECTURERS = (["links"], ["scorm.zip"])
"""What of its own exercise a context does not open: making further links and packages is a lecturer's."""


class LinkGuard:
    """Verifies the context that a request brings, and refuses what it switches off."""

    def __init__(
        self,
        app: ASGIApp,
        *,
        secret: bytes,
        library: Library,
        refused: Callable[[Request, ServiceError], Response],
    ) -> None:
        self._app, self._secret, self._library, self._refused = app, secret, library, refused

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one connection."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        fields = dict(scope["headers"])
        named = token_of(fields, scope["query_string"])
        token = kept_token(fields) if named is None else named
        if token is None:
            await self._app(scope, receive, send)
            return
        try:
            context = verified(token, self._secret)
        except ServiceError as error:
            if named is None:  # a link that has ended keeps nobody from what they come by another one for
                await self._app(scope, receive, _with_cookie(send, no_cookie(scope["scheme"])))
            else:
                await self._refused(Request(scope), error)(scope, receive, send)
            return
        scope[CONTEXT] = context
        path = scope["path"].removeprefix(scope.get("root_path", ""))
        if not may_open(path, context, self._library):
            fault = Fault.at("switched_off", path, path=path)
            refusal = ForbiddenError(fault, part=RequestPart.PATH)
            await self._refused(Request(scope), refusal)(scope, receive, send)
            return
        opens_page = QUERY.encode() in scope["query_string"] and not scope["path"].startswith("/api/")
        cookie = _cookie(token, scope["scheme"])
        await self._app(scope, receive, _with_cookie(send, cookie) if opens_page else send)


def may_open(path: str, context: LinkContext, library: Library) -> bool:
    """Return whether the students of a link may open a path: what its context and its exercise leave on."""
    steps = [step for step in path.split("/") if step]
    needed: tuple[Tool, ...] | None
    if steps[:2] == ["api", "v1"]:
        call, rest = (steps[2] if len(steps) > 2 else ""), steps[3:]
        if call == "exercises":
            needed = () if not rest or (rest[0] == context.exercise and rest[1:2] not in _LECTURERS) else None
        else:
            needed = _CALLS.get(call)
    elif steps[:1] == ["exercises"]:
        needed = () if steps[1:2] == [context.exercise] else None
    else:
        needed = _PAGES.get(steps[0]) if steps else None
    return needed is not None and not off_under(context, library).intersection(needed)


def off_under(context: LinkContext, library: Library) -> frozenset[Tool]:
    """Return what is off for the students of a link: by its context, and by its exercise."""
    own = library.exercise(context.exercise).access.off if context.exercise in library.ids else frozenset()
    return context.off | own


def context_of(request: Request) -> LinkContext | None:
    """Return the context under which a request is made, if it brings one."""
    context: LinkContext | None = request.scope.get(CONTEXT)
    return context


def switched_off(request: Request, tool: Tool, library: Library) -> bool:
    """Return whether a tool is off for the student who makes a request."""
    context = context_of(request)
    if context is None:
        return False
    return tool in off_under(context, library)


def no_cookie(scheme: str) -> str:
    """Return the field Set-Cookie that makes a browser forget the context of a link."""
    return f"{_cookie('', scheme)}; Max-Age=0"


def _cookie(token: str, scheme: str) -> str:
    """The field Set-Cookie that keeps a context for all that the student opens in the same browser."""
    secure = "; SameSite=None; Secure; Partitioned" if scheme == "https" else "; SameSite=Lax"
    return f"{COOKIE}={token}; Path=/; HttpOnly{secure}"


def _with_cookie(send: Send, cookie: str) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            message["headers"] = [*message["headers"], (b"set-cookie", cookie.encode("latin-1"))]
        await send(message)

    return sending
