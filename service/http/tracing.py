"""Traces of requests for an OpenTelemetry collector, where the operator names one.

A span says method, route, status and request id: no address, no query, no header, which may name students.
"""

import logging
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from opentelemetry import propagate
from opentelemetry.trace import SpanKind, StatusCode, TracerProvider
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from service import __version__
from service.http.middleware import ROUTE
from service.http.problem_answers import REQUEST_ID

if TYPE_CHECKING:
    from opentelemetry.sdk.trace import TracerProvider as SdkProvider

_FAILED = 500
_log = logging.getLogger("framewise")


class TracingMiddleware:
    """Makes a span of each request, as a part of the trace that its caller names (W3C Trace Context)."""

    def __init__(self, app: ASGIApp, provider: TracerProvider) -> None:
        self._app = app
        self._tracer = provider.get_tracer("framewise", __version__)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one connection."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        fields = {name.decode("latin-1"): value.decode("latin-1") for name, value in scope["headers"]}
        method = scope["method"]
        parent = propagate.extract(fields)
        with self._tracer.start_as_current_span(method, context=parent, kind=SpanKind.SERVER) as span:

            async def noted(message: Message) -> None:
                if message["type"] == "http.response.start":
                    span.set_attribute("http.response.status_code", message["status"])
                    if message["status"] >= _FAILED:
                        span.set_status(StatusCode.ERROR)
                await send(message)

            try:
                await self._app(scope, receive, noted)
            finally:
                route = scope.get(ROUTE, "")
                span.update_name(f"{method} {route}")
                span.set_attribute("http.request.method", method)
                span.set_attribute("http.route", route)
                span.set_attribute("framewise.request_id", scope.get(REQUEST_ID, ""))


def exporting(address: str) -> "SdkProvider":
    """Return a provider that sends spans to a collector every few seconds, the last when it is shut down."""
    from opentelemetry.exporter.otlp.proto.http.trace_exporter import OTLPSpanExporter
    from opentelemetry.sdk.resources import Resource
    from opentelemetry.sdk.trace import TracerProvider as SdkProvider
    from opentelemetry.sdk.trace.export import BatchSpanProcessor

    told: dict[str, Any] = {"service.name": "framewise", "service.version": __version__}
    provider = SdkProvider(resource=Resource.create(told))
    provider.add_span_processor(BatchSpanProcessor(OTLPSpanExporter(endpoint=address)))
    _log.info("Traces are sent to %s", urlsplit(address).hostname)  # the rest may hold a password
    return provider
