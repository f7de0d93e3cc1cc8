"""Launches that must not be believed: refused with 400 or 401 and a stable code, logged without secrets."""

import base64
import json
import logging
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import timedelta
from secrets import token_hex
from typing import Any
from urllib.parse import parse_qs

import jwt
import pytest
import sqlalchemy as sa
from cryptography.hazmat.primitives import serialization
from cryptography.hazmat.primitives.asymmetric import rsa

from courses.model import Platform, PlatformStatus
from courses.people.platforms import add_platform, remove_platform, set_status
from courses.storage.database import Store
from courses.storage.records import metadata
from service.course_resources import now
from service.lti.login import LOGIN, login_of, read_login, redirection
from tests.lti.classes import LEARNER, Browser, Lms
from tests.lti.key_server import KeyServer

LTI = "https://purl.imsglobal.org/spec/lti/claim/"
CLIENT, DEPLOYMENT = "forged-client", "d-1"
pytestmark = pytest.mark.parametrize("address", ["sqlite"], indirect=True)
"""What is refused comes to no database."""


@pytest.fixture(scope="module")
def keys() -> Iterator[KeyServer]:
    """A platform of which the test holds the keys."""
    with KeyServer() as server:
        yield server


@pytest.fixture(scope="module")
def settings(keys: KeyServer, address: str, lms: Lms, tmp_path_factory: pytest.TempPathFactory) -> Any:
    from service.settings import Settings

    trusted = (lms.root, keys.root)
    folder = tmp_path_factory.mktemp("forged")
    return Settings(storage="on", data_folder=folder, database_url=address, lti_trusted_origins=trusted)


@pytest.fixture(scope="module")
def platform(store: Store, keys: KeyServer) -> Platform:
    asked = Platform(
        issuer=keys.root,
        client_id=CLIENT,
        authorization_endpoint=f"{keys.root}/auth",
        token_endpoint=f"{keys.root}/token",
        jwks_uri=f"{keys.root}/jwks",
        status=PlatformStatus.ACTIVE,
    )
    return add_platform(store, asked, (DEPLOYMENT,), now())


class Forger(Browser):
    """Logs in honestly, and posts a message of the test's making."""

    def begin(self, keys: KeyServer, **changed: str) -> dict[str, str]:
        """State and nonce of a login."""
        asked = {"iss": keys.root, "login_hint": "eve", "client_id": CLIENT, **changed}
        asked = {"target_link_uri": f"{self.service}/lti/launch", **asked}
        answer = self._checked(self.client.post(f"{self.service}/lti/login", data=asked))
        if answer.status_code != 302:
            return {"status": str(answer.status_code), "code": answer.json()["code"]}
        query = answer.headers["location"].partition("?")[2]
        return dict(pair.split("=") for pair in query.split("&"))

    def claims(self, keys: KeyServer, begun: dict[str, str], **changed: Any) -> dict[str, Any]:
        at = int(time.time())
        told = {
            "iss": keys.root,
            "aud": CLIENT,
            "sub": "eve",
            "iat": at,
            "exp": at + 60,
            "nonce": begun["nonce"],
            f"{LTI}version": "1.3.0",
            f"{LTI}message_type": "LtiResourceLinkRequest",
            f"{LTI}deployment_id": DEPLOYMENT,
            f"{LTI}target_link_uri": f"{self.service}/lti/launch",
            f"{LTI}resource_link": {"id": "r"},
            f"{LTI}custom": {"exercise": "puma560"},
            f"{LTI}roles": [LEARNER],
            **changed,
        }
        return {name: value for name, value in told.items() if value is not ...}


@pytest.fixture
def forger(lms: Lms, service: str, platform: Platform) -> Iterator[Forger]:
    opened = Forger(lms, service)
    yield opened
    opened.client.close()


def signed(keys: KeyServer, claims: dict[str, Any], **header: Any) -> str:
    return jwt.encode(claims, keys.private, "RS256", headers={"kid": keys.kid, **header})


def test_an_honest_launch_is_believed(forger: Forger, keys: KeyServer) -> None:
    begun = forger.begin(keys)
    token = signed(keys, forger.claims(keys, begun, aud=[CLIENT, "another"], azp=CLIENT))
    assert forger.post({"id_token": token, "state": begun["state"]}).status_code == 303


