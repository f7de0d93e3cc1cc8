"""How many robots are held as they were read: many short tables, few long ones."""

from typing import Any

from service.schemas.kinematics.robot_question import RobotQuestion
from service.settings import Settings
from service.wire.kinematics.prepared_robots import RobotCache

SIZE = 8


def request(number: int, rows: int) -> dict[str, Any]:
    cells = [{"theta": f"q{k + 1}", "d": 0.25, "a": number, "alpha": 0.5} for k in range(rows)]
    return {"table": {"convention": "standard", "rows": cells}}


def held(robots: RobotCache, requests: list[dict[str, Any]]) -> int:
    for asked in requests:
        robots.prepare(RobotQuestion.model_validate(asked), asked)
    return sum(robots.recall(asked) is not None for asked in requests)


def test_long_tables_of_numbers_are_not_hoarded() -> None:
    robots = RobotCache(Settings(table_cache=SIZE))
    assert held(robots, [request(number, 6) for number in range(2 * SIZE)]) == SIZE
    assert held(robots, [request(number, 64) for number in range(2 * SIZE)]) == SIZE // 4
    assert held(robots, [request(number, 6) for number in range(2 * SIZE)]) == SIZE


def test_a_robot_that_is_read_twice_counts_once() -> None:
    robots = RobotCache(Settings(table_cache=SIZE))
    assert held(robots, [request(1, 12)] * 5 * SIZE) == 5 * SIZE
    assert held(robots, [request(number, 6) for number in range(SIZE)]) == SIZE
