"""Reports: a table for the terminal and a section of docs/performance.md."""

import datetime
import os
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from bench.machine import describe
from bench.measure import Outcome, Row, Skipped

PAGE = Path(__file__).resolve().parent.parent / "docs" / "performance.md"

HEADER = """\
# Performance

Which bars are met is listed first; each section says what was measured, and how. `make bench` measures beside
peers: a figure is a median of repetitions that take turns with the peer's, in the same process on one thread,
because a ratio travels between machines and seconds do not. `ratio` says how many times better than the peer
we are (0.5 is half as fast), `bar` the least that was promised. Peers live in an environment of their own;
the project depends on none of them. Measure on a quiet machine.
"""

COMMANDS = {
    "campaigns": "make campaign",
    "courses": "make measure-courses",
    "hostile": "make attacks",
    "load": "make mixed",
    "storage": "python -m tests.lti.storage_price",
    "university": "make university",
}
"""What measures the sections that no module of this package writes."""

COLUMNS = ("work", "ours", "peer", "theirs", "ratio", "bar", "met")


def quantity(value: float, unit: str) -> str:
    """A figure with its unit; seconds in the unit that suits them."""
    if unit != "s":
        return f"{value:,.4g} {unit}" if value < 1000 else f"{value:,.0f} {unit}"
    for name, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= size:
            return f"{value / size:.3g} {name}"
    return f"{value / 1e-9:.3g} ns"


def cells(row: Row) -> tuple[str, ...]:
    """One row of the report as text."""
    met = {True: "yes", False: "NO", None: "–"}[row.met]
    bar = "–" if row.bar is None else f"≥ {row.bar:g}"
    ours, theirs = quantity(row.ours, row.unit), quantity(row.theirs, row.unit)
    return row.work, ours, row.peer, theirs, f"{row.ratio:.3g}", bar, met


def terminal(outcomes: Sequence[Outcome]) -> str:
    """The rows in aligned columns."""
    lines = [COLUMNS, *(cells(row) for row in outcomes if isinstance(row, Row))]
    widths = [max(len(line[i]) for line in lines) for i in range(len(COLUMNS))]
    text = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)) for line in lines]
    text += [f"skipped: {skip.work}: {skip.reason}" for skip in outcomes if isinstance(skip, Skipped)]
    return "\n".join(line.rstrip() for line in text)


def section(name: str, title: str, about: str, outcomes: Sequence[Outcome]) -> str:
    """The module's section of the page, in Markdown between markers."""
    lines = [f"<!-- bench:{name} -->", f"## {title}", "", about.strip(), ""]
    lines += ["| " + " | ".join(COLUMNS) + " |", "|---|--:|---|--:|--:|--:|---|"]
    lines += ["| " + " | ".join(cells(row)) + " |" for row in outcomes if isinstance(row, Row)]
    skipped = [
        f"- not measured: {skip.work} ({skip.reason})" for skip in outcomes if isinstance(skip, Skipped)
    ]
    today = datetime.datetime.now(tz=datetime.UTC).date().isoformat()
    lines += ["", *skipped, *([""] if skipped else [])]
    lines += [f"{today}; {describe()}.", "", f"<!-- /bench:{name} -->"]
    return "\n".join(lines)


def overview(sections: Mapping[str, str]) -> str:
    """Which bars are met, section by section, and the rows of those that are not."""
    lines = ["| section | measured by | bars met | not met |", "|---|---|--:|--:|"]
    missed = []
    for name, text in sorted(sections.items()):
        title = text.partition("## ")[2].partition("\n")[0]
        anchor = re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")
        link = f"[{title}](#{anchor})"
        rows = [line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("| ")]
        yes, no = (sum(row[-1] == met for row in rows) for met in ("yes", "NO"))
        command = COMMANDS.get(name, f"make bench ONLY={name}")
        lines.append(f"| {link} | `{command}` | {yes or '–'} | {no or '–'} |")
        missed += [f"- {link}: {row[0]}: {row[1]}" for row in rows if row[-1] == "NO"]
    return "\n".join([*lines, *(["", "Not met:", "", *missed] if missed else [])])


def write(name: str, text: str, page: Path = PAGE) -> None:
    """Put a section into the page, in place of its older self; sections stand in alphabetical order."""
    sections = _sections(page.read_text(encoding="utf-8")) if page.exists() else {}
    sections[name] = text
    parts = [HEADER.strip(), overview(sections), *(sections[key] for key in sorted(sections))]
    body = "\n\n".join(parts) + "\n"
    page.parent.mkdir(exist_ok=True)
    fresh = page.with_suffix(f".{os.getpid()}")
    fresh.write_text(body, encoding="utf-8")
    fresh.replace(page)


def _sections(text: str) -> dict[str, str]:
    found: dict[str, list[str]] = {}
    name = None
    for line in text.splitlines():
        if line.startswith("<!-- bench:"):
            name = line.removeprefix("<!-- bench:").removesuffix(" -->")
            found[name] = []
        if name is not None:
            found[name].append(line)
        if line.startswith("<!-- /bench:"):
            name = None
    return {key: "\n".join(lines) for key, lines in found.items()}
