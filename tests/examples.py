"""Tables, answers and drafts that the OpenAPI document shows, for tests that ask other things of them."""

from typing import Any

from service.http.openapi import examples_by_call

_EXAMPLES = examples_by_call()


def _shown(call: str, name: str) -> dict[str, Any]:
    body: dict[str, Any] = _EXAMPLES[call][name]
    return body


PUMA_560 = _shown("/forward-kinematics", "PUMA 560, one configuration")["table"]
PUMA_LENGTHS = _shown("/symbolic", "PUMA 560 with its lengths as symbols")["table"]
CYLINDRICAL = _shown("/forward-kinematics", "a batch with parameters, base and inverse")["table"]
TWO_LINKS = _shown("/symbolic", "two links as functions, one length given")["table"]
TURNING_ARM = _shown("/convert", "a chain of a URDF description to the standard convention")["urdf"]
SCARA_CHAIN = _shown("/scm/forward-kinematics", "SCARA in closed form")["chain"]

GRADE = _EXAMPLES["/grade"]
SCARA, SCARA_BY_THE_BOOK = (GRADE["another choice of frames"][name] for name in ("reference", "submission"))
RX90 = GRADE["a wrong answer, told by row only"]["reference"]
ANSWERS = _EXAMPLES["/exercises/{exercise_id}/grade"]

DRAFT = _shown("/author/preview", "two links")["draft"]
DRAWING = _shown("/author/start", "drawn axes")["source"]["axes"]
