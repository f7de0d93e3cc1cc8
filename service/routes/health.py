"""Is the service alive?"""

from __future__ import annotations

from typing import Literal

from fastapi import APIRouter, Response

from service.schemas.base import Wire

router = APIRouter(tags=["service"])


class Health(Wire):
    """The service's state."""

    status: Literal["ok"]


@router.get("/healthz", summary="Is the service alive?")
async def healthz(response: Response) -> Health:
    """Answers as long as requests are served; for load balancers and container health checks."""
    response.headers["Cache-Control"] = "no-store"
    return Health(status="ok")
