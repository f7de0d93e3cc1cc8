from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from service.http.decoding import decode_json
from service.http.problems import BodyError

VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(2**53), 2**53)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=20,
)


@given(VALUES)
def test_what_json_writes_is_read_back(value: object) -> None:
    assert decode_json(json.dumps(value).encode()) == value
    assert decode_json(json.dumps(value, ensure_ascii=False).encode()) == value


@pytest.mark.parametrize(
    ("body", "code"),
    [
        (b"", "body_missing"),
        (b"  \n ", "body_missing"),
        (b"{", "json_invalid"),
        (b"{'a': 1}", "json_invalid"),
        (b'{"a": 1,}', "json_invalid"),
        (b'{"a": 01}', "json_invalid"),
        (b"\x00", "json_invalid"),
        (b'{"a": NaN}', "json_not_finite"),
        (b'{"a": -Infinity}', "json_not_finite"),
        (b"[1, Infinity]", "json_not_finite"),
        (b"[1e999]", "json_not_finite"),
        (b'"\xff\xfe"', "json_not_utf8"),
        (b"[" * 100_000, "json_too_deep"),
        (b'{"a":' * 100_000, "json_too_deep"),
        (b"[" * 300 + b"]" * 300, "json_too_deep"),
        (b"[" * 300 + b'"\\n"' + b"]" * 300, "json_too_deep"),
        (b"[" * 1000 + b'"\\n"' + b"]" * 1000, "json_too_deep"),
        (b'{"a":' * 300 + b"1" + b"}" * 300, "json_too_deep"),
        ("{}".encode("utf-16"), "json_not_utf8"),
        (b'{"a": 1, "a": 1}', "json_duplicate_key"),
        (b'{"x": {"a\\n": 1, "a\\n": 1}}', "json_duplicate_key"),
    ],
)
def test_what_is_not_strict_json_is_refused(body: bytes, code: str) -> None:
    with pytest.raises(BodyError) as refusal:
        decode_json(body)
    assert refusal.value.faults[0].code == code


def test_a_repeated_key_is_named_with_its_place() -> None:
    with pytest.raises(BodyError) as refusal:
        decode_json(b'{"table": {"rows": [{"a": 1}, {"a": 2, "d": 0, "a": 3}]}}')
    assert [fault.where for fault in refusal.value.faults] == [("table", "rows", 1, "a")]


def test_a_byte_order_mark_is_ignored() -> None:
    assert decode_json(b'\xef\xbb\xbf{"a": 1}') == {"a": 1}


def test_integers_of_any_length_are_numbers() -> None:
    assert decode_json(b"1" + b"0" * 300) == 1e300