def test_a_title_cut_off_within_an_emoji_is_taken(forger: Forger, keys: KeyServer) -> None:
    begun = forger.begin(keys)
    cut = {
        f"{LTI}context": {"id": "cut", "title": "Robots \ud83e"},
        f"{LTI}resource_link": {"id": "cut", "title": "\udd16 \U0001f916"},
        f"{LTI}custom": {"exercise": "puma560", "\ud800": "\ud800"},
        f"{LTI}launch_presentation": {"locale": "en\ud800", "return_url": "https://lms.example/\ud800"},
        "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint": {"scope": ["\ud800"], "lineitem": "\ud800"},
        "name": "Ann \ud83d",
    }
    token = signed(keys, forger.claims(keys, begun, **cut))
    answer = forger.post({"id_token": token, "state": begun["state"]})
    code = parse_qs(answer.headers["location"].partition("#")[2])["session"][0]
    forger.token = forger.api("POST", "session/open", {"code": code}).json()["token"]
    shown = forger.api("GET", "session").json()
    assert (shown["course"]["title"], shown["link"]["title"]) == ("Robots \ufffd", "\ufffd \U0001f916")


CLAIMS: list[tuple[str, Callable[[int], dict[str, Any]], str]] = [
    ("issuer", lambda _: {"iss": "https://elsewhere.example"}, "lti_claim_wrong"),
    ("audience", lambda _: {"aud": "another"}, "lti_claim_wrong"),
    ("no audience", lambda _: {"aud": []}, "lti_claim_wrong"),
    ("two audiences, no azp", lambda _: {"aud": [CLIENT, "another"]}, "lti_claim_missing"),
    ("azp of another", lambda _: {"azp": "another"}, "lti_claim_wrong"),
    ("expired", lambda at: {"exp": at - 61}, "lti_token_expired"),
    ("expiry is a word", lambda _: {"exp": "tomorrow"}, "lti_claim_missing"),
    ("expiry is infinite", lambda _: {"exp": 1e300}, "lti_claim_wrong"),
    ("from the future", lambda at: {"iat": at + 120, "exp": at + 600}, "lti_token_early"),
    ("old", lambda at: {"iat": at - 700, "exp": at + 600}, "lti_token_early"),
    ("nonce of another", lambda _: {"nonce": "another"}, "lti_claim_wrong"),
    ("no nonce", lambda _: {"nonce": ...}, "lti_claim_wrong"),
    ("version", lambda _: {f"{LTI}version": "1.1"}, "lti_claim_wrong"),
    ("message type", lambda _: {f"{LTI}message_type": "LtiSubmissionReviewRequest"}, "lti_claim_wrong"),
    ("unknown deployment", lambda _: {f"{LTI}deployment_id": "d-2"}, "lti_deployment_unknown"),
    ("no deployment", lambda _: {f"{LTI}deployment_id": ""}, "lti_claim_missing"),
    ("long deployment", lambda _: {f"{LTI}deployment_id": "d" * 256}, "lti_claim_missing"),
    ("another target", lambda _: {f"{LTI}target_link_uri": "https://x.example/"}, "lti_claim_wrong"),
    ("roles are a word", lambda _: {f"{LTI}roles": "Instructor"}, "lti_claim_missing"),
    ("no link", lambda _: {f"{LTI}resource_link": {}}, "lti_claim_missing"),
    ("subject is a number", lambda _: {"sub": 7}, "lti_claim_wrong"),
    ("half a pair in the subject", lambda _: {"sub": "x\ud800"}, "lti_claim_wrong"),
    ("half a pair in the deployment", lambda _: {f"{LTI}deployment_id": "\udc00d"}, "lti_claim_wrong"),
    ("half a pair in the course", lambda _: {f"{LTI}context": {"id": "c\ud83d"}}, "lti_claim_wrong"),
    ("half a pair in the link", lambda _: {f"{LTI}resource_link": {"id": "\ud83d"}}, "lti_claim_wrong"),
]


@pytest.mark.parametrize(("changed", "code"), [case[1:] for case in CLAIMS], ids=[case[0] for case in CLAIMS])
def test_a_message_with_a_wrong_claim_is_refused(
    forger: Forger, keys: KeyServer, changed: Callable[[int], dict[str, Any]], code: str
) -> None:
    begun = forger.begin(keys)
    token = signed(keys, forger.claims(keys, begun, **changed(int(time.time()))))
    refused(forger.post({"id_token": token, "state": begun["state"]}), {code})


def refused(answer: Any, codes: set[str]) -> None:
    assert answer.status_code in (400, 401), answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.json()["code"] in codes


def _unsigned(claims: dict[str, Any], **header: Any) -> str:
    parts = [json.dumps(part).encode() for part in ({"alg": "none", "typ": "JWT", **header}, claims)]
    return ".".join(base64.urlsafe_b64encode(part).rstrip(b"=").decode() for part in parts) + "."


def _by_public_key(keys: KeyServer, claims: dict[str, Any]) -> str:
    """HS256 with the public key as secret; PyJWT refuses to sign so, hence by hand."""
    import hashlib
    import hmac

    header = {"alg": "HS256", "typ": "JWT", "kid": keys.kid}
    parts = [base64.urlsafe_b64encode(json.dumps(part).encode()).rstrip(b"=") for part in (header, claims)]
    mac = hmac.new(keys.public.encode(), b".".join(parts), hashlib.sha256).digest()
    return b".".join([*parts, base64.urlsafe_b64encode(mac).rstrip(b"=")]).decode()


