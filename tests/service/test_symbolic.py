"""POST /symbolic: the answers agree with the numbers of the other calls, and nothing hostile hurts."""

import asyncio
import json
import re
import subprocess
import sys
import threading
import time
import xml.etree.ElementTree as ET
from typing import Any

import httpx
import numpy as np
import pytest

from kinematics.expressions import evaluate
from kinematics.printing import Format
from service.app import create_app
from service.settings import Settings
from tests.examples import PUMA_LENGTHS
from tests.kinematics.printing.tree_reader import from_tree
from tests.live_service import running

VALUES = {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
JOINTS = [10.0, -35.0, 50.0, 120.0, 65.0, -20.0]
POSE = [[0, -1, 0, 0.1], [1, 0, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]]
MATHML = "{http://www.w3.org/1998/Math/MathML}"


def ask(client: httpx.Client, **body: Any) -> dict[str, Any]:
    response = client.post("/api/v1/symbolic", json=body)
    assert response.status_code == 200, response.text
    answer: dict[str, Any] = response.json()
    return answer


def numbers(written: dict[str, Any], values: dict[str, float], joints: list[float]) -> np.ndarray:  # type: ignore[type-arg]
    return np.array(
        [[evaluate(from_tree(entry), values, joints) for entry in row] for row in written["json"]]
    )


@pytest.fixture(scope="module")
def numeric(client: httpx.Client) -> dict[str, Any]:
    body = {
        "table": PUMA_LENGTHS,
        "parameters": VALUES,
        "joints": JOINTS,
        "base": POSE,
        "tool": POSE,
        "inverse": True,
    }
    answer: dict[str, Any] = client.post("/api/v1/forward-kinematics", json=body).json()
    return answer


def test_every_matrix_agrees_with_forward_kinematics(client: httpx.Client, numeric: dict[str, Any]) -> None:
    answer = ask(
        client, table=PUMA_LENGTHS, formats=["json"], base=POSE, tool=POSE, inverse=True, jacobian=True
    )
    radians = np.radians(JOINTS).tolist()
    for part in ("transform", "inverse"):
        np.testing.assert_allclose(numbers(answer[part], VALUES, radians), numeric[part], atol=1e-12)
    for part in ("links", "frames"):
        computed = [numbers(matrix, VALUES, radians) for matrix in answer[part]]
        np.testing.assert_allclose(computed, numeric[part], atol=1e-12)
    body = {"table": PUMA_LENGTHS, "parameters": VALUES, "joints": JOINTS, "base": POSE, "tool": POSE}
    jacobians = client.post("/api/v1/jacobian", json=body).json()
    for name in ("J0", "Jn"):
        computed = numbers(answer["jacobian"][name], VALUES, radians)
        np.testing.assert_allclose(computed, jacobians[name], atol=1e-12)


def test_the_analytic_jacobian_of_named_angles_agrees_with_that_of_rates(client: httpx.Client) -> None:
    robot = {"table": PUMA_LENGTHS, "base": POSE, "tool": POSE, "angles": {"axes": "ZYX"}}
    body = robot | {"form": "symbolic", "formats": ["json", "c"], "frame": "base"}
    answer = client.post("/api/v1/jacobian", json=body).json()
    assert set(answer) >= {"J0", "analytic"}
    assert "Jn" not in answer
    assert "void Ja(" in answer["analytic"]["c"]
    rates = client.post("/api/v1/rates", json=robot | {"parameters": VALUES, "joints": JOINTS}).json()
    found = numbers(answer["analytic"], VALUES, np.radians(JOINTS).tolist())
    expected = np.array(rates["analytic"])
    expected[4] *= np.sign(expected[4] @ found[4])  # two triples make the orientation
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_angles_that_never_have_rates_have_no_analytic_jacobian(client: httpx.Client) -> None:
    body = {"robot": "scara", "form": "symbolic", "formats": ["text"], "angles": {"axes": "ZYZ"}}
    answer = client.post("/api/v1/jacobian", json=body).json()
    assert answer["analytic"] is None
    assert "J0" in answer
    named = client.post("/api/v1/jacobian", json=body | {"angles": {"axes": "ZZY"}})
    assert named.status_code == 422
    assert named.json()["errors"][0]["pointer"] == "/angles/axes"


def test_the_shape_is_the_documented_one(client: httpx.Client) -> None:
    answer = ask(client, table=PUMA_LENGTHS, formats=[chosen.value for chosen in Format], notation="short")
    assert answer["variables"] == ["q1", "q2", "q3", "q4", "q5", "q6"]
    assert answer["parameters"] == ["a2", "a3", "d3", "d4"]
    assert len(answer["links"]) == len(answer["frames"]) == 6
    for written in (*answer["links"], *answer["frames"], answer["transform"]):
        assert set(written) == {chosen.value for chosen in Format}
        assert [len(row) for row in written["text"]] == [4] * 4
        assert written["latex"].startswith(r"\begin{bmatrix}")
        assert ET.fromstring(written["mathml"]).tag == f"{MATHML}math"
        assert "def T_" in written["python"]
    assert answer["symbols"]["c23"] == "cos(q2 + q3)"
    assert answer["transform"]["text"][0][3] == "c1*(a2*c2 + a3*c23 - d4*s23) + d3*s1"
    assert answer["operations"] <= 265


def test_full_notation_is_the_default_and_needs_no_legend(client: httpx.Client) -> None:
    answer = ask(client, table=PUMA_LENGTHS)
    assert set(answer["transform"]) == {"latex", "text"}
    assert "symbols" not in answer
    assert answer["transform"]["text"][2][3] == "a2*sin(q2) + a3*sin(q2 + q3) + d4*cos(q2 + q3)"


def test_joint_variables_keep_the_names_typed(client: httpx.Client) -> None:
    rows = [{"alpha": 0, "a": "L1", "d": 0, "theta": "θ₁*"}, {"alpha": 0, "a": 0, "d": "d2", "theta": 0}]
    table = {"convention": "standard", "rows": rows}
    answer = ask(client, table=table, parts=["transform"], formats=["text", "entries"])
    assert answer["variables"] == ["theta1", "d2"]
    assert answer["transform"]["text"][0][3] == "L1*cos(theta1)"
    assert answer["transform"]["entries"][3] == {
        "name": "px",
        "text": "L1*cos(theta1)",
        "latex": r"p_{x}=L_{1}\cos(\theta_{1})",
    }


def test_some_parameters_may_have_values(client: httpx.Client) -> None:
    answer = ask(client, table=PUMA_LENGTHS, parameters={"a_2": 0.4318, "d3": 0}, parts=["transform"])
    assert answer["parameters"] == ["a3", "d4"]
    assert answer["transform"]["text"][2][3] == "0.4318*sin(q2) + a3*sin(q2 + q3) + d4*cos(q2 + q3)"
    assert "links" not in answer


def test_an_angle_parameter_takes_the_unit_of_the_table(client: httpx.Client) -> None:
    table = {
        "convention": "standard",
        "angle_unit": "deg",
        "rows": [{"alpha": "beta", "a": 0, "d": 0, "theta": "q1"}],
    }
    answer = ask(client, table=table, parameters={"beta": 60}, parts=["transform"])
    assert answer["transform"]["text"][2] == ["0", "sqrt(3)/2", "1/2", "0"]


def test_a_robot_of_the_catalogue_keeps_its_lengths_as_symbols(client: httpx.Client) -> None:
    answer = ask(client, robot="scara", formats=["text"], notation="short", parts=["transform"])
    assert answer["transform"]["text"][0] == ["c124", "-s124", "0", "a2*c1 + a3*c12"]


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"parameters": {"L9": 1}}, "parameter_unused", "/parameters/L9"),
        ({"formats": ["word"]}, "value_not_allowed", "/formats/0"),
        ({"formats": []}, None, "/formats"),
        ({"notation": "long"}, None, "/notation"),
        ({"tool": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}, None, "/tool"),
        ({"surplus": 1}, "field_unknown", "/surplus"),
        ({"robot": "puma560"}, None, ""),
    ],
)
def test_what_is_wrong_is_named(
    client: httpx.Client, change: dict[str, Any], code: str | None, pointer: str
) -> None:
    response = client.post("/api/v1/symbolic", json={"table": PUMA_LENGTHS, **change})
    assert response.status_code == 422
    assert response.headers["content-type"] == "application/problem+json"
    problem = response.json()
    assert problem["pointer"].startswith(pointer)
    if code:
        assert problem["code"] == code


