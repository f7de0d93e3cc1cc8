"""Keys of programs and limits by cost; both are off until they are set."""

from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from framewise import Client, ProblemError
from service.cli.commands import main
from service.http.api_keys import KeyFile, KeyScope
from service.settings import Settings
from tests.live_service import running

pytestmark = pytest.mark.usefixtures("one_minute")

TABLE = {"convention": "standard", "rows": [{"alpha": 0, "a": 1, "d": 0, "theta": "q1"}]}
FORWARD = {"table": TABLE, "joints": [0], "parts": ["transform"]}


@pytest.fixture
def key_file(tmp_path: Path) -> Path:
    return tmp_path / "keys.json"


@pytest.fixture
def keyed(key_file: Path) -> Iterator[tuple[str, KeyFile]]:
    keys = KeyFile(key_file)
    with running(Settings(api_keys=key_file)) as url:
        yield url, keys


def test_without_any_key_everything_stays_open(keyed: tuple[str, KeyFile]) -> None:
    url, _ = keyed
    assert httpx.post(f"{url}/api/v1/forward-kinematics", json=FORWARD, timeout=120).status_code == 200


def test_with_a_key_programs_need_one_and_pages_do_not(keyed: tuple[str, KeyFile]) -> None:
    url, keys = keyed
    _, text = keys.add((KeyScope.COMPUTE,))
    refused = httpx.post(f"{url}/api/v1/forward-kinematics", json=FORWARD, timeout=120)
    assert refused.status_code == 401
    assert refused.json()["code"] == "api_key_missing"
    assert refused.headers["www-authenticate"] == "Bearer"
    own_page = httpx.post(
        f"{url}/api/v1/forward-kinematics",
        json=FORWARD,
        headers={"Sec-Fetch-Site": "same-origin"},
        timeout=120,
    )
    assert own_page.status_code == 200
    with Client(url, api_key=text) as client:
        assert client.forward_kinematics(TABLE, [0])["transform"]
        with pytest.raises(ProblemError) as other:
            client.grade(TABLE, TABLE)
        assert (other.value.status, other.value.code) == (403, "api_key_scope")
    with Client(url, api_key=text[:-1] + "~") as stranger, pytest.raises(ProblemError) as unknown:
        stranger.forward_kinematics(TABLE, [0])
    assert (unknown.value.status, unknown.value.code) == (401, "api_key_invalid")


def test_keys_are_revoked_and_expire(keyed: tuple[str, KeyFile]) -> None:
    url, keys = keyed
    key, text = keys.add(tuple(KeyScope))
    _, old = keys.add(tuple(KeyScope), expires="2020-01-01T00:00:00+00:00")
    with Client(url, api_key=text) as client, Client(url, api_key=old) as late:
        assert client.grade(TABLE, TABLE)["correct"]
        with pytest.raises(ProblemError):
            late.grade(TABLE, TABLE)
        assert keys.revoke(key.id)
        with pytest.raises(ProblemError):
            client.grade(TABLE, TABLE)


def test_no_key_stands_in_its_file(key_file: Path) -> None:
    _, text = KeyFile(key_file).add((KeyScope.READ,))
    assert text[10:] not in key_file.read_text()
    assert key_file.stat().st_mode & 0o077 == 0


def test_a_limit_counts_cost_and_says_when_to_come_back() -> None:
    with running(Settings(cost_per_minute=30)) as url, httpx.Client(base_url=url, timeout=120) as client:
        first = client.post("/api/v1/grade", json={"reference": TABLE, "submission": TABLE})
        assert first.status_code == 200
        assert first.headers["ratelimit-limit"] == "30"
        left = int(first.headers["ratelimit-remaining"])
        assert left == 25
        second = client.post("/api/v1/forward-kinematics", json=FORWARD)
        assert int(second.headers["ratelimit-remaining"]) == 24
        answers = [client.post("/api/v1/symbolic", json={"table": TABLE}) for _ in range(2)]
        assert [answer.status_code for answer in answers] == [200, 429]
        refused = answers[1]
        assert refused.json()["code"] == "rate_exceeded"
        assert 1 <= int(refused.headers["retry-after"]) <= 120
        assert client.get("/").status_code == 200  # pages are not counted


