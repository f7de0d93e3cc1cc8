"""The nginx block of docs/operations.md, behind a real nginx, for a visitor from elsewhere."""

import os
import re
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from tests.architecture.serving import reserved_port, serving
from tests.architecture.sources import ROOT

NGINX = shutil.which("nginx") or shutil.which("nginx", path="/usr/sbin")
pytestmark = pytest.mark.skipif(NGINX is None and not os.environ.get("CI"), reason="needs nginx (make proxy)")

VISITOR = "127.0.0.2"
"""Any address of the loopback network that is no trusted proxy."""


def documented_block() -> str:
    text = (ROOT / "docs/operations.md").read_text(encoding="utf-8")
    found = re.search(r"```nginx\n(.*?)```", text, re.DOTALL)
    assert found
    return found[1]


@pytest.fixture(scope="module")
def visited(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    assert NGINX is not None, "make proxy installs nginx"
    folder = tmp_path_factory.mktemp("nginx")
    command = [sys.executable, "-m", "service", "--port", "0"]
    with serving(command, cwd=ROOT) as address, reserved_port() as port:
        block = documented_block().replace("http://127.0.0.1:8000", address)
        configuration = folder / "nginx.conf"
        configuration.write_text(_configuration(folder, port, block))
        process = subprocess.Popen([NGINX, "-c", str(configuration), "-g", "daemon off;"])
        try:
            _wait_for(port)
            transport = httpx.HTTPTransport(local_address=VISITOR)
            url = f"http://127.0.0.1:{port}/dh"
            with httpx.Client(base_url=url, transport=transport, timeout=120) as client:
                yield client
        finally:
            process.terminate()
            process.wait(timeout=60)


def _configuration(folder: Path, port: int, block: str) -> str:
    kinds = ("client_body", "proxy", "fastcgi", "uwsgi", "scgi")
    temporary = "\n".join(f"{kind}_temp_path {folder}/{kind};" for kind in kinds)
    return f"""
pid {folder}/pid; error_log {folder}/error.log; worker_processes 1;
events {{ worker_connections 64; }}
http {{ access_log off; {temporary} server {{ listen 127.0.0.1:{port}; {block} }} }}
"""


def _wait_for(port: int) -> None:
    for _ in range(10_000):
        try:
            socket.create_connection(("127.0.0.1", port), timeout=60).close()
        except ConnectionRefusedError:
            time.sleep(0.01)
        else:
            return
    raise AssertionError("nginx did not start")


def test_a_visitor_gets_the_pages_and_what_they_load(visited: httpx.Client) -> None:
    page = visited.get("/")
    assert page.status_code == 200
    (first, *_) = re.findall(r'href="\./(static/[^"]+\.css)"', page.text)
    assert visited.get(f"/{first}").status_code == 200
    assert visited.get("/exercises/puma560").status_code == 200


def test_a_visitor_may_call_the_api_and_is_told_addresses_that_lead_back(visited: httpx.Client) -> None:
    answer = visited.post("/api/v1/forward-kinematics", json={"robot": "puma560", "joints": [0] * 6})
    assert answer.status_code == 200
    assert visited.get("/api/v1/openapi.json").json()["servers"] == [{"url": "/dh"}]
    refused = visited.post("/api/v1/jacobian", json={}).json()
    assert refused["type"].startswith("/dh/api/v1/problems/")
    assert visited.get(refused["type"].removeprefix("/dh")).status_code == 200


def test_a_visitor_cannot_choose_the_prefix(visited: httpx.Client) -> None:
    refused = visited.post("/api/v1/jacobian", json={}, headers={"X-Forwarded-Prefix": "/evil"}).json()
    assert refused["type"].startswith("/dh/api/v1/problems/")
