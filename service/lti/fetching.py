"""Requests to platforms: https to public addresses only, no redirects, bounded in time and size.

A host is resolved once, and the address that was checked is the one that is connected to, so that a name
cannot point inside the network after it was looked at. Origins that the operator trusts may be anything.
"""

import ipaddress
import re
import socket
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from email.utils import parsedate_to_datetime
from functools import cached_property
from typing import TYPE_CHECKING, Any
from urllib.parse import urljoin, urlsplit

import orjson

from kinematics.errors import Fault
from service.lti.launch_errors import PlatformError, unreachable

if TYPE_CHECKING:  # its command line and its certificates take 6 MB: only who sends something loads it
    import httpx

    from service.lti.bounded_connections import BoundedTransport

TIMEOUT = 5.0  # Seconds that a platform may take to begin its answer, and to go on with it.
WHOLE_ANSWER = 20.0
"""Seconds for the whole of it: a thread that reads what drips in is missing to everybody's launches."""
LARGEST = 1024 * 1024  # Largest answer that is read [byte].
_HOST = re.compile(r"[a-z0-9_-]+(\.[a-z0-9_-]+)*|[0-9a-f:.]+")
"""A host as browsers write it; whatever else would end a directive of a policy, or a line of a header."""
_MAPPED = ipaddress.ip_network("::ffff:0:0/96")
_NAT64 = ipaddress.ip_network("64:ff9b::/96")
_UNICAST = ipaddress.ip_network("2000::/3")
"""What is given out of IPv6: all else is for groups, for translation, for one site, or for nothing yet."""
_RELAYS = ipaddress.ip_network("192.88.99.0/24")  # Relays of 6to4.
Resolve = Callable[[str, int], list[str]]


@dataclass(frozen=True, kw_only=True, slots=True)
class FetchedAnswer:
    """What a platform answered."""

    address: str
    status: int
    headers: Mapping[str, str]
    body: bytes

    def json(self) -> Any:
        """Return the body as JSON.

        Raises:
            PlatformError: it is none.
        """
        try:
            return orjson.loads(self.body)
        except orjson.JSONDecodeError:
            raise unreachable(self.address, "JSON") from None

    @property
    def is_success(self) -> bool:
        """Whether the platform did what it was asked."""
        return self.status // 100 == 2

    def succeeded(self) -> "FetchedAnswer":
        """Return this answer, if the platform did what it was asked.

        Raises:
            PlatformError: it did not.
        """
        if not self.is_success:
            reason = f"HTTP {self.status}"
            raise unreachable(self.address, reason, status=self.status, retry_after=self.retry_after)
        return self

    @property
    def retry_after(self) -> float | None:
        """How long the platform asks to be left alone [s]."""
        text = self.headers.get("retry-after", "").strip()
        if text.isdecimal():
            return float(text)
        try:
            return max(0.0, parsedate_to_datetime(text).timestamp() - time.time()) if text else None
        except (ValueError, OverflowError):
            return None

    def next_page(self) -> str | None:
        """Return the address of the next page (RFC 8288), on the same origin only."""
        import httpx

        link = httpx.Response(200, headers={"Link": self.headers.get("link", "")}).links.get("next")
        try:
            address = urljoin(self.address, link["url"]) if link and "url" in link else None
            return address if address and origin_of(address) == origin_of(self.address) else None
        except ValueError:  # of no address, or of none that is fetched
            return None


