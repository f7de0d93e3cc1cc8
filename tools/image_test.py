"""Run an image as it is meant to be run, and ask it for everything: `make image`.

    python tools/image_test.py IMAGE [ENGINE]

ENGINE is podman or docker, with options, such as "podman --runtime runc". The container is read-only, has no
capability, 512 MB of memory and a user of its own. Asked are the probes, every page in every language, every
example of the OpenAPI document, closed forms in every format, and a receipt as PDF in every language. Exits
with 1, and says what was wrong, if anything was.
"""

import json
import shlex
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager

LANGUAGES = ("en", "es", "fr", "pt", "ro", "uk")
LARGEST = 250_000_000
"""Bytes of an image, all layers unpacked."""
PORT = 18231
API = "/api/v1"
RIGHTS = ("--read-only", "--cap-drop", "ALL", "--security-opt", "no-new-privileges")
ROOM = ("--tmpfs", "/tmp", "--memory", "512m", "--pids-limit", "256")  # noqa: S108
TABLE = {
    "convention": "standard",
    "rows": [
        {"theta": "q1", "d": 0, "a": "L1", "alpha": 0},
        {"theta": "q2", "d": 0, "a": "L2", "alpha": 0},
    ],
}


def main() -> int:
    """Run the image, ask it, weigh it."""
    image, *rest = sys.argv[1:]
    engine = shlex.split(rest[0]) if rest else ["podman"]
    told = subprocess.run(
        [*engine, "image", "inspect", "--format", "{{.Size}}", image],
        capture_output=True,
        text=True,
        check=True,
    )
    size = int(told.stdout)
    print(f"{image}: {size / 1e6:.1f} MB")
    with running(engine, image):
        wrong = list(asked())
    if size > LARGEST:
        wrong.append(f"the image weighs {size / 1e6:.1f} MB, more than {LARGEST / 1e6:.0f}")
    print("\n".join(wrong) or "everything is answered")
    return int(bool(wrong))


@contextmanager
def running(engine: list[str], image: str) -> Iterator[None]:
    """The container, until the block ends; what it wrote is shown if it does not start."""
    port = ("--network", "host", "--env", f"FRAMEWISE_PORT={PORT}")
    command = [*engine, "run", "--detach", *port, *RIGHTS, *ROOM, image]
    started = subprocess.run(command, capture_output=True, text=True, check=True)
    container = started.stdout.strip().splitlines()[-1]
    try:
        for _ in range(600):
            if status("GET", "/readyz")[0] == 200:
                break
            time.sleep(0.1)
        else:
            subprocess.run([*engine, "logs", container], check=False)
            raise SystemExit("the container does not get ready")
        yield
    finally:
        remove = [*engine, "rm", "--force", "--volumes", container]
        subprocess.run(remove, check=False, capture_output=True)


def status(method: str, path: str, body: object = None, **headers: str) -> tuple[int, bytes]:
    """Status and body of an answer; 0 where there is none."""
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(
        f"http://127.0.0.1:{PORT}{path}", data, {"Content-Type": "application/json", **headers}, method=method
    )
    try:
        with urllib.request.urlopen(request, timeout=60) as response:  # noqa: S310 – always our own address
            return response.status, response.read()
    except urllib.error.HTTPError as error:
        return error.code, error.read()
    except OSError:
        return 0, b""


def asked() -> Iterator[str]:
    """Everything, and what was wrong with the answers."""
    for path in ("/livez", "/readyz", "/version", "/metrics", "/lti/jwks", f"{API}/receipts/keys"):
        yield from expected(path, 200, *status("GET", path))
    for path in (f"{page}?lang={language}" for page in PAGES for language in LANGUAGES):
        yield from expected(path, 200, *status("GET", path))
    described = json.loads(status("GET", f"{API}/openapi.json")[1])
    for path, operations in described["paths"].items():
        content = operations.get("post", {}).get("requestBody", {}).get("content", {})
        for name, example in content.get("application/json", {}).get("examples", {}).items():
            if "{" in path.replace("{exercise_id}", "") or "session" in path or "course" in path:
                continue
            address = API + path.removeprefix(API).replace("{exercise_id}", "twolink")
            code, found = status("POST", address, example["value"])
            if code == 0 or code >= 500:
                yield from expected(f"{path} ({name})", 200, code, found)
    formats = described["components"]["schemas"]["Format"]["enum"]
    code, found = status("POST", f"{API}/symbolic", {"table": TABLE, "formats": formats})
    yield from expected(f"closed forms as {', '.join(formats)}", 200, code, found)
    for language in LANGUAGES:
        told = {"Accept-Language": language}
        code, found = status(
            "POST", f"{API}/exercises/twolink/receipts.pdf", {"table": TABLE, "name": "Ґалаґан"}, **told
        )
        yield from expected(f"a receipt as PDF, {language}", 200, code if found[:4] == b"%PDF" else 0, found)


def expected(what: str, code: int, given: int, found: bytes) -> Iterator[str]:
    """What is said of an answer that has another status."""
    if given != code:
        yield f"{what}: {given} {found[:300].decode(errors='replace')}"


PAGES = ("/", "/exercises/twolink", "/exercises/puma560", "/author", "/receipts", "/playground", "/lesson")

if __name__ == "__main__":
    sys.exit(main())
