"""What POST /check-screws says of a product of exponentials beside right or wrong."""

import pytest

TABLE = {
    "convention": "standard",
    "rows": [
        {"alpha": 0, "a": 0.5, "d": 0, "theta": "q1"},
        {"alpha": 0, "a": 0.3, "d": 0, "theta": "q2"},
    ],
}
SCREWS = [[0, 0, 0, 0, 0, 1], [0, -0.5, 0, 0, 0, 1]]
HOME = [[1, 0, 0, 0.8], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
RAISED = [*HOME[:2], [0, 0, 1, 1], HOME[3]]
BACKWARDS = [[0, 0, 0, 0, 0, 1], [0, 0.5, 0, 0, 0, -1]]


@pytest.mark.parametrize(
    ("screws", "home", "policy", "codes"),
    [
        (SCREWS, HOME, {"base": "frame", "tool": "frame"}, ["screws_right"]),
        (BACKWARDS, HOME, {}, ["screws_right"]),
        (BACKWARDS, HOME, {"direction": "figure"}, ["screws_right_robot", "direction_missed"]),
        (SCREWS, RAISED, {"base": "origin", "tool": "point"}, ["screws_right_robot"]),
        (SCREWS, RAISED, {"base": "origin"}, ["screws_right"]),
        (SCREWS, RAISED, {"base": "frame", "tool": "frame"}, ["screws_right_robot"]),
        ([SCREWS[0], [0, -0.4, 0, 0, 0, 1]], HOME, {}, ["screws_wrong"]),
    ],
)
def test_the_rule_that_the_right_robot_breaks_is_named(client, screws, home, policy, codes):
    body = {"table": TABLE, "screws": screws, "home": home, "policy": policy}
    answer = client.post("/api/v1/check-screws", json=body, headers={"Accept-Language": "fr"}).json()
    assert [entry["code"] for entry in answer["feedback"]] == codes
    assert answer["correct"] is (codes == ["screws_right"])
    assert all(entry["message"] != entry["code"] for entry in answer["feedback"])
