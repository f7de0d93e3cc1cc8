"""`framewise serve`: the service over HTTP."""

from __future__ import annotations

import argparse
import gc
import logging
import os
import shutil
import signal
import sys
from typing import TYPE_CHECKING, Any

import uvicorn
from uvicorn.supervisors import Multiprocess

from service.cli.commands import REFUSALS, UNUSABLE, tell
from service.cli.environment import count, require_what_is_named, settings_of_environment
from service.http.connections import server_options
from service.logs import log_configuration
from service.messages import DEFAULT_LANGUAGE
from service.metrics import share_metrics
from service.secret import share_secret
from service.settings import MOST_WORKERS, Settings

if TYPE_CHECKING:
    from fastapi import FastAPI

_LARGEST_PORT = 65535
SILENT_SECONDS = 60
"""So long one of several processes may leave its supervisor without an answer before it is replaced. Loading
takes a second of processor time, for which a sixteenth of a processor needs a quarter of a minute; what is
replaced before it can answer would never serve."""


def add(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare `serve`; its options go before the environment."""
    parser = subparsers.add_parser("serve", help="serve until interrupted")
    parser.add_argument("--host", help="address to listen on (FRAMEWISE_HOST)")
    parser.add_argument("--port", type=_port, help="port to listen on (FRAMEWISE_PORT)")
    parser.add_argument("--workers", type=_workers, help="processes (FRAMEWISE_WORKERS)")
    parser.set_defaults(run=_serve)


def _serve(options: argparse.Namespace) -> int:
    settings = settings_of_environment()
    require_what_is_named(settings)
    signal.signal(signal.SIGTERM, _end)
    chosen: dict[str, Any] = {
        "host": settings.host if options.host is None else options.host,
        "port": settings.port if options.port is None else options.port,
        "log_config": log_configuration(settings),
        **server_options(settings),
    }
    workers = settings.workers if options.workers is None else options.workers
    if workers > 1:
        share_secret()
        figures = share_metrics()
        try:
            config = uvicorn.Config(
                "service.cli.serve:one_of_several",
                factory=True,
                workers=workers,
                timeout_worker_healthcheck=SILENT_SECONDS,
                **chosen,
            )
            supervisor = _Supervisor(config, sockets=[config.bind_socket()])
            supervisor.run()
        finally:
            shutil.rmtree(figures, ignore_errors=True)
        return UNUSABLE if supervisor.could_not_start else 0
    app = application(settings)
    try:
        uvicorn.run(app, **chosen)
    finally:
        app.state.resources.close()  # or they would outlive a server that could not start
    return 0


class _Supervisor(Multiprocess):
    """Looks after the server processes.

    Attributes:
        could_not_start: whether one of the first processes found what it needs missing.
    """

    could_not_start = False

    def init_processes(self) -> None:
        """Start the first processes."""
        super().init_processes()
        self._first = tuple(self.processes)
        self._hear_of_deaths()

    def keep_subprocess_alive(self) -> None:
        """Replace a process that has died; end if a first one could not start, as none would.

        What a later one lacks, such as a database that is away for a while, the others do without.
        """
        if any(each.process.exitcode == UNUSABLE for each in self._first):
            self.could_not_start = True
            self.should_exit.set()
            return
        super().keep_subprocess_alive()
        self._hear_of_deaths()

    def _hear_of_deaths(self) -> None:
        """Close the processes' ends of their pipes here: while one is open, a dead process is waited for."""
        for each in self.processes:
            each.child_conn.close()

    def terminate_all(self) -> None:
        """Have them answer what is in progress; who comes now is refused, and does not wait for nothing."""
        for each in self.sockets:
            each.close()
        super().terminate_all()


def _end(*_: object) -> None:
    """End with status 0: uvicorn repeats the signal once all is answered and closed.

    Threads that still wait for a database or a platform would hold up an ordinary end.
    """
    logging.shutdown()
    os._exit(0)


def one_of_several() -> FastAPI:
    """Return the service for one of several processes; what keeps it from starting is told in a line."""
    try:
        return application()
    except REFUSALS as refusal:
        tell(refusal, DEFAULT_LANGUAGE)
        sys.exit(UNUSABLE)


def application(settings: Settings | None = None) -> FastAPI:
    """Return the service; garbage is not looked for before it serves.

    Nearly all that is loaded stays: each collection would go over it for nothing.
    """
    gc.disable()
    from service.app import create_app  # a process that only looks after others does without all of it

    return create_app(settings)


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > _LARGEST_PORT:
        raise argparse.ArgumentTypeError(f"a port is a number from 0 to {_LARGEST_PORT}, not {text}")
    return int(text)


def _workers(text: str) -> int:
    if (number := count(text)) > MOST_WORKERS:
        raise argparse.ArgumentTypeError(f"at most {MOST_WORKERS} processes, not {text}")
    return number
