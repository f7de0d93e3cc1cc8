"""Links in the documentation lead somewhere, and every call of the API is listed."""

import re
from functools import cache
from pathlib import Path

from bench import report
from tests.architecture.sources import ROOT, shown, tracked
from tests.document import DOCUMENT

LINK = re.compile(r"(?<!\\)\[[^\]\[]*\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")
HEADING = re.compile(r"^#+\s+(.*?)\s*#*$", re.MULTILINE)
CODE = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)


@cache
def anchors(page: Path) -> set[str]:
    """Anchors of a page's headings, as GitHub makes them."""
    found: set[str] = set()
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    for heading in HEADING.findall(text):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
        slug = re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")
        number, unique = 0, slug
        while unique in found:
            number += 1
            unique = f"{slug}-{number}"
        found.add(unique)
    return found


def test_a_measurement_leaves_the_other_sections_of_its_page(tmp_path: Path) -> None:
    """Whatever stands between sections would be lost when `make bench` next writes the page."""
    text = report.PAGE.read_text(encoding="utf-8")
    page = tmp_path / "performance.md"
    page.write_text(text, encoding="utf-8")
    section = re.search(r"<!-- bench:forward -->.*<!-- /bench:forward -->", text, re.DOTALL)
    assert section is not None
    report.write("forward", section.group(), page)
    assert page.read_text(encoding="utf-8") == text


def test_links_lead_somewhere() -> None:
    assert not [
        f"{shown(page)}: {target}"
        for page in tracked()
        if page.suffix == ".md"
        for target in LINK.findall(CODE.sub("", page.read_text(encoding="utf-8")))
        if is_broken(page, target)
    ]


def is_broken(page: Path, target: str) -> bool:
    """Whether a link of a page leads to no file, or to no heading of it."""
    if re.match(r"[a-z]+:", target):
        return False
    name, _, anchor = target.partition("#")
    linked = (page.parent / name).resolve() if name else page
    return not linked.exists() or bool(anchor and linked.suffix == ".md" and anchor not in anchors(linked))


def test_files_that_pages_name_are_there() -> None:
    names = {path.name for path in tracked()}
    assert not [
        f"{shown(page)}: {file}"
        for page in tracked()
        if page.suffix == ".md" and page.name != "CHANGELOG.md"
        for file in re.findall(r"`(?:[\w/-]+/)?([\w-]+\.(?:py|js|ftl))`", page.read_text(encoding="utf-8"))
        if file not in names
    ]


def test_every_call_is_listed() -> None:
    """By its path, or by its last step in the row of its group (`/scm/…`)."""
    rows = (ROOT / "docs" / "api.md").read_text(encoding="utf-8").splitlines()
    missing = []
    for path in DOCUMENT["paths"]:
        call = path.removeprefix("/api/v1")
        group, _, step = call.rpartition("/")
        if not any(call in row or (f"{group}/…" in row and f"`{step}`" in row) for row in rows):
            missing.append(call)
    assert not missing