def _by_another(keys: KeyServer, claims: dict[str, Any], **header: Any) -> str:
    another = rsa.generate_private_key(public_exponent=65537, key_size=2048)
    pem = another.private_bytes(
        serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    return jwt.encode(claims, pem, "RS256", headers={"kid": keys.kid, **header})


TOKENS: list[tuple[str, Callable[[KeyServer, dict[str, Any]], str], str]] = [
    ("alg none", lambda keys, claims: _unsigned(claims, kid=keys.kid), "lti_token_algorithm"),
    ("HS256 with the public key", _by_public_key, "lti_token_algorithm"),
    ("another key", _by_another, "lti_token_signature"),
    ("jku", lambda keys, claims: _by_another(keys, claims, jku=f"{keys.root}/evil"), "lti_token_signature"),
    ("no kid", lambda keys, claims: signed(keys, claims, kid=""), "lti_token_key"),
    ("unknown kid", lambda keys, claims: signed(keys, claims, kid="another"), "lti_token_key"),
    ("no token", lambda *_: "nothing", "lti_token_malformed"),
    ("deep", lambda *_: ".".join(["W" * 50_000] * 3), "lti_token_malformed"),
    ("huge", lambda *_: "e" * 100_000, "lti_token_malformed"),
    ("1 MB", lambda *_: "e" * 1_000_000, "posted_form_too_large"),
]


@pytest.mark.parametrize(("forge", "code"), [case[1:] for case in TOKENS], ids=[case[0] for case in TOKENS])
def test_a_token_that_the_platform_did_not_sign_is_refused(
    forger: Forger, keys: KeyServer, forge: Callable[[KeyServer, dict[str, Any]], str], code: str, caplog: Any
) -> None:
    begun = forger.begin(keys)
    token = forge(keys, forger.claims(keys, begun))
    with caplog.at_level(logging.INFO):
        refused(forger.post({"id_token": token, "state": begun["state"]}), {code})
    assert keys.visited_elsewhere == 0
    written = caplog.text
    assert code in written
    assert begun["state"] not in written
    assert token not in written


def test_an_unknown_key_is_looked_for_once(
    forger: Forger, keys: KeyServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("service.lti.platform_keys.REFETCHED_AFTER", 3600.0)
    before = keys.fetched
    for _ in range(3):
        begun = forger.begin(keys)
        token = signed(keys, forger.claims(keys, begun), kid="unknown")
        refused(forger.post({"id_token": token, "state": begun["state"]}), {"lti_token_key"})
    assert keys.fetched - before <= 1


def test_a_state_works_once_and_in_its_browser_only(forger: Forger, keys: KeyServer, lms: Lms) -> None:
    begun = forger.begin(keys)
    form = {"id_token": signed(keys, forger.claims(keys, begun)), "state": begun["state"]}
    stranger = Forger(lms, forger.service)
    refused(stranger.post(form), {"lti_browser_unknown"})
    state = form["state"]
    for forged in ("", "made-up", ".", f"{state}0", state[1:], f"A{state[1:]}", state.partition(".")[0]):
        refused(forger.post({**form, "state": forged}), {"lti_state_unknown"})
    assert forger.post(form).status_code == 303
    refused(forger.post(form), {"lti_nonce_used"})
    stranger.client.close()


def test_logins_of_strangers_leave_nothing_in_the_database(
    forger: Forger, keys: KeyServer, store: Store
) -> None:
    def rows() -> dict[str, int]:
        with store.reading() as connection:
            tables = metadata.sorted_tables
            counts = [sa.select(sa.func.count()).select_from(table) for table in tables]
            return {
                table.name: connection.scalar(count) or 0 for table, count in zip(tables, counts, strict=True)
            }

    forger.begin(keys)
    before = rows()
    for n in range(20):
        assert "state" in forger.begin(keys, login_hint=f"{n:04}" * 1000, lti_message_hint="h" * 4000)
    assert rows() == before


def test_a_state_is_good_for_ten_minutes(keys: KeyServer, store: Store, platform: Platform) -> None:
    target = "https://tool.example/lti/launch"
    asked = {"iss": keys.root, "login_hint": "eve", "target_link_uri": target}
    begun = now()
    request = read_login(asked, "https://tool.example")
    state, _ = redirection(store, platform, request, "browser", target, begun)
    found = login_of(store, state, begun + LOGIN - timedelta(seconds=1))
    assert found is not None
    assert (found.platform_id, found.target, found.again) == (platform.id, target, asked)
    assert login_of(store, state, begun + LOGIN) is None


@pytest.mark.parametrize(("hint", "is_repeated"), [(100, True), (400, False), (2000, False)])
def test_a_request_is_not_repeated_where_the_address_would_be_long(
    store: Store, platform: Platform, hint: int, *, is_repeated: bool
) -> None:
    """IIS takes queries of 2 KiB, and the platform's hints stand in the address already."""
    target = "https://tool.example/lti/launch"
    hints = {"login_hint": token_hex(hint), "lti_message_hint": token_hex(hint)}
    request = read_login({"iss": "i", "target_link_uri": target, **hints}, "https://tool.example")
    state, address = redirection(store, platform, request, "browser", target, now())
    found = login_of(store, state, now())
    assert found is not None
    assert bool(found.again) == is_repeated
    assert len(address) < (2048 if is_repeated else 1000 + 4 * hint)


def test_a_nonce_works_once(forger: Forger, keys: KeyServer, store: Store, platform: Platform) -> None:
    from courses.people.secrets import remember_nonce
    from service.lti.launch import NONCE_LIFE

    begun = forger.begin(keys)
    assert remember_nonce(store, platform.id, begun["nonce"], now(), NONCE_LIFE)
    token = signed(keys, forger.claims(keys, begun))
    refused(forger.post({"id_token": token, "state": begun["state"]}), {"lti_nonce_used"})


@pytest.mark.parametrize(
    ("changed", "code"),
    [
        ({"iss": "https://nobody.example"}, "lti_platform_unknown"),
        ({"client_id": "nobody"}, "lti_client_unknown"),
        ({"iss": "https://nobody.example", "client_id": "nobody"}, "lti_platform_unknown"),
        ({"login_hint": ""}, "lti_parameter_missing"),
        ({"target_link_uri": "https://elsewhere.example/lti/launch"}, "lti_target_foreign"),
        ({"target_link_uri": "//elsewhere.example/"}, "lti_target_foreign"),
        ({"target_link_uri": "javascript:alert(1)"}, "lti_target_foreign"),
    ],
)
def test_a_login_that_cannot_be_meant_is_refused(
    forger: Forger, keys: KeyServer, changed: dict[str, str], code: str
) -> None:
    answer = forger.begin(keys, **changed)
    assert (answer["status"], answer["code"]) == ("400", code)


def test_a_platform_that_is_not_active_does_not_launch(
    forger: Forger, keys: KeyServer, store: Store, platform: Platform
) -> None:
    """Nor with a login of the ten minutes before it was switched off."""
    begun = forger.begin(keys)
    token = signed(keys, forger.claims(keys, begun))
    set_status(store, platform.id, PlatformStatus.PENDING)
    try:
        assert forger.begin(keys)["code"] == "lti_platform_inactive"
        answer = forger.post({"id_token": token, "state": begun["state"]})
        assert (answer.status_code, answer.json()["code"]) == (400, "lti_platform_inactive")
    finally:
        set_status(store, platform.id, PlatformStatus.ACTIVE)


def test_a_registration_that_is_not_active_makes_no_login_ambiguous(
    forger: Forger, keys: KeyServer, store: Store, platform: Platform
) -> None:
    """A platform need not say which client it means where only one of an issuer's can be meant."""
    twin = add_platform(store, replace(platform, id=0, client_id="twin"), (DEPLOYMENT,), now())
    try:
        assert forger.begin(keys, client_id="")["code"] == "lti_platform_ambiguous"
        set_status(store, twin.id, PlatformStatus.DISABLED)
        assert forger.begin(keys, client_id="")["client_id"] == CLIENT
        set_status(store, platform.id, PlatformStatus.PENDING)
        assert forger.begin(keys, client_id="")["code"] == "lti_platform_inactive"
    finally:
        set_status(store, platform.id, PlatformStatus.ACTIVE)
        remove_platform(store, twin.id)


def test_a_person_reads_a_page(forger: Forger, keys: KeyServer) -> None:
    begun = forger.begin(keys)
    forger.cookies = {}
    answer = forger.post({"id_token": "x", "state": begun["state"]}, Accept="text/html")
    assert answer.status_code == 401
    assert 'data-step="window"' in answer.text


def test_a_person_who_opens_the_address_of_launches_is_told_what_it_is_for(forger: Forger) -> None:
    """A bookmark of it, or an administrator's try, was answered with a problem document."""
    address = f"{forger.service}/lti/launch"
    page = forger.client.get(address, headers={"Accept": "text/html", "Accept-Language": "fr"})
    assert (page.status_code, page.headers["allow"]) == (405, "OPTIONS, POST")
    assert "Ouvrez l’exercice depuis votre cours" in page.text
    told = forger.client.get(address)
    assert (told.status_code, told.json()["code"]) == (405, "method_not_allowed")
