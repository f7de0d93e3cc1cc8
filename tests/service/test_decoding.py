from __future__ import annotations

import json
import sys
import tracemalloc

import pytest
from hypothesis import given
from hypothesis import strategies as st

from service.http.decoding import JsonLimits, decode_json
from service.http.problems import BodyError, BodySizeError

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


def test_a_repeated_key_beside_a_list_too_deep_for_pythons_reader_is_told() -> None:
    """It raised: what the long fields hold is only walked, and may be as deep as orjson nests."""
    body = b'{"a": 1, "a": 2, "joints": ' + b"[" * 1000 + b"]" * 1000 + b"}"
    with pytest.raises(BodyError) as refusal:
        decode_json(body, JsonLimits(long=frozenset({"joints"})))
    assert [fault.code for fault in refusal.value.faults] == ["json_duplicate_key"]


@pytest.mark.parametrize(
    ("items", "places"),
    [(b"NaN, [1, {}, 2e999], -Infinity", [(0,), (1, 2), (2,)]), (b'{}, {"a": 1, "a": {}}', [(1, "a")])],
)
def test_places_in_a_deep_body_of_many_lists_are_found_in_little_memory(
    items: bytes, places: list[tuple[str | int, ...]]
) -> None:
    """They took 8 kB a list, a quarter of a gigabyte in all."""
    body = b"[" * 200 + items + b", []" * 10_000 + b"]" * 200
    tracemalloc.start()
    with pytest.raises(BodyError) as refusal:
        decode_json(body)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert [fault.where for fault in refusal.value.faults] == [(0,) * 199 + place for place in places]
    assert most < 10 * 1024 * 1024


def test_a_byte_order_mark_is_ignored() -> None:
    assert decode_json(b'\xef\xbb\xbf{"a": 1}') == {"a": 1}


def test_integers_of_any_length_are_numbers() -> None:
    assert decode_json(b"1" + b"0" * 300) == 1e300


def test_many_lists_are_not_walked_where_there_are_few_fields() -> None:
    """That took the event loop ten times as long as to read them."""
    body = b'{"rows": [' + b"[0], " * 10_000 + b"[0]]}"
    calls = 0

    def count(_frame: object, event: str, _argument: object) -> None:
        nonlocal calls
        calls += event == "call"

    sys.setprofile(count)
    try:
        decode_json(body)
    finally:
        sys.setprofile(None)
    assert calls < 100


@pytest.mark.parametrize("between", ["", ", ", " \n:"])
def test_an_object_of_more_fields_than_any_call_knows_is_refused(between: str) -> None:
    most = JsonLimits().fields
    for number in (most, most + 1):
        body = json.dumps([{"a": [{f"{i}{between}": i for i in range(number)}]}]).encode()
        if number <= most:
            decode_json(body)
            continue
        with pytest.raises(BodySizeError) as refused:
            decode_json(body)
        assert refused.value.faults[0].params == {"given": number, "limit": most}


@pytest.mark.parametrize("fields", [1, 500])
def test_a_body_of_more_fields_than_a_class_hands_in_is_refused_before_it_is_read(
    fields: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """To read 100 000 fields with names of their own took the event loop 20 ms each time."""
    one = json.dumps({f"k{i}": 0 for i in range(fields)}).encode()
    limits = JsonLimits(objects=10**6, values=10**6, colons=40_000)
    decode_json(b"[" + one + (b"," + one) * (limits.colons // fields - 1) + b"]", limits)
    monkeypatch.setattr("service.http.decoding.orjson", None)
    with pytest.raises(BodySizeError) as refused:
        decode_json(b"[" + one + (b"," + one) * (limits.colons // fields) + b"]", limits)
    assert refused.value.faults[0].params == {"limit": limits.colons}
    with pytest.raises(BodySizeError):
        decode_json(json.dumps({f"k{i}": i for i in range(100_000)}).encode())
