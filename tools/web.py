"""A running service and a Chromium, for scripts that look at pages."""

import contextlib
import os
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

from playwright.sync_api import Browser, sync_playwright

ROOT = Path(__file__).resolve().parent.parent
ARGUMENTS = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking"]
PATIENCE = 120.0
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "chromium-headless-shell")
"""Figures and pictures are of the browser that people have, where it is installed."""


@contextlib.contextmanager
def service(**settings: str) -> Iterator[str]:
    """The service in a process of its own, with settings as variables; yields its origin."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
    command = [sys.executable, "-m", "service", "--port", str(port)]
    process = subprocess.Popen(command, cwd=ROOT, env={**os.environ, **settings})
    origin = f"http://127.0.0.1:{port}"
    try:
        give_up = time.monotonic() + PATIENCE
        while True:
            try:
                urlopen(f"{origin}/api/v1/exercises", timeout=5).close()  # noqa: S310  our own address
                break
            except (URLError, ConnectionError):
                if process.poll() is not None or time.monotonic() > give_up:
                    raise
                time.sleep(0.1)
        yield origin
    finally:
        process.terminate()
        process.wait(timeout=10)


@contextlib.contextmanager
def chromium() -> Iterator[Browser]:
    """The system's Chromium."""
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None:
        sys.exit("Chromium is not installed; `make browser` installs it")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=found, args=ARGUMENTS)
        try:
            yield browser
        finally:
            browser.close()
