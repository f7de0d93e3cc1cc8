"""`framewise serve`: the service over HTTP."""

import argparse
import gc
import logging
import os
import pickle
import shutil
import signal
import sys
import time
from typing import TYPE_CHECKING, Any

import uvicorn
from uvicorn.config import STARTUP_FAILURE
from uvicorn.supervisors import Multiprocess
from uvicorn.supervisors.multiprocess import Process

from service.cli.commands import REFUSALS, UNUSABLE, tell
from service.cli.environment import Subparsers, count_up_to, require_what_is_named, settings_of_environment
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


_ENDING_SECONDS = 12
"""So much longer than requests may take to finish may a process take to end: it gives up after ten."""
_log = logging.getLogger("uvicorn.error")


def add(subparsers: Subparsers) -> None:
    """Declare `serve`; its options go before the environment."""
    parser = subparsers.add_parser("serve", help="serve until interrupted")
    parser.add_argument("--host", help="address to listen on (FRAMEWISE_HOST)")
    parser.add_argument("--port", type=_port, help="port to listen on (FRAMEWISE_PORT)")
    parser.add_argument(
        "--workers", type=count_up_to(MOST_WORKERS, "processes"), help="processes (FRAMEWISE_WORKERS)"
    )
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
                "service.cli.serve:one_of_several", factory=True, workers=workers, **chosen
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
        self._asked: dict[Process, float] = {}
        super().init_processes()
        self._first = tuple(self.processes)

    def keep_subprocess_alive(self) -> None:
        """Replace a process that has died or says nothing; end if a first one could not start, as none would.

        What a later one lacks, such as a database that is away for a while, the others do without.
        """
        if any(each.process.exitcode in (UNUSABLE, STARTUP_FAILURE) for each in self._first):
            self.could_not_start = True
            self.should_exit.set()
            return
        for place, each in enumerate(self.processes):
            if each.process.is_alive() and self._answers(each):
                continue
            each.kill()
            each.join()
            _log.warning("Process %d has died or said nothing, and is replaced", each.pid)
            self._asked.pop(each, None)
            self.processes[place] = Process(self.config, self.sockets)
            self.processes[place].start()

    def _answers(self, process: Process) -> bool:
        """Return whether a process answers, or may still do so; ask it once it has.

        Nothing is waited for here: meanwhile another one may die, or all be told to end.
        """
        asked = self._asked.get(process)
        try:
            if asked is not None and not process.parent_conn.poll():
                return time.monotonic() - asked < SILENT_SECONDS
            if asked is not None:
                process.parent_conn.recv()
            process.parent_conn.send(b"ping")
        except (OSError, EOFError, pickle.UnpicklingError):
            return False
        self._asked[process] = time.monotonic()
        return True

    def terminate_all(self) -> None:
        """Have them answer what is in progress; who comes now is refused, and does not wait for nothing."""
        for each in self.sockets:
            each.close()
        super().terminate_all()

    def join_all(self) -> None:
        """Wait for their ends; end those that take longer than they may."""
        end = time.monotonic() + (self.config.timeout_graceful_shutdown or 0) + _ENDING_SECONDS
        for each in self.processes:
            each.process.join(max(0.0, end - time.monotonic()))
            if each.process.is_alive():
                _log.error("Process %d does not end, and is killed", each.pid)
                each.process.kill()
        super().join_all()


def _end(*_: object) -> None:
    """End with status 0: uvicorn repeats the signal once all is answered and closed.

    Threads that still wait for a database or a platform would hold up an ordinary end.
    """
    logging.shutdown()
    os._exit(0)


def one_of_several() -> "FastAPI":
    """Return the service for one of several processes; what keeps it from starting is told in a line."""
    try:
        return application()
    except REFUSALS as refusal:
        tell(refusal, DEFAULT_LANGUAGE)
        sys.exit(UNUSABLE)


def application(settings: Settings | None = None) -> "FastAPI":
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
