"""The bill of materials names everything that is locked, each with a licence that lets it be used."""

import json
import re

from tests.architecture.sources import ROOT
from tools.sbom import bill, locked

FREE = re.compile(
    r"MIT|BSD|Apache|ISC|PSF|Python Software|MPL|Mozilla|Zope|LGPL|0BSD|Unlicense|HPND|CC0|OFL", re.I
)


def test_everything_that_is_locked_is_named_with_a_licence() -> None:
    found = bill()
    components = {each["purl"]: each for each in found["components"]}
    assert len(components) == len(found["components"])
    for name, (version, hashes) in locked().items():
        if f"pkg:pypi/{name}@{version}" not in components:
            assert name in ("tzdata", "colorama", "deprecated", "numpy"), name  # for other systems
            continue
        assert hashes
    npm = json.loads((ROOT / "package.json").read_text(encoding="utf-8"))["dependencies"]
    named = {each["name"] for each in found["components"] if each["purl"].startswith("pkg:npm/")}
    assert set(npm) <= named
    for each in components.values():
        licence = each["licenses"][0]["license"]["name"]
        assert FREE.search(licence), (each["name"], licence)
