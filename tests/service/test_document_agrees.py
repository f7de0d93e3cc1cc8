"""What the document allows is accepted, and what it forbids is refused: schemathesis draws both."""

import re
import time
from collections.abc import Iterator
from itertools import chain, combinations
from pathlib import Path
from typing import Any

import pytest
import requests
import schemathesis
from hypothesis import HealthCheck, Phase, settings
from jsonschema import Draft202012Validator
from pydantic import BaseModel, ValidationError
from schemathesis import GenerationMode
from schemathesis.checks import not_a_server_error
from schemathesis.specs.openapi.checks import positive_data_acceptance

from service.routes.kinematics.scm_inverse import RandomConfigurationRequest
from service.routes.kinematics.workspace import WorkspaceRequest
from service.schemas.kinematics.conversion import ConvertRequest
from service.schemas.kinematics.inverse_kinematics import NumericInverseKinematicsRequest
from tests.conftest import EXPLORE
from tests.document import DOCUMENT
from tests.drawn_calls import for_each_call
from tests.examples import SCARA_CHAIN, TWO_LINKS
from tests.service.likely_requests import likely, with_whole_robots

EXAMPLES = 40 if EXPLORE else 4

MESSAGES = Path(__file__).resolve().parents[2] / "service" / "locales" / "en"


def codes_of(file: str) -> set[str]:
    return set(re.findall(r"^error-(\w+)", (MESSAGES / file).read_text(encoding="utf-8"), re.MULTILINE))


CELLS = codes_of("cells.ftl") - {"table_empty"}
"""What a cell means is the grammar's matter, and how large numbers may be is a setting."""
EXERCISES = codes_of("exercises.ftl") - {"answer_empty", "source_form", "exercise_id_invalid"}
"""What a definition or an answer to an exercise means depends on the exercise."""
ROBOTS = {  # what there is of a robot: its joints, rows, parameters, links, its size
    *("parameter_missing", "parameter_name_invalid", "joint_variable_unknown", "joint_variable_in_number"),
    *("name_without_value", "rate_in_marks"),
    "table_too_many_rows",
    *("joints_wrong_length", "limits_wrong_length", "joint_row_length", "motion_row_count"),
    *("links_count", "links_missing", "screw_count", "frames_too_many", "frame_unknown"),
    *("slide_without_limits", "dynamics_without_joints", "tree_after_unknown"),
    *("scm_no_variable", "scm_too_many_joints", "scm_parameter_two_kinds", "pose_tolerance_out_of_range"),
    *("urdf_not_xml", "urdf_joint_names", "urdf_link_names"),
    *("robot_unknown", "not_plantable", "not_singular"),
    *(
        "inverse_form_unknown",
        "inverse_form_idle_joint",
        "inverse_joint_count",
        "form_too_large",
        "archive_not_zip",
    ),
}
GEOMETRY = {  # four rows of four numbers are seldom a pose, zeros point nowhere, and angles lock
    *("pose_bottom_row", "pose_not_orthonormal", "pose_left_handed", "direction_zero", "axis_length"),
    *("quaternion_length", "expected_not_rotation", "frame_y_not_z_cross_x", "vector_malformed"),
    *("screw_of_other_type", "angles_locked", "matrix_not_rotation", "variable_name_invalid"),
}
BEYOND_A_SCHEMA = CELLS | EXERCISES | ROBOTS | GEOMETRY
"""Codes of refusals of what has the right shape."""
NPY = "application/x-npy"
ALL_CHECKS_OFF = list(HealthCheck)


@schemathesis.serializer(NPY)
def as_npy(_: Any, value: Any) -> bytes:
    return value if isinstance(value, bytes) else str(value).encode()


