"""SCORM packages: an exercise that an LMS plays without knowing us (SCORM 1.2 and 2004, 4th edition)."""

from __future__ import annotations

import io
import json
import re
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from html import escape
from importlib.resources import files
from xml.sax.saxutils import escape as xml
from xml.sax.saxutils import quoteattr

_PACKAGE = files("service.adapters") / "scorm_package"
_LONG_AGO = (1980, 1, 1, 0, 0, 0)
"""The first time that a zip file can tell: the same package is the same bytes."""
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
    contents = {
        "imsmanifest.xml": manifest(what),
        "index.html": _page(what),
        "player.js": (_PACKAGE / "player.js").read_text(encoding="utf-8"),
    }
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in contents.items():
            entry = zipfile.ZipInfo(name, _LONG_AGO)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, text.encode())
    return stream.getvalue()


def manifest(what: ScormPackage) -> str:
    """Return imsmanifest.xml: one item, one SCO, its files."""
    identifier = f"framewise-{what.identifier}"
    listed = "\n".join(f"      <file href={quoteattr(name)}/>" for name in _FILES)
    edition, item = _EDITIONS[what.version]
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier={quoteattr(identifier)} version="1"
{edition.namespaces}>
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>{edition.schema_version}</schemaversion>
  </metadata>
  <organizations default="organization">
    <organization identifier="organization">
      <title>{_xml(what.title)}</title>
      <item identifier="item" identifierref="resource">
        <title>{_xml(what.title)}</title>
{item(what)}      </item>
{edition.after_items}    </organization>
  </organizations>
  <resources>
    <resource identifier="resource" type="webcontent" adlcp:{edition.scorm_type}="sco" href="index.html">
{listed}
    </resource>
  </resources>
</manifest>
"""


@dataclass(frozen=True, slots=True)
class _Edition:
    namespaces: str
    schema_version: str
    scorm_type: str
    after_items: str = ""


_1_2 = _Edition(
    """  xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
  xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2"
  xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
  xsi:schemaLocation="http://www.imsproject.org/xsd/imscp_rootv1p1p2 imscp_rootv1p1p2.xsd
    http://www.adlnet.org/xsd/adlcp_rootv1p2 adlcp_rootv1p2.xsd\"""",
    "1.2",
    "scormtype",
)
_2004 = _Edition(
    """  xmlns="http://www.imsglobal.org/xsd/imscp_v1p1"
  xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_v1p3"
  xmlns:adlseq="http://www.adlnet.org/xsd/adlseq_v1p3"
  xmlns:adlnav="http://www.adlnet.org/xsd/adlnav_v1p3"
  xmlns:imsss="http://www.imsglobal.org/xsd/imsss"
  xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
  xsi:schemaLocation="http://www.imsglobal.org/xsd/imscp_v1p1 imscp_v1p1.xsd
    http://www.adlnet.org/xsd/adlcp_v1p3 adlcp_v1p3.xsd
    http://www.adlnet.org/xsd/adlseq_v1p3 adlseq_v1p3.xsd
    http://www.adlnet.org/xsd/adlnav_v1p3 adlnav_v1p3.xsd
    http://www.imsglobal.org/xsd/imsss imsss_v1p0.xsd\"""",
    "2004 4th Edition",
    "scormType",
    """      <imsss:sequencing>
        <imsss:controlMode choice="true" flow="true"/>
      </imsss:sequencing>
""",
)


_NOT_XML = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What no XML document can hold, however it is written (XML 1.0 §2.2)."""


def _xml(text: str) -> str:
    return xml(_NOT_XML.sub("", text))


def _item_1_2(what: ScormPackage) -> str:
    return f"        <adlcp:masteryscore>{round(100 * what.pass_mark)}</adlcp:masteryscore>\n"


def _item_2004(what: ScormPackage) -> str:
    return f"""        <imsss:sequencing>
          <imsss:objectives>
            <imsss:primaryObjective objectiveID="score" satisfiedByMeasure="true">
              <imsss:minNormalizedMeasure>{what.pass_mark:.4f}</imsss:minNormalizedMeasure>
            </imsss:primaryObjective>
          </imsss:objectives>
          <imsss:deliveryControls completionSetByContent="true" objectiveSetByContent="true"/>
        </imsss:sequencing>
"""


_EDITIONS = {ScormVersion.V1_2: (_1_2, _item_1_2), ScormVersion.V2004: (_2004, _item_2004)}


def _page(what: ScormPackage) -> str:
    settings = {
        "version": what.version.value,
        "url": what.url,
        "per_student": what.per_student,
        "pass": what.pass_mark,
        "salt": f"framewise:{what.identifier}",
    }
    # In a script element no character reference is read, and "</" would end it.
    written = json.dumps(settings).replace("<", "\\u003c")
    values = {"language": what.language, "title": what.title, **what.sentences}
    page = (_PACKAGE / "index.html").read_text(encoding="utf-8")
    for name, value in values.items():
        page = page.replace("{{ " + name + " }}", escape(value))
    return page.replace("{{ settings }}", written)
