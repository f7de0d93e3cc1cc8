"""SCORM packages: an exercise that an LMS plays without knowing us (SCORM 1.2 and 2004, 4th edition)."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from importlib.resources import files

from jinja2 import Environment, StrictUndefined
from markupsafe import Markup

from exercises.authoring.archive import zipped

_PACKAGE = files("service.adapters") / "scorm_package"
_TEMPLATES = Environment(
    autoescape=True,
    undefined=StrictUndefined,
    trim_blocks=True,
    lstrip_blocks=True,
    keep_trailing_newline=True,
)
_FILES = ("index.html", "player.js")


class ScormVersion(StrEnum):
    """The editions that learning management systems read."""

    V1_2 = "1.2"
    V2004 = "2004"


@dataclass(frozen=True, kw_only=True, slots=True)
class ScormPackage:
    """What a package is made of.

    Attributes:
        version: SCORM 1.2, or 2004 4th edition.
        identifier: the exercise's id, for the manifest.
        title: the exercise's title, in the package's language.
        language: language of the package's own page.
        url: address of the exercise's page, with everything but the student's seed.
        per_student: whether every student gets values of their own.
        pass_mark: share of the points, 0 to 1, from which on the LMS is told "passed".
        sentences: `no_script` and `no_lms`, in the package's language.
    """

    version: ScormVersion
    identifier: str
    title: str
    language: str
    url: str
    per_student: bool
    pass_mark: float
    sentences: Mapping[str, str]


def package(what: ScormPackage) -> bytes:
    """Return the package as a zip archive; the same package gives the same bytes."""
    return zipped(
        {
            "imsmanifest.xml": manifest(what),
            "index.html": _page(what),
            "player.js": (_PACKAGE / "player.js").read_text(encoding="utf-8"),
        }
    )


def manifest(what: ScormPackage) -> str:
    """Return imsmanifest.xml: one item, one SCO, its files."""
    return _rendered(
        "imsmanifest.xml",
        identifier=what.identifier,
        pass_mark=what.pass_mark,
        files=_FILES,
        is_1_2=what.version is ScormVersion.V1_2,
        title=_NOT_XML.sub("", what.title),
    )


_NOT_XML = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What no XML document can hold, however it is written (XML 1.0 §2.2)."""


def _page(what: ScormPackage) -> str:
    settings = {
        "version": what.version.value,
        "url": what.url,
        "per_student": what.per_student,
        "pass": what.pass_mark,
        "salt": f"framewise:{what.identifier}",
    }
    # In a script element no character reference is read, and "</" would end it.
    written = Markup(json.dumps(settings).replace("<", "\\u003c"))  # noqa: S704
    return _rendered(
        "index.html", language=what.language, title=what.title, settings=written, **what.sentences
    )


def _rendered(name: str, **values: object) -> str:
    return _TEMPLATES.from_string((_PACKAGE / name).read_text(encoding="utf-8")).render(values)
