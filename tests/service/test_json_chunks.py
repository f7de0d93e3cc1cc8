from __future__ import annotations

import json

import numpy as np
import pytest

from service.wire.json_chunks import ROWS, blocks, list_chunks, member_chunks


@pytest.mark.parametrize("rows", [0, 1, ROWS - 1, ROWS, ROWS + 1, 2 * ROWS + 3])
@pytest.mark.parametrize("width", [(), (3,), (2, 2)])
def test_pieces_make_the_list_of_the_whole_array(rows: int, width: tuple[int, ...]) -> None:
    array = np.arange(float(rows * int(np.prod(width)))).reshape(rows, *width)
    pieces = list(list_chunks(array))
    assert json.loads(b"".join(pieces)) == array.tolist()
    assert len(pieces) == 2 + len(list(blocks(rows, ROWS)))


def test_members_may_be_anything_that_an_answer_holds() -> None:
    answer = {
        "unit": "rad",
        "rank": np.array([6, 5]),
        "singular": np.array([False, True]),
        "twist": {"condition": np.array([1.5, np.inf]), "reversed": np.zeros((2, 3))[:, ::-1]},
        "nothing": {},
        "length": np.array(2.0),
    }
    assert json.loads(b"{" + b"".join(member_chunks(answer)) + b"}") == {
        "unit": "rad",
        "rank": [6, 5],
        "singular": [False, True],
        "twist": {"condition": [1.5, None], "reversed": [[0.0] * 3] * 2},
        "nothing": {},
        "length": 2.0,
    }
