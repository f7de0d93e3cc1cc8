"""Run the service: `python -m service`, or `framewise` where it is installed."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

import uvicorn

from service.app import create_app
from service.settings import Settings


def main(arguments: Sequence[str] | None = None) -> None:
    """Serve until interrupted; options on the command line go before the environment."""
    settings = Settings()
    parser = argparse.ArgumentParser(prog="framewise", description="Serve kinematics over HTTP.")
    parser.add_argument("--host", default=settings.host, help="address to listen on (%(default)s)")
    parser.add_argument("--port", default=settings.port, type=int, help="port to listen on (%(default)s)")
    parser.add_argument("--workers", default=settings.workers, type=int, help="processes (%(default)s)")
    chosen = parser.parse_args(arguments)
    options: dict[str, object] = {
        "host": chosen.host,
        "port": chosen.port,
        "access_log": settings.access_log,
        "proxy_headers": True,
        "forwarded_allow_ips": list(settings.trusted_proxies),
        "server_header": False,
    }
    if chosen.workers > 1:
        uvicorn.run("service.app:create_app", factory=True, workers=chosen.workers, **options)  # type: ignore[arg-type]
    else:
        uvicorn.run(create_app(settings), **options)  # type: ignore[arg-type]


if __name__ == "__main__":
    main()