@pytest.mark.parametrize(
    ("first", "second", "left"),
    [
        ("2001:db8::1", "2001:db8::ffff:ffff:ffff:ffff", 8),
        ("2001:db8::1", "[2001:db8::2]:443", 8),
        ("2001:db8::1", "2001:db8:0:1::1", 9),
        ("192.0.2.1", "::ffff:192.0.2.1", 8),
        ("::ffff:192.0.2.1", "::ffff:192.0.2.2", 9),
        ("192.0.2.1", "192.0.2.2", 9),
        ("fe80::1%eth0", "fe80::2%eth0", 8),
        ("a:b", "a:c", 9),
    ],
)
def test_whoever_has_a_subnet_is_one_caller(first: str, second: str, left: int) -> None:
    """Each of the 2^64 addresses of an IPv6 customer had a limit of its own."""
    with running(Settings(cost_per_minute=10)) as url, httpx.Client(base_url=url, timeout=120) as client:
        for address in (first, second):
            headers = {"X-Forwarded-For": address}
            answer = client.post("/api/v1/forward-kinematics", json=FORWARD, headers=headers)
        assert answer.headers["ratelimit-remaining"] == str(left)


def test_a_key_has_a_limit_of_its_own(key_file: Path) -> None:
    keys = KeyFile(key_file)
    _, small = keys.add(tuple(KeyScope), cost_per_minute=5)
    _, large = keys.add(tuple(KeyScope))
    with running(Settings(api_keys=key_file)) as url:
        with Client(url, api_key=small) as client:
            assert client.grade(TABLE, TABLE)["correct"]
            with pytest.raises(ProblemError) as refused:
                client.grade(TABLE, TABLE)
            assert refused.value.status == 429
            assert refused.value.retry_after
        with Client(url, api_key=large) as client:
            for _ in range(3):
                assert client.grade(TABLE, TABLE)["correct"]


