"""The application with endpoints that do nothing, to measure what a request costs before any work."""

from fastapi import FastAPI, Response

from service.app import create_app
from service.http.routing import ApiRequest, BytesResponse, DirectRoute


async def _nothing(request: ApiRequest) -> Response:
    await request.body()
    return BytesResponse(b"{}")


def application() -> FastAPI:
    """The service and two empty endpoints: as FastAPI makes them, and as bare as the service's hot calls."""
    app = create_app()

    @app.post("/empty")
    async def empty() -> dict[str, str]:
        return {}

    app.router.routes.insert(0, DirectRoute("/bare", _nothing, methods=["POST"]))
    return app
