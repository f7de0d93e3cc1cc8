"""What an installation consists of: a bill of materials in CycloneDX, with licences, from the locks.

`python tools/sbom.py [file]` writes JSON (CycloneDX 1.6): every package of requirements.lock that stands
here, with its licence and the hashes of the lock, and every npm package that the pages load. `--licences`
prints them as a list.
"""

import argparse
import json
import re
import sys
from email.message import Message
from importlib import metadata
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
_PINNED = re.compile(r"^([A-Za-z0-9_.-]+)==([^ ;\\]+)")
_HASH = re.compile(r"--hash=sha256:([0-9a-f]{64})")


def locked() -> dict[str, tuple[str, list[str]]]:
    """Version and hashes of every package of the lock by its name; of several versions, the installed one."""
    found: dict[str, tuple[str, list[str]]] = {}
    for block in (ROOT / "requirements.lock").read_text(encoding="utf-8").replace("\\\n", " ").splitlines():
        pinned = _PINNED.match(block)
        if pinned and _installed(pinned[1]) in (None, pinned[2]):
            found[pinned[1]] = (pinned[2], _HASH.findall(block))
    return found


def _installed(name: str) -> str | None:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return None


def python_components() -> list[dict[str, Any]]:
    """Every Python package of the lock that is installed here: what other systems need is left out."""
    components = []
    for name, (version, hashes) in sorted(locked().items()):
        if _installed(name) is None:
            continue
        components.append(
            {
                "type": "library",
                "bom-ref": f"pkg:pypi/{name}@{version}",
                "name": name,
                "version": version,
                "purl": f"pkg:pypi/{name}@{version}",
                "licenses": [{"license": {"name": licence_of(metadata.metadata(name))}}],  # type: ignore[arg-type]
                "properties": [{"name": "framewise:sha256", "value": value} for value in hashes],
            }
        )
    return components


def licence_of(told: Message) -> str:
    """What a package says of its licence: the SPDX expression, else its classifiers, else its words."""
    expression = told.get("License-Expression")
    if expression:
        return str(expression)
    classifiers = [
        entry.rpartition("::")[2].strip()
        for entry in told.get_all("Classifier") or ()
        if entry.startswith("License ::")
    ]
    words = str(told.get("License") or "").strip().splitlines()
    return " OR ".join(classifiers) or (words[0] if words else "") or "unknown"


def npm_components() -> list[dict[str, Any]]:
    """Every npm package that the pages load."""
    packages = json.loads((ROOT / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    components = []
    for path, entry in sorted(packages.items()):
        if not path or entry.get("dev") or entry.get("devOptional"):
            continue
        name = path.rpartition("node_modules/")[2]
        address = f"pkg:npm/{name.replace('@', '%40', 1)}@{entry['version']}"
        components.append(
            {
                "type": "library",
                "bom-ref": address,
                "name": name,
                "version": entry["version"],
                "purl": address,
                "licenses": [{"license": {"name": entry.get("license", "unknown")}}],
                "properties": [{"name": "framewise:integrity", "value": entry["integrity"]}],
            }
        )
    return components


def bill() -> dict[str, Any]:
    """The whole bill of materials."""
    sys.path.insert(0, str(ROOT))
    from service import __version__

    own = {
        "type": "application",
        "bom-ref": "framewise",
        "name": "framewise",
        "version": __version__,
        "licenses": [{"license": {"id": "Apache-2.0"}}],
    }
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {"component": own},
        "components": [*python_components(), *npm_components()],
    }


def main() -> None:
    """Write the bill, or print the licences."""
    parser = argparse.ArgumentParser(description="The bill of materials of this checkout.")
    parser.add_argument("file", nargs="?", type=Path, help="where to write; standard output if left out")
    parser.add_argument("--licences", action="store_true", help="a line for each package instead")
    chosen = parser.parse_args()
    found = bill()
    if chosen.licences:
        text = "".join(
            f"{each['name']} {each['version']}: {each['licenses'][0]['license']['name']}\n"
            for each in found["components"]
        )
    else:
        text = json.dumps(found, indent=2) + "\n"
    if chosen.file:
        chosen.file.write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
