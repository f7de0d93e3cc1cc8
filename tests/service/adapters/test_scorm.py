"""The manifest of a SCORM package."""

import pytest
from defusedxml.ElementTree import fromstring

from service.adapters.scorm import ScormPackage, ScormVersion, manifest

V1_2 = "{http://www.adlnet.org/xsd/adlcp_rootv1p2}masteryscore"
V2004 = "{http://www.imsglobal.org/xsd/imsss}minNormalizedMeasure"


@pytest.mark.parametrize(
    ("pass_mark", "percent", "share"),
    [(0.5, "50", "0.5000"), (0.655, "65.5", "0.6550"), (1 / 3, "33.33", "0.3333"), (1.0, "100", "1.0000")],
)
def test_what_passes_here_passes_in_the_lms(pass_mark: float, percent: str, share: str) -> None:
    """A whole percentage, 66, made an LMS fail a student of 65.5 who had been told to have passed."""
    told = []
    for version, name in ((ScormVersion.V1_2, V1_2), (ScormVersion.V2004, V2004)):
        package = ScormPackage(
            version=version, identifier="twolink", title="<Two & links>", language="en", url="https://x",
            per_student=True, pass_mark=pass_mark, sentences={},
        )  # fmt: skip
        (found,) = fromstring(manifest(package)).iter(name)
        told.append(found.text)
    assert told == [percent, share]