class Fetcher:
    """Sends requests to platforms."""

    def __init__(self, trusted: frozenset[str] = frozenset(), resolve: Resolve | None = None) -> None:
        self._trusted = frozenset(map(origin_of, trusted))
        self._resolve = resolve or _resolve

    @cached_property
    def _client(self) -> "httpx.Client":
        import httpx

        return httpx.Client(
            transport=self._transport, timeout=TIMEOUT, follow_redirects=False, trust_env=False
        )

    @cached_property
    def _transport(self) -> "BoundedTransport":
        from service.lti.bounded_connections import BoundedTransport

        return BoundedTransport()

    def close(self) -> None:
        """End every connection."""
        if "_client" in self.__dict__:
            self._client.close()

    def send(
        self,
        method: str,
        address: str,
        *,
        headers: Mapping[str, str] | None = None,
        content: bytes | None = None,
    ) -> FetchedAnswer:
        """Return the answer to a request, whatever its status.

        Raises:
            PlatformError: the address is not fetched, does not answer in time, or answers too much.
        """
        import httpx

        url, extensions, host = self._checked(address)
        sent = {"Accept": "application/json", **(headers or {}), "Host": host}
        try:
            with (
                self._transport.within(WHOLE_ANSWER),
                self._client.stream(
                    method, url, headers=sent, content=content, extensions=extensions
                ) as answer,
            ):
                body = bytearray()
                for piece in answer.iter_bytes():
                    body += piece
                    if len(body) > LARGEST:
                        raise unreachable(address, f"> {LARGEST}")
                return FetchedAnswer(
                    address=address, status=answer.status_code, headers=answer.headers, body=bytes(body)
                )
        except (httpx.HTTPError, httpx.InvalidURL, OSError, ValueError) as error:
            raise unreachable(address, type(error).__name__) from error

    def get_json(self, address: str) -> tuple[Any, FetchedAnswer]:
        """Return the JSON at an address.

        Raises:
            PlatformError: there is none.
        """
        answer = self.send("GET", address).succeeded()
        return answer.json(), answer

    def refuses(self, address: str) -> bool:
        """Return whether an address is never fetched, as it is written; names are not looked up."""
        try:
            host = urlsplit(address).hostname or ""
            if origin_of(address) in self._trusted:
                return False
        except ValueError:
            return True
        if not address.startswith("https:") or host == "localhost":
            return True
        try:
            return not _is_public(ipaddress.ip_address(host))
        except ValueError:
            return False

    def _checked(self, address: str) -> "tuple[httpx.URL, dict[str, Any], str]":
        """The address to connect to, with the host's name for TLS, and the Host field."""
        import httpx

        try:
            url = httpx.URL(address)
            origin = origin_of(address)
        except (httpx.InvalidURL, ValueError):
            raise _refused(address) from None
        host = url.netloc.decode("ascii").rpartition("@")[2]
        if origin in self._trusted:
            return url, {}, host
        if url.scheme != "https" or not url.host or url.userinfo:
            raise _refused(address)
        try:
            found = self._resolve(url.host, url.port or 443)
        except OSError as error:
            raise unreachable(address, type(error).__name__) from error
        if not found or not all(_is_public(ipaddress.ip_address(ip.partition("%")[0])) for ip in found):
            raise _refused(address)
        return url.copy_with(host=found[0]), {"sni_hostname": url.host}, host


def origin_of(address: str) -> str:
    """Return the scheme, host and port of an address, the usual port left out.

    Raises:
        ValueError: it is not an http or https address.
    """
    parts = urlsplit(address)
    if parts.scheme not in ("http", "https") or not parts.hostname:
        raise ValueError(address)
    usual = {"http": 80, "https": 443}[parts.scheme]
    host = f"[{parts.hostname}]" if ":" in parts.hostname else parts.hostname
    port = parts.port
    return f"{parts.scheme}://{host}" + ("" if port in (None, usual) else f":{port}")


def http_address(text: str) -> str:
    """Return an address that was typed, or that a platform names, without spaces around it.

    Raises:
        ValueError: it is not an http or https address.
    """
    address = text.strip()
    if " " in address or not address.isprintable():
        raise ValueError(address)
    origin_of(address)
    if not _HOST.fullmatch(urlsplit(address).hostname or ""):
        raise ValueError(address)
    return address


def _is_public(address: ipaddress.IPv4Address | ipaddress.IPv6Address) -> bool:
    """Whether one machine of the internet has this address: is_global alone holds groups to be one.

    What carries an IPv4 address (mapped, or through NAT64) is judged by that one. Those of 6to4 (RFC 7526)
    and of sites are out of use, and may lead inside.
    """
    if isinstance(address, ipaddress.IPv4Address):
        return address.is_global and not address.is_multicast and address not in _RELAYS
    if address in _MAPPED or address in _NAT64:
        return _is_public(ipaddress.IPv4Address(int(address) & 0xFFFFFFFF))
    return address.is_global and address in _UNICAST and address.sixtofour is None


def _resolve(host: str, port: int) -> list[str]:
    return [str(found[4][0]) for found in socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)]


def _refused(address: str) -> PlatformError:
    return PlatformError(Fault.at("lti_address_refused", address=address.partition("?")[0][:200]))
