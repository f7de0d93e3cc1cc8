"""Which addresses of platforms are asked: public ones over https, and those that the operator names."""

import contextlib
import itertools
import socket
import threading
import time
from collections.abc import Iterator, Mapping
from types import SimpleNamespace
from typing import Any

import httpx
import pytest

from service.lti import bounded_connections, fetching
from service.lti.fetching import FetchedAnswer, Fetcher
from service.lti.launch_errors import PlatformError
from service.lti.memberships import members
from tests.lti.key_server import KeyServer

NAMES: Mapping[str, list[str]] = {
    "private.example": ["10.0.0.1"],
    "loopback.example": ["127.0.0.1"],
    "link-local.example": ["fe80::1%eth0"],
    "mapped.example": ["::ffff:10.0.0.1"],
    "metadata.example": ["169.254.169.254"],
    "mixed.example": ["8.8.8.8", "192.168.1.1"],
    "nowhere.example": [],
    "all-machines.example": ["224.0.0.1"],
    "groups.example": ["239.255.255.250"],
    "group-6.example": ["ff02::1"],
    "wide-group-6.example": ["ff0e::1"],
    "6to4.example": ["2002:a9fe:a9fe::1"],
    "nat64.example": ["64:ff9b::a9fe:a9fe"],
    "own-nat64.example": ["64:ff9b:1::a9fe:a9fe"],
    "mapped-metadata.example": ["::ffff:169.254.169.254"],
    "compatible.example": ["::127.0.0.1"],
    "site.example": ["fec0::1"],
    "anything.example": ["0.0.0.0"],
    "anything-6.example": ["::"],
    "relay.example": ["192.88.99.1"],
    "broadcast.example": ["255.255.255.255"],
    "teredo.example": ["2001:0:4136:e378:8000:63bf:3fff:fdd2"],
}


def resolve(host: str, _port: int) -> list[str]:
    """What a hostile name server answers; an address stands for itself."""
    return NAMES.get(host, [host])


@pytest.mark.parametrize(
    "address",
    [
        *(f"https://{name}/jwks" for name in NAMES),
        "https://127.0.0.1/jwks",
        "https://[::1]/jwks",
        "http://8.8.8.8/jwks",
        "https://user@8.8.8.8/jwks",
        "https:///jwks",
        "ftp://8.8.8.8/jwks",
        "file:///etc/passwd",
        "https://8.8.8.8:port/jwks",
    ],
)
def test_what_is_not_public_https_is_not_asked(address: str) -> None:
    fetcher = Fetcher(frozenset({"https://lms.example"}), resolve)
    with pytest.raises(PlatformError) as refused:
        fetcher.get_json(address)
    assert [fault.code for fault in refused.value.faults] == ["lti_address_refused"]


@pytest.mark.parametrize("found", ["8.8.8.8", "2606:4700::1", "64:ff9b::808:808", "::ffff:8.8.8.8"])
def test_what_is_public_is_asked(found: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Through NAT64 too: a service without IPv4 reaches all platforms with IPv4 alone by it."""
    asked: list[str] = []

    def handle(request: httpx.Request) -> httpx.Response:
        asked.append(request.url.host)
        return httpx.Response(200, json={})

    fetcher = Fetcher(resolve=lambda _host, _port: [found])
    monkeypatch.setitem(fetcher.__dict__, "_client", httpx.Client(transport=httpx.MockTransport(handle)))
    fetcher.get_json("https://lms.example/jwks")
    assert asked == [found]


@pytest.fixture(scope="module")
def server() -> Iterator[KeyServer]:
    with KeyServer() as found:
        yield found


@pytest.mark.parametrize("written", ["http://{}", "http://{}/", "HTTP://{}"])
def test_a_trusted_origin_is_asked_however_it_is_written(server: KeyServer, written: str) -> None:
    """With a slash at its end, capitals or the usual port it was never found again."""
    trusted = written.format(server.root.removeprefix("http://"))
    fetcher = Fetcher(frozenset({trusted}))
    document, _ = fetcher.get_json(f"{server.root}/jwks")
    assert document["keys"]
    fetcher.close()


@pytest.mark.parametrize(
    "begun", [b"", b"HTTP/1.1 200 OK\r\nX: ", b"HTTP/1.1 200 OK\r\nContent-Length: 100000\r\n\r\n"]
)
def test_an_answer_that_drips_in_is_given_up(begun: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each piece came in time, so that the thread read on for as long as the platform liked.

    Time passes once the answer has begun.
    """
    passed = 0.0
    monkeypatch.setattr(bounded_connections, "time", SimpleNamespace(monotonic=lambda: passed))
    with socket.create_server(("127.0.0.1", 0)) as listener:
        root = f"http://127.0.0.1:{listener.getsockname()[1]}"

        def drip() -> None:
            nonlocal passed
            connection, _ = listener.accept()
            with connection, contextlib.suppress(OSError):
                connection.recv(4096)
                connection.sendall(begun)
                for piece in itertools.count():
                    connection.sendall(b"1")
                    if piece == 10:
                        passed = fetching.WHOLE_ANSWER + 1.0
                    time.sleep(0.01)

        thread = threading.Thread(target=drip)
        thread.start()
        fetcher = Fetcher(frozenset({root}))
        with pytest.raises(PlatformError) as refused:
            fetcher.get_json(f"{root}/jwks")
        assert [fault.code for fault in refused.value.faults] == ["lti_unreachable"]
        fetcher.close()
        thread.join()


def answered(**headers: str) -> FetchedAnswer:
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    return FetchedAnswer(address="https://lms.example/items?page=1", status=503, headers=named, body=b"")


@pytest.mark.parametrize(
    ("text", "seconds"),
    [("", None), ("7", 7.0), ("Fri, 27 Nov 2020 03:29:18 GMT", 0.0), ("soon", None), ("-1", None),
     ("Fri, 27 Nov 99999999999999999999 03:29:18 GMT", None), ("9" * 400, float("inf"))],
)  # fmt: skip
def test_how_long_a_platform_asks_to_be_left_alone(text: str, seconds: float | None) -> None:
    assert answered(retry_after=text).retry_after == seconds


@pytest.mark.parametrize(
    ("link", "page"),
    [("", None), ("<>;;=", None), ('<?page=2>; rel="prev"', None),
     ('<?page=2>; rel="next"', "https://lms.example/items?page=2"),
     ('<https://other.example/>; rel="next"', None), ('<mailto:lms>; rel="next"', None),
     ('<https://[>; rel="next"', None), ('<https://lms.example:port/>; rel="next"', None)],
)  # fmt: skip
def test_the_next_page_is_one_of_the_same_origin(link: str, page: str | None) -> None:
    assert answered(link=link).next_page() == page


def test_a_class_list_that_leads_round_in_a_circle_is_read_once() -> None:
    """Some platforms name the last page as its own next one: it was fetched two hundred times."""
    asked: list[str] = []

    def call(_: Any, __: Any, ___: str, address: str, **____: Any) -> FetchedAnswer:
        asked.append(address)
        found = answered(link='<?page=2>; rel="next"')
        body = b'{"members": [{"user_id": "%d", "roles": ["Learner"]}]}' % len(asked)
        return FetchedAnswer(address=address, status=200, headers=found.headers, body=body)

    services: Any = SimpleNamespace(call=call)
    platform: Any = None
    listed = members(services, platform, "https://lms.example/items?page=1")
    assert [member.user for member in listed] == ["1", "2"]
