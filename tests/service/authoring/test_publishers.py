"""Who may publish: what each value of the setting lets through, and what it says to everybody else."""

from pathlib import Path
from typing import Any

import httpx
import pytest
from pydantic import ValidationError

from service.http.api_keys import KeyFile, KeyScope
from service.settings import Publishers, Settings
from tests.examples import DRAFT
from tests.live_service import running

PATIENCE = 120.0


def published(origin: str, **fields: str) -> tuple[int, Any]:
    answer = httpx.post(
        f"{origin}/api/v1/author/publish", json={"draft": DRAFT}, headers=fields, timeout=PATIENCE
    )
    body = answer.json()
    return answer.status_code, body.get("code") or body["id"].rpartition("-")[0]


def shown(origin: str) -> str:
    page = httpx.get(f"{origin}/author", timeout=PATIENCE).text
    return page.partition('data-publishing="')[2].partition('"')[0]


def test_anyone_publishes_unless_the_operator_says_otherwise(tmp_path: Path) -> None:
    with running(Settings(storage="on", data_folder=tmp_path, symbolic_seconds=60.0)) as origin:
        assert published(origin) == (200, DRAFT["id"])
        assert shown(origin) == "anyone"


@pytest.mark.parametrize("who", [Publishers.STAFF, Publishers.KEY, Publishers.NOBODY])
def test_visitors_students_and_programs_are_told_who_may(tmp_path: Path, who: Publishers) -> None:
    keys = tmp_path / "keys.json"
    _, publishing = KeyFile(keys).add((KeyScope.PUBLISH,))
    _, grading = KeyFile(keys).add((KeyScope.GRADE, KeyScope.COMPUTE))
    settings = Settings(
        storage="on", data_folder=tmp_path, symbolic_seconds=60.0, publishing=who, api_keys=keys
    )
    with running(settings) as origin:
        page = {"Sec-Fetch-Site": "same-origin"}
        assert published(origin, **page) == (403, "publishing_closed")
        assert published(origin) == (401, "api_key_missing")
        assert published(origin, Authorization="Bearer of nothing", **page) == (
            (401, "session_expired") if who is Publishers.STAFF else (403, "publishing_closed")
        )
        assert published(origin, **{"X-API-Key": grading}) == (403, "api_key_scope")
        expected = (403, "publishing_closed") if who is Publishers.NOBODY else (200, DRAFT["id"])
        assert published(origin, Authorization=f"Bearer {publishing}") == expected
        assert shown(origin) == who.value


def test_keys_alone_need_a_file_of_keys() -> None:
    with pytest.raises(ValidationError, match="FRAMEWISE_API_KEYS"):
        Settings(publishing=Publishers.KEY)
