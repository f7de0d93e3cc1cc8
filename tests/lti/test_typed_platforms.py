"""A platform is registered by hand: a slip of the pen is told where it is made, not at a launch."""

from collections.abc import Mapping
from pathlib import Path

import httpx
import pytest

from courses.model import Platform, PlatformStatus
from courses.people.platforms import add_platform, deployments_of, platforms
from courses.storage.database import Store, open_store
from service.cli.commands import main
from service.course_resources import now
from service.lti.fetching import http_address
from service.lti.launch_errors import LoginError
from service.lti.registration import ToolRegistration, register

ROOT = "https://lms.example.edu"
WHOLE: Mapping[str, str] = {
    "issuer": ROOT,
    "client_id": "client-7",
    "--authorization-endpoint": f"{ROOT}/auth?tenant=1",
    "--token-endpoint": f"{ROOT}:8443/token",
    "--jwks-uri": "http://[::1]:8080/jwks",
    "--deployment": "1",
    "--origin": "https://pages.example.edu:443/",
    "--token-audience": "audience",
}
"""What is typed, by the name under which it is refused."""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("FRAMEWISE_STORAGE", "on")
    monkeypatch.setenv("FRAMEWISE_DATA_FOLDER", str(tmp_path / "data"))
    return tmp_path / "data"


def added(typed: Mapping[str, str]) -> int:
    options = [word for name, value in typed.items() for word in (name, value) if name.startswith("--")]
    return main(["lti", "add", typed["issuer"], typed["client_id"], *options])


def test_what_is_typed_as_it_should_be_is_stored(folder: Path) -> None:
    assert added(WHOLE) == 0
    store = open_store("", folder)
    (known,) = platforms(store)
    assert (known.issuer, known.client_id, known.token_audience) == (ROOT, "client-7", "audience")
    assert known.authorization_endpoint == f"{ROOT}/auth?tenant=1"
    assert known.origins == ("https://pages.example.edu",)
    assert deployments_of(store, known.id) == ("1",)
    store.close()


@pytest.mark.parametrize(
    ("address", "trusted", "is_told"),
    [
        ("https://lms.example.edu/keys", "", False),
        ("https://8.8.8.8/keys", "", False),
        ("http://lms.example.edu/keys", "", True),
        ("http://lms.example.edu/keys", "http://lms.example.edu", False),
        ("https://127.0.0.1/keys", "", True),
        ("https://localhost:8443/keys", "", True),
        ("https://localhost:8443/keys", "https://localhost:8443", False),
    ],
)
@pytest.mark.parametrize("name", ["--token-endpoint", "--jwks-uri"])
def test_an_address_that_the_service_will_never_call_is_told(
    address: str,
    trusted: str,
    is_told: bool,
    name: str,
    folder: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Whoever registered it learned that at the first launch."""
    monkeypatch.setenv("FRAMEWISE_LTI_TRUSTED_ORIGINS", trusted)
    whole = {**WHOLE, "--token-endpoint": f"{ROOT}/token", "--jwks-uri": f"{ROOT}/jwks"}
    assert added({**whole, name: address}) == 0
    told = capsys.readouterr()
    assert told.out == "1\n"
    assert told.err.count("The service will not call") == is_told
    assert (f"will not call {address}:" in told.err) == is_told


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("issuer", "nonsense"),
        ("client_id", ""),
        ("client_id", "a\nb"),
        ("--authorization-endpoint", "nonsense"),
        ("--authorization-endpoint", "lms.example.edu/auth"),
        ("--token-endpoint", ""),
        ("--token-endpoint", "https:///token"),
        ("--jwks-uri", "ftp://lms.example.edu/jwks"),
        ("--jwks-uri", f"{ROOT}/jw ks"),
        ("--jwks-uri", f"{ROOT}:port/jwks"),
        ("--jwks-uri", "https://a;b/jwks"),
        ("--deployment", ""),
        ("--token-audience", " "),
        ("--origin", "foo;bar"),
        ("--origin", "https://foo;bar"),
        ("--origin", f"{ROOT}/pages"),
    ],
)
def test_a_slip_is_told_with_the_name_of_the_option(
    name: str, value: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        added({**WHOLE, name: value})
    assert ended.value.code == 2
    assert f"argument {name}: " in capsys.readouterr().err
    assert not folder.exists()


def test_a_deployment_of_no_platform_is_refused(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert added(WHOLE) == 0
    assert main(["lti", "deployment", "99", "2"]) == 2
    assert "There is no such platform. [record_unknown]" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["lti", "deployment", "1", ""])
    assert main(["lti", "deployment", "1", "2"]) == 0
    assert main(["lti", "deployment", "1", "2"]) == 0
    store = open_store("", folder)
    assert deployments_of(store, 1) == ("1", "2")
    store.close()


@pytest.mark.parametrize("more", [{}, {"lti_storage_target": "_parent"}])
def test_a_platform_that_was_stored_without_an_address_is_told_at_the_login(
    more: Mapping[str, str], service: str, store: Store
) -> None:
    stored = Platform(
        issuer="nonsense",
        client_id="c",
        authorization_endpoint="nonsense",
        token_endpoint="",
        jwks_uri="",
        status=PlatformStatus.ACTIVE,
    )
    add_platform(store, stored, (), now())
    asked = {"iss": "nonsense", "login_hint": "u", "target_link_uri": f"{service}/", **more}
    answer = httpx.get(f"{service}/lti/login", params=asked, timeout=120, trust_env=False)
    assert (answer.status_code, answer.json()["code"]) == (400, "lti_configuration_invalid")


@pytest.mark.parametrize("text", ["nonsense", "https://lms.example.edu/a b", "https://a;b/", " https://a "])
def test_a_platform_that_registers_itself_names_addresses(text: str) -> None:
    class Configuration:
        def get_json(self, _: str) -> tuple[object, None]:
            names = ("issuer", "authorization_endpoint", "token_endpoint", "registration_endpoint")
            return {**dict.fromkeys(names, ROOT), "jwks_uri": text}, None

    tool = ToolRegistration(name="Framewise", description="", root="https://framewise.example.edu/")
    with pytest.raises(LoginError) as refused:
        register(Configuration(), ROOT, None, tool)  # type: ignore[arg-type]
    assert refused.value.faults[0].code == "lti_configuration_invalid"
    assert refused.value.faults[0].params["name"] == "jwks_uri"


def test_spaces_around_an_address_are_no_part_of_it() -> None:
    assert http_address(f" {ROOT}/jwks\n") == f"{ROOT}/jwks"
