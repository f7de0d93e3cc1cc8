"""How the form's files travel: policy, languages, versions, compression, prefixes, no cookies."""

import gzip
import re
from pathlib import Path
from typing import Any
from urllib.parse import quote_plus, urljoin

import httpx
import pytest

from service.messages import sentence
from service.settings import Settings
from service.web import shell
from service.web.assets import Assets
from tests.live_service import running
from tests.web.conftest import LANGUAGES

ADDRESS = re.compile(r'(?:href|src|action)="([^"]+)"')


def test_every_language_of_the_messages_has_a_name(client: httpx.Client) -> None:
    names = {sentence(language, "language-name") for language in LANGUAGES}
    assert len(names) == len(LANGUAGES)
    page = client.get("/").text
    assert all(f">{name}</a>" in page for name in names)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_page_speaks_the_language_that_is_asked_for(client: httpx.Client, language: str) -> None:
    by_address = client.get("/", params={"lang": language}, headers={"Accept-Language": "xx"})
    by_browser = client.get("/", headers={"Accept-Language": f"{language}-XX,en;q=0.5"})
    for answer in (by_address, by_browser):
        assert answer.status_code == 200
        assert f'<html lang="{language}"' in answer.text
        assert answer.headers["content-language"] == language
        assert "${" not in answer.text
    assert "Accept-Language" in by_browser.headers["vary"]


def test_links_to_other_languages_keep_the_rest_of_the_address(client: httpx.Client) -> None:
    page = client.get("/exercises/puma560", params={"seed": 'a&b"', "lang": "en"}).text
    assert 'href="?seed=a%26b%22&amp;lang=ro" lang="ro"' in page
    assert page.count("aria-current") == 1


def test_an_unknown_language_is_the_browsers(client: httpx.Client) -> None:
    answer = client.get("/", params={"lang": '"><script>'}, headers={"Accept-Language": "ro"})
    assert '<html lang="ro"' in answer.text
    assert "<script>" not in answer.text


@pytest.mark.parametrize("path", ["/", "/exercises/puma560", "/playground", "/trainer/puma560"])
def test_pages_allow_this_origin_only_and_set_no_cookie(client: httpx.Client, path: str) -> None:
    answer = client.get(path)
    assert answer.status_code == 200
    policy = dict(part.strip().split(" ", 1) for part in answer.headers["content-security-policy"].split(";"))
    assert policy["default-src"] == "'none'"
    assert policy["script-src"] == "'self'"
    assert policy["style-src"] == "'self'"
    assert policy["connect-src"] == "'self'"
    assert policy["base-uri"] == "'none'"
    assert policy["frame-ancestors"] == "*"
    assert "unsafe" not in answer.headers["content-security-policy"]
    assert "set-cookie" not in answer.headers
    assert answer.headers["x-content-type-options"] == "nosniff"
    assert answer.headers["referrer-policy"] == "same-origin"
    assert not re.search(r"<style|style=|<script(?![^>]*src=)|\son\w+=", answer.text)
    assert all(not address.startswith(("http", "//")) for address in ADDRESS.findall(answer.text))


def test_frames_are_refused_where_the_settings_say_so() -> None:
    with running(Settings(frame_ancestors=("'self'", "https://lms.example.edu"))) as origin:
        policy = httpx.get(origin + "/", timeout=120).headers["content-security-policy"]
    assert policy.endswith("frame-ancestors 'self' https://lms.example.edu")


@pytest.mark.parametrize("path", ["/exercises/nowhere", "/trainer/nowhere"])
def test_a_page_that_does_not_exist_says_so_in_the_readers_language(client: httpx.Client, path: str) -> None:
    answer = client.get(path, headers={"Accept-Language": "fr"})
    assert answer.status_code == 404
    assert "Introuvable" in answer.text
    assert answer.headers["content-type"].startswith("text/html")


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("/exercises", "/"),
        ("/exercises/", "/"),
        ("/exercises/puma560/?seed=a%26b&lang=pt", "/exercises/puma560"),
        ("/lesson/", "/lesson"),
        ("/nowhere/%C3%A9/", "/nowhere/%C3%A9"),
    ],
)
@pytest.mark.parametrize("prefix", ["", "/a/b"])
def test_a_slash_too_many_is_taken_off(prefix: str, typed: str, meant: str) -> None:
    with (
        running(Settings(prefix=prefix)) as origin,
        httpx.Client(follow_redirects=True, timeout=120) as browser,
    ):
        answer = browser.get(origin + prefix + typed, headers={"Accept": "text/html"})
    assert str(answer.url).partition("?")[0] == origin + prefix + meant
    assert answer.url.query.decode() == typed.partition("?")[2]
    assert answer.status_code == (404 if "nowhere" in typed else 200)
    assert {step.status_code for step in answer.history} == {308}
    assert not any(":" in step.headers["location"] for step in answer.history)


