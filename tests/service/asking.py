"""A call that is to be answered."""

from typing import Any

import httpx


def answered(client: httpx.Client, path: str, body: dict[str, Any]) -> Any:
    """What the service answers, which it must."""
    response = client.post(path, json=body)
    assert response.status_code == 200, response.text
    return response.json()