def test_the_command(
    key_file: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert main(["keys", "list"]) == 2
    assert "setting_missing" in capsys.readouterr().err
    monkeypatch.setenv("FRAMEWISE_API_KEYS", str(key_file))
    assert main(["keys", "add", "--scope", "grade", "--note", "CI", "--days", "30"]) == 0
    text = capsys.readouterr().out.strip()
    (key,) = KeyFile(key_file).all()
    assert KeyFile(key_file).find(text) == key
    assert main(["keys", "revoke", key.id]) == 0
    assert main(["keys", "revoke", "fwk_nobody"]) == 2
    capsys.readouterr()
    assert main(["keys", "list"]) == 0
    assert "revoked" in capsys.readouterr().out


def test_a_prefix_opens_no_way_around_keys_and_limits(key_file: Path) -> None:
    KeyFile(key_file).add(tuple(KeyScope))
    with running(Settings(api_keys=key_file, prefix="/dh")) as url:
        for path in ("/dh/api/v1/forward-kinematics", "/api/v1/forward-kinematics"):
            assert httpx.post(f"{url}{path}", json=FORWARD, timeout=120).status_code == 401
    with running(Settings(cost_per_minute=100, prefix="/dh")) as url:
        answer = httpx.post(f"{url}/dh/api/v1/forward-kinematics", json=FORWARD, timeout=120)
        assert answer.headers["ratelimit-remaining"] == "99"


def test_many_submissions_cost_as_much_as_each_by_itself() -> None:
    rows = [{"alpha": 0, "a": 1.0 + i / 7, "d": 0, "theta": f"q{i}"} for i in range(1, 7)]
    table = {"convention": "standard", "rows": rows}
    with running(Settings(cost_per_minute=10_000)) as url, httpx.Client(base_url=url, timeout=120) as client:
        body = {"reference": table, "submissions": [table] * 100}
        many = client.post("/api/v1/grade", json=body)
        assert many.status_code == 200
        assert 10_000 - int(many.headers["ratelimit-remaining"]) >= 5 * 50
        left = int(many.headers["ratelimit-remaining"])
        pieces = many.request.content
        headers = {"Content-Type": "application/json"}
        unsaid = client.post("/api/v1/grade", content=iter([pieces[:9000], pieces[9000:]]), headers=headers)
        assert unsaid.status_code == 200
        assert left - int(unsaid.headers["ratelimit-remaining"]) == 10_000 - left


def test_a_body_that_says_no_length_is_refused_where_the_limit_is_reached() -> None:
    with running(Settings(cost_per_minute=50)) as url, httpx.Client(base_url=url, timeout=120) as client:
        pieces = iter([b'{"reference": "', *([b"x" * 4096] * 8), b'"}'])
        headers = {"Content-Type": "application/json"}
        refused = client.post("/api/v1/grade", content=pieces, headers=headers)
        assert refused.status_code == 429
        assert refused.headers["retry-after"]
        assert refused.headers.get_list("ratelimit-limit") == ["50"]


def test_a_page_of_another_origin_can_read_what_is_left() -> None:
    origin = {"Origin": "https://course.example"}
    settings = Settings(cost_per_minute=5, cors_origins=("https://course.example",))
    with running(settings) as url, httpx.Client(base_url=url, headers=origin, timeout=120) as client:
        asked = {"Access-Control-Request-Method": "POST", "Access-Control-Request-Headers": "content-type"}
        answers = [
            client.post("/api/v1/grade", json={"reference": TABLE, "submission": TABLE}) for _ in range(2)
        ]
        assert [answer.status_code for answer in answers] == [200, 429]
        assert client.options("/api/v1/grade", headers=asked).status_code == 200
        for answer in answers:
            assert answer.headers["access-control-allow-origin"] == "https://course.example"
            assert "RateLimit-Remaining" in answer.headers["access-control-expose-headers"]
        assert {"retry-after", "ratelimit-limit", "ratelimit-remaining", "ratelimit-reset"} <= set(
            answers[1].headers
        )


def test_a_key_file_that_is_gone_lets_nobody_in(keyed: tuple[str, KeyFile], key_file: Path) -> None:
    """Everybody was let in, as if there had never been a key."""
    url, keys = keyed
    _, text = keys.add(tuple(KeyScope))
    headers = {"X-API-Key": text}
    for gone, status in ((False, 200), (True, 503)):
        if gone:
            key_file.unlink()
        answer = httpx.post(f"{url}/api/v1/forward-kinematics", json=FORWARD, headers=headers, timeout=120)
        assert answer.status_code == status
    assert answer.json()["code"] == "key_file_unreadable"


def test_a_key_file_that_cannot_be_read_lets_nobody_in(tmp_path: Path) -> None:
    """Such as a folder: it was answered with 500."""
    with running(Settings(api_keys=tmp_path)) as url:
        refused = httpx.post(f"{url}/api/v1/forward-kinematics", json=FORWARD, timeout=120)
    assert refused.status_code == 503
    assert refused.json()["code"] == "key_file_unreadable"


def test_a_key_file_that_cannot_be_understood_lets_nobody_in(key_file: Path) -> None:
    key_file.write_text("{")
    with running(Settings(api_keys=key_file)) as url:
        refused = httpx.post(f"{url}/api/v1/forward-kinematics", json=FORWARD, timeout=120)
        assert refused.status_code == 503
        assert refused.json()["code"] == "key_file_unreadable"
        key_file.unlink()
        assert httpx.post(f"{url}/api/v1/forward-kinematics", json=FORWARD, timeout=120).status_code == 200