@pytest.mark.parametrize("path", ["/exercises/puma560//", "/api/v1/exercises/"])
def test_other_addresses_are_not_guessed(client: httpx.Client, path: str) -> None:
    assert client.get(path, headers={"Accept": "text/html"}).status_code == 404


def test_every_address_of_every_page_leads_somewhere(client: httpx.Client) -> None:
    seen = set()
    for path in ("/", "/exercises/puma560", "/playground", "/trainer/puma560"):
        for address in ADDRESS.findall(client.get(path).text):
            target = urljoin(path, address.replace("&amp;", "&"))
            if target not in seen and not target.startswith(path + "#"):
                seen.add(target)
                assert client.get(target).status_code == 200, (path, address)
    assert len(seen) > 15


def test_files_are_kept_for_ever_under_the_version_that_holds_them(client: httpx.Client) -> None:
    page = client.get("/").text
    current = re.search(r'data-assets="\./(static/[0-9a-f]+)"', page)
    assert current
    kept = client.get(f"/{current[1]}/css/base.css")
    assert "immutable" in kept.headers["cache-control"]
    assert kept.headers["content-type"].startswith("text/css")
    other = client.get("/static/0123456789ab/css/base.css")
    assert other.status_code == 200
    assert other.headers["cache-control"] == "no-cache"
    again = client.get("/static/0123456789ab/css/base.css", headers={"If-None-Match": other.headers["etag"]})
    assert again.status_code == 304
    assert again.content == b""


@pytest.mark.parametrize(
    ("accepted", "encoding"),
    [("gzip, br", "br"), ("gzip", "gzip"), ("br;q=0, gzip", "gzip"), ("identity", None), ("", None)],
)
def test_files_are_sent_in_the_smallest_encoding_that_is_accepted(
    client: httpx.Client, accepted: str, encoding: str | None
) -> None:
    with client.stream(
        "GET", "/static/x/vendor/fluent/bundle.js", headers={"Accept-Encoding": accepted}
    ) as answer:
        sent = b"".join(answer.iter_raw())
    assert answer.headers.get("content-encoding") == encoding
    assert "Accept-Encoding" in answer.headers["vary"]
    plain = client.get("/static/x/vendor/fluent/bundle.js", headers={"Accept-Encoding": "identity"}).content
    if encoding == "gzip":
        assert gzip.decompress(sent) == plain
    elif encoding is None:
        assert sent == plain
    else:
        assert len(sent) < len(gzip.compress(plain))


TEXTS = {
    "/": "Accept-Language",
    "/locales/uk.ftl?files=form": None,
    "/api/v1/exercises": "Accept-Language",
    "/api/v1/exercises/puma560": "Accept-Language",
    "/api/v1/exercises/puma560/figure.svg": "Accept-Language",
    "/api/v1/robots/puma560": "Accept-Language",
}


@pytest.mark.parametrize("path", TEXTS)
def test_text_is_compressed_and_not_sent_twice(client: httpx.Client, path: str) -> None:
    plain = client.get(path, headers={"Accept-Encoding": "identity"})
    assert "content-encoding" not in plain.headers
    wanted = {"Accept-Encoding", *filter(None, [TEXTS[path]])}
    for accepted in ("gzip, deflate, br, zstd", "br, *;q=0.5"):
        with client.stream("GET", path, headers={"Accept-Encoding": accepted}) as packed:
            sent = b"".join(packed.iter_raw())
        assert packed.headers["content-encoding"] == "gzip"
        assert gzip.decompress(sent) == plain.content
        assert len(sent) < 0.6 * len(plain.content)
        for answer in (plain, packed):
            assert wanted <= set(answer.headers["vary"].split(", "))
            assert answer.headers["etag"] == plain.headers["etag"]
            assert answer.headers["etag"].startswith("W/"), "two forms, one validator: a weak one"
    for held in (plain.headers["etag"], f'"other", {plain.headers["etag"]}', "*"):
        again = client.get(path, headers={"If-None-Match": held})
        assert (again.status_code, again.content) == (304, b"")
        assert wanted <= set(again.headers["vary"].split(", "))
        assert again.headers["cache-control"] == plain.headers["cache-control"]
    for refused in ("gzip;q=0", "identity;q=1, gzip;q=0, *;q=0.1"):
        answer = client.get(path, headers={"Accept-Encoding": refused})
        assert "content-encoding" not in answer.headers


