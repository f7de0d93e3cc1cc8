"""A service that runs beside the tests and is asked over HTTP."""

import contextlib
import socket
import threading
import time
from collections.abc import Iterator
from unittest.mock import patch

import uvicorn

import service.app
from service.app import create_app
from service.http.connections import server_options
from service.settings import Settings
from service.work.workers import Workers


@contextlib.contextmanager
def running(settings: Settings, *, ahead: bool = False) -> Iterator[str]:
    """Serve on a free port in a thread; yields the base URL.

    Its worker processes start, and the exercises are read, with the first request that needs them, unless it
    is to do so ahead, as services do: most tests need neither, and a start would cost four times as much.
    """
    listener = socket.create_server(("127.0.0.1", 0))
    config = uvicorn.Config(
        create_app(settings),
        log_level="warning",
        lifespan="on",
        **server_options(settings),
    )
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
    with contextlib.ExitStack() as lazily:
        if not ahead:
            lazily.enter_context(patch.object(Workers, "warm"))
            lazily.enter_context(patch.object(service.app, "ReadingAhead"))
        thread.start()
        while not server.started and thread.is_alive():
            time.sleep(0.005)
    try:
        yield f"http://127.0.0.1:{listener.getsockname()[1]}"
    finally:
        server.should_exit = True
        thread.join(timeout=60)
        listener.close()