def test_a_value_that_leaves_a_cell_undefined_is_named(client: httpx.Client) -> None:
    table = {"convention": "standard", "rows": [{"alpha": 0, "a": "1/(L1 - L2)", "d": 0, "theta": "q1"}]}
    response = client.post("/api/v1/symbolic", json={"table": table, "parameters": {"L1": 2, "L2": 2}})
    assert response.json()["code"] == "value_undefined"
    assert response.json()["pointer"] == "/table/rows/0/a"


def hostile_rows(n: int, **cells: str) -> list[dict[str, Any]]:
    return [
        {"alpha": f"0.{i}37", "a": f"0.{i}1", "d": f"0.0{i}3", "theta": f"q{i + 1}", **cells}
        for i in range(n)
    ]


def test_64_general_rows_are_refused_where_they_would_be_written_out(client: httpx.Client) -> None:
    response = client.post(
        "/api/v1/symbolic", json={"table": {"convention": "standard", "rows": hostile_rows(64)}}
    )
    assert response.status_code == 422
    assert response.json()["code"] in {"closed_form_too_large", "computation_out_of_time"}


def test_a_large_table_still_becomes_a_function(client: httpx.Client) -> None:
    table = {"convention": "standard", "rows": hostile_rows(24)}
    answer = ask(client, table=table, formats=["python"], parts=["transform"])
    assert "operations" not in answer
    scope: dict[str, Any] = {}
    exec(answer["transform"]["python"], scope)
    joints = [0.1 * i for i in range(24)]
    expected = client.post("/api/v1/forward-kinematics", json={"table": table, "joints": joints}).json()[
        "transform"
    ]
    np.testing.assert_allclose(scope["T_0_24"](joints), expected, atol=1e-11)