@pytest.mark.parametrize(
    "name",
    ["../pyproject.toml", "..%2fpyproject.toml", "%2e%2e/%2e%2e/etc/passwd", "css/../../README.md",
     "css", "", "vendor/.complete", "/etc/passwd", "css/base.css%00"],
)  # fmt: skip
def test_only_what_is_in_the_folder_is_served(web: str, name: str) -> None:
    answer = httpx.get(f"{web}/static/x/{name}", timeout=120)
    assert answer.status_code == 404


def test_assets_follow_the_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.web.assets.SCAN_INTERVAL", 0.0)
    (tmp_path / "a.js").write_text("1")
    assets = Assets(tmp_path)
    first = assets.version
    one = assets.get("a.js", "gzip")
    assert one is not None
    (tmp_path / "a.js").write_text("22")
    assert assets.version != first
    two = assets.get("a.js", "gzip")
    assert two is not None
    assert gzip.decompress(two.body) == b"22"
    assert two.etag != one.etag
    (tmp_path / "a.js").unlink()
    assert assets.get("a.js", "gzip") is None


def test_messages_are_served_as_the_api_speaks_them(client: httpx.Client) -> None:
    whole = client.get("/locales/ro.ftl").text
    form = client.get("/locales/ro.ftl", params={"files": "form"}).text
    assert "form-skip = Sari la conținut" in form
    assert "error-" not in form
    assert form in whole
    assert "error-" in whole
    assert client.get("/locales/xx.ftl").status_code == 404
    assert client.get("/locales/..%2Fen.ftl").status_code == 404


@pytest.mark.parametrize("prefix", ["", "/dh", "/a/b"])
def test_pages_name_no_prefix_and_need_none(prefix: str) -> None:
    with running(Settings(prefix=prefix)) as origin:
        page = httpx.get(f"{origin}{prefix}/", timeout=120)
        assert page.status_code == 200
        assert prefix == "" or prefix not in page.text
        style = ADDRESS.findall(page.text)[1]
        assert httpx.get(urljoin(f"{origin}{prefix}/", style), timeout=120).status_code == 200


def test_a_page_names_every_module_that_its_script_imports(client: httpx.Client) -> None:
    page = client.get("/exercises/puma560").text
    named = re.findall(r'rel="modulepreload" href="\.\./static/[0-9a-f]+/([^"]+)"', page)
    assert len(named) == len(set(named)) > 20
    assert {"js/api.js", "js/editor/dh-table-editor.js", "vendor/fluent/bundle.js"} <= set(named)
    heavy = {name for name in named if "three" in name or "katex" in name}
    assert heavy == set(), "what is heavy is loaded after the first paint"


def test_imports_are_followed_as_the_browser_follows_them(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "page.js").write_text(
        'import {\n  one,\n  two as three,\n} from "../b.js";\nimport "./c.js";\n'
        'export { x } from "./d.js";\n'
        'export const y = f("./none.js");\nconst later = () => import("./later.js");\n'
    )
    (tmp_path / "b.js").write_text('import * as page from "./a/page.js";\n')
    for name in ("c", "d", "later"):
        (tmp_path / "a" / f"{name}.js").write_text("")
    assert Assets(tmp_path).imports("a/page.js") == ("b.js", "a/c.js", "a/d.js")


def test_a_page_is_made_once_for_all_who_differ_in_their_values(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[str] = []
    written = shell._written

    def counted(page: shell.Page, *rest: Any) -> str:
        made.append(page.name)
        return written(page, *rest)

    monkeypatch.setattr(shell, "_written", counted)
    shell._shared.cache_clear()
    seeds = ['"><b>', "s1", "s2"]
    pages = [client.get("/exercises/puma560", params={"seed": seed, "lang": "en"}).text for seed in seeds]
    assert made == ["exercise"]
    for seed, page in zip(seeds, pages, strict=True):
        told = quote_plus(seed)
        assert f"?seed={told}&amp;lang=fr" in page
        assert re.search(rf'src="[^"]+\.svg\?lang=en&amp;seed={re.escape(told)}"', page)
        assert "\0" not in page
        assert "<b>" not in page
    figures = {re.search(r"figures/(\w+)\.svg", page)[1] for page in pages}  # type: ignore[index]
    assert len(figures) == len(seeds)