schema = schemathesis.openapi.from_dict(with_whole_robots(DOCUMENT))
schema.config.generation.update(max_examples=EXAMPLES)
schema.config.checks.negative_data_rejection.expected_statuses = ["400", "404", "406", "413", "415", "422"]
likely_schema = schemathesis.openapi.from_dict(likely(DOCUMENT))
likely_schema.config.generation.update(max_examples=EXAMPLES // 2, modes=[GenerationMode.POSITIVE])


CONNECTED = requests.Session()
CONNECTED.trust_env = False


@pytest.fixture(scope="module", autouse=True)
def disconnected_at_the_end() -> Iterator[None]:
    yield
    CONNECTED.close()


@pytest.fixture(scope="module", autouse=True)
def ready(base_url: str) -> None:
    """Wait until the service has started whole, or /readyz is right to say that it has not."""
    for _ in range(600):
        if CONNECTED.get(f"{base_url}/readyz", timeout=120).status_code == 200:
            return
        time.sleep(0.1)


@pytest.fixture
def called(base_url: str) -> dict[str, Any]:
    return {"base_url": base_url}


def answer(case: schemathesis.Case, base_url: str) -> Any:
    """What the service answers, on a connection that stays."""
    return case.call(base_url=base_url, session=CONNECTED, headers={"Accept": "*/*"}, timeout=120)


def is_beyond_a_schema(response: Any, case: schemathesis.Case) -> bool:
    """Whether a refusal is about what no schema says; of bytes for npy it says nothing at all."""
    if response.status_code not in (400, 422):
        return False
    return case.media_type == NPY or {entry["code"] for entry in response.json()["errors"]} <= BEYOND_A_SCHEMA


@for_each_call(schema)
@settings(
    max_examples=EXAMPLES,
    deadline=None,
    phases=[Phase.explicit, Phase.generate],
    suppress_health_check=ALL_CHECKS_OFF,
)
def test_whatever_is_sent_the_document_holds(base_url: str, case: schemathesis.Case) -> None:
    response = answer(case, base_url)
    excused = is_beyond_a_schema(response, case)
    case.validate_response(response, excluded_checks=[positive_data_acceptance] if excused else [])


@for_each_call(likely_schema.include(method="POST"))
@settings(max_examples=EXAMPLES, deadline=None, phases=[Phase.generate], suppress_health_check=ALL_CHECKS_OFF)
def test_what_callers_mostly_send_is_accepted(base_url: str, case: schemathesis.Case) -> None:
    response = answer(case, base_url)
    checks = [not_a_server_error, positive_data_acceptance]
    case.validate_response(response, checks=checks[: 1 if is_beyond_a_schema(response, case) else 2])


POSE = [0, 0, 0, 0, 0, 0]
TABLE = TWO_LINKS
CHOICES: dict[type[BaseModel], dict[str, list[Any]]] = {
    ConvertRequest: {
        "to": ["standard", "urdf", "poe"],
        "table": [TABLE],
        "urdf": ["<robot/>"],
        "poe": [{"screws": [{"linear": [0, 0, 0], "angular": [0, 0, 1]}], "home": [[1, 0, 0, 0]] * 4}],
        "base": [POSE],
        "tip_link": ["tip"],
        "angle_unit": ["deg"],
        "name": ["arm"],
        "limits": [[None]],
        "verify": ["off"],
    },
    NumericInverseKinematicsRequest: {
        "table": [TABLE],
        "robot": ["puma560"],
        "target": [POSE],
        "targets": [[POSE]],
        "position": [[1, 2, 3]],
        "quaternion": [[1, 0, 0, 0]],
        "axis": [[0, 0, 1]],
    },
    WorkspaceRequest: {
        "table": [TABLE],
        "robot": ["puma560"],
        "quaternion": [[1, 0, 0, 0]],
        "axis": [[0, 0, 1]],
        "samples": [5, 5.0],
    },
    RandomConfigurationRequest: {
        "chain": [SCARA_CHAIN],
        "robot": ["puma560"],
        "count": [1, 1.0],
        "seed": [2.0],
    },
}


@pytest.mark.parametrize("model", CHOICES, ids=lambda model: model.__name__)
def test_fields_that_exclude_or_need_each_other_do_so_in_the_document(model: type[BaseModel]) -> None:
    """Every three given fields and fewer, the others left out or null."""
    shape = model.model_json_schema()
    allowed = Draft202012Validator(shape)
    nullable = {
        name for name in CHOICES[model] if {"type": "null"} in shape["properties"][name].get("anyOf", ())
    }
    fields = [(name, value) for name, values in CHOICES[model].items() for value in values]
    accepted = []
    for given in map(dict, chain.from_iterable(combinations(fields, count) for count in range(4))):
        for body in (given, dict.fromkeys(nullable) | given):
            accepted.append(is_accepted(model, body))
            assert allowed.is_valid(body) is accepted[-1], body
    assert set(accepted) == {True, False}


def is_accepted(model: type[BaseModel], body: dict[str, Any]) -> bool:
    try:
        model.model_validate(body)
    except ValidationError:
        return False
    return True