def test_hostile_requests_end_in_time_and_delay_nobody() -> None:
    settings = Settings(symbolic_seconds=0.5, symbolic_queue=1, queue_seconds=120)
    everything = {
        "formats": ["python", "numpy", "c", "matlab", "javascript"],
        "jacobian": True,
    }
    with running(settings) as url, httpx.Client(base_url=url, timeout=120) as client:
        client.post("/api/v1/symbolic", json={"table": PUMA_LENGTHS})
        answers: list[httpx.Response] = []
        together = threading.Barrier(4)

        def hostile(number: int) -> None:
            table = {"convention": "modified", "rows": hostile_rows(64, alpha=f"0.{number}*alpha1")}
            body = {"table": table, **everything}
            together.wait(60)
            answers.append(httpx.post(f"{url}/api/v1/symbolic", json=body, timeout=120))

        threads = [threading.Thread(target=hostile, args=(number,)) for number in range(3, 7)]
        for thread in threads:
            thread.start()
        time.sleep(0.3)
        for length in (1, 2, 3):
            response = client.post(
                "/api/v1/symbolic", json={"table": PUMA_LENGTHS, "parameters": {"a2": length}}
            )
            assert response.status_code == 200
        for thread in threads:
            thread.join()
    statuses = sorted(response.status_code for response in answers)
    assert set(statuses) == {422, 503}
    for response in answers:
        problem = response.json()
        if response.status_code == 503:
            assert problem["code"] == "busy"
            assert response.headers["retry-after"] == "2"
        else:
            assert problem["code"] == "computation_out_of_time"


