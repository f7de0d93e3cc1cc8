"""Is the service alive?"""

from __future__ import annotations

from typing import Literal

from fastapi import APIRouter, Response

from service.routing import ApiRequest, DirectRoute
from service.schemas.base import Wire

router = APIRouter(tags=["service"], route_class=DirectRoute)

_OK = b'{"status":"ok"}'


class Health(Wire):
    """The service's state."""

    status: Literal["ok"]


@router.get("/healthz", response_model=Health, summary="Is the service alive?")
async def healthz(request: ApiRequest) -> Response:
    """Answers as long as requests are served; for load balancers and container health checks."""
    return Response(_OK, media_type="application/json", headers={"Cache-Control": "no-store"})
