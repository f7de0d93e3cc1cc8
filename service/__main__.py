"""Run the service: `python -m service`, or `framewise` where it is installed."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence

import uvicorn
from pydantic import ValidationError

from exercises.errors import DefinitionError
from service.app import create_app
from service.secret import share_secret
from service.settings import Settings

_LARGEST_PORT = 65535


def main(arguments: Sequence[str] | None = None) -> None:
    """Serve until interrupted; options on the command line go before the environment."""
    settings = _settings()
    parser = argparse.ArgumentParser(prog="framewise", description="Serve kinematics over HTTP.")
    parser.add_argument("--host", default=settings.host, help="address to listen on (%(default)s)")
    parser.add_argument("--port", default=settings.port, type=_port, help="port to listen on (%(default)s)")
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
        share_secret()
        uvicorn.run("service.app:create_app", factory=True, workers=chosen.workers, **options)  # type: ignore[arg-type]
    else:
        try:
            app = create_app(settings)
        except DefinitionError as error:
            sys.exit(f"These exercises cannot be read:\n{error}")
        try:
            uvicorn.run(app, **options)  # type: ignore[arg-type]
        finally:
            app.state.resources.workers.close()  # or they would outlive a server that could not start


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > _LARGEST_PORT:
        raise argparse.ArgumentTypeError(f"a port is a number from 0 to {_LARGEST_PORT}, not {text}")
    return int(text)


def _settings() -> Settings:
    """The settings of the environment; what cannot be understood ends the program with its name."""
    known = {f"FRAMEWISE_{name.upper()}" for name in Settings.model_fields}
    faults = [
        f"  {name}: there is no such setting"
        for name in sorted(os.environ)
        if name.upper().startswith("FRAMEWISE_") and name.upper() not in known
    ]
    try:
        settings = Settings()
    except ValidationError as error:
        faults += [f"  FRAMEWISE_{str(fault['loc'][0]).upper()}: {fault['msg']}" for fault in error.errors()]
    if faults:
        sys.exit("\n".join(("These settings cannot be understood:", *faults)))
    return settings


if __name__ == "__main__":
    main()