def test_one_request_at_a_time_is_read_and_others_are_answered_meanwhile() -> None:
    async def test() -> None:
        app = create_app()
        transport = httpx.ASGITransport(app=app)
        async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
            slot = await app.state.resources.reading.acquire()
            try:
                table = {"convention": "standard", "rows": hostile_rows(3)}
                body = {"table": table, "formats": ["text"] * 250}  # too long to be read at once
                asked = asyncio.create_task(client.post("/api/v1/symbolic", json=body))
                assert (await client.get("/healthz")).status_code == 200
                assert not asked.done()
            finally:
                slot.release()
            assert (await asked).status_code == 200
        app.state.resources.workers.close()

    asyncio.run(test())


def test_no_two_functions_of_an_answer_have_one_name(client: httpx.Client) -> None:
    """Put into one file they must compile: frame 6 and the tool are different poses."""
    body = {"table": PUMA_LENGTHS, "formats": ["c"], "inverse": True, "jacobian": True}
    for poses in ({}, {"tool": POSE}, {"base": POSE}, {"base": POSE, "tool": POSE}):
        answer = ask(client, **body, **poses)
        written = [*answer["links"], *answer["frames"], answer["inverse"], *answer["jacobian"].values()]
        if "tool" in poses:
            written.append(answer["transform"])
        else:
            assert answer["transform"] == answer["frames"][-1]
        if "base" not in poses:
            assert answer["links"][0] == answer["frames"][0]
            written = written[1:]
        names = re.findall(r"^void (\w+)\(", "\n".join(matrix["c"] for matrix in written), re.MULTILINE)
        assert len(names) == len(written)
        assert len(set(names)) == len(names)


def test_the_answer_is_kept(client: httpx.Client) -> None:
    body = {"table": PUMA_LENGTHS, "parameters": {"a2": 0.25}}
    first, second = (client.post("/api/v1/symbolic", json=body) for _ in range(2))
    assert first.content == second.content


def test_sympy_is_never_imported() -> None:
    program = """
import asyncio, json, sys
import httpx
from service.app import create_app
from tests.examples import PUMA_LENGTHS
from service.work.workers import Lane

async def main():
    app = create_app()
    transport = httpx.ASGITransport(app=app)
    async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
        body = {"table": PUMA_LENGTHS, "formats": ["latex", "c"]}
        response = await client.post("/api/v1/symbolic", json=body)
    assert response.status_code == 200, response.text
    inside = await app.state.resources.workers.run(Lane.QUICK, json.dumps, {"a": 1})
    app.state.resources.workers.close()
    print(json.dumps({"sympy": "sympy" in sys.modules, "inside": inside}))

if __name__ == "__main__":
    asyncio.run(main())
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == {"sympy": False, "inside": '{"a": 1}'}


def test_the_jacobian_call_answers_in_closed_form_too(client: httpx.Client) -> None:
    body = {"form": "symbolic", "table": PUMA_LENGTHS, "formats": ["json", "text"], "notation": "short"}
    answer = client.post("/api/v1/jacobian", json=body).json()
    numeric = client.post(
        "/api/v1/jacobian", json={"table": PUMA_LENGTHS, "parameters": VALUES, "joints": JOINTS}
    ).json()
    for name in ("J0", "Jn"):
        computed = numbers(answer[name], VALUES, np.radians(JOINTS).tolist())
        np.testing.assert_allclose(computed, numeric[name], atol=1e-12)
    assert answer["symbols"]["s23"] == "sin(q2 + q3)"
    only = client.post("/api/v1/jacobian", json={**body, "frame": "end"}).json()
    assert "J0" not in only
    refused = client.post("/api/v1/jacobian", json={**body, "joints": JOINTS})
    assert refused.json()["code"] == "field_unknown"
