from __future__ import annotations

import json
import sys
import tracemalloc

import orjson
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from service.http.decoding import JsonLimits, decode_json
from service.http.long_lists import PIECE
from service.http.problems import BodyError, BodySizeError
from tests.conftest import EXPLORE

VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(2**53), 2**53)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=20,
)


@settings(max_examples=300 if EXPLORE else 20)
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


def read_lengths(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many bytes the parser was given at a time."""
    found: list[int] = []
    read = orjson.loads

    def noted(document: bytes) -> object:
        found.append(len(document))
        return read(document)

    monkeypatch.setattr("service.http.decoding.orjson.loads", noted)
    return found


BATCH = JsonLimits(lists=240_000, values=3_400_000, long=frozenset({"joints"}))


@pytest.mark.parametrize("joints", [[[0.25, -1, 3e9]] * 50_000, [0.5] * 200_000, [[]] * 100_000])
@pytest.mark.parametrize("last", [{}, {"parameters": {"L1": 1.5, "no]te": "a: [1, 2], {}"}}])
def test_a_long_list_of_numbers_is_read_a_piece_at_a_time(
    joints: list[object], last: dict[str, object], monkeypatch: pytest.MonkeyPatch
) -> None:
    """While a body of 13 MB was read at once, nobody else was served for a quarter of a second."""
    lengths = read_lengths(monkeypatch)
    value = {"robot": "puma560", "joints": joints, **last}
    body = json.dumps(value, separators=(",", ":")).encode()
    assert decode_json(body, BATCH) == value
    assert len(body) > 2 * PIECE
    assert max(lengths) < 1.1 * PIECE


WRITTEN = (
    b'{"robot": "a", "joints": [%b]}',
    b'\xef\xbb\xbf{"joints" : [%b] , "robot": [1]}',
    b'{"x": {"joints": [%b]}, "joints": 1}',
    b'{"x": {"joints": [%b]}}',
    b'{"joints": [%b], "joints": [1]}',
    b'{"joints": [%b], "jo\\u0069nts": [1]}',
    b'{"joints": [%b], "a": 1, "a": 2}',
    b'["joints", [%b]]',
    b'{"a": "joints", "b": [%b]}',
    b'{"joints": [%b]',
    b'{"joints": [%b]]}',
    b'{"joints": [%b] 1}',
    b'{"joints": 1 [%b]}',
)
INSIDE = (
    *(
        b"",
        b"1,2,3,4,5,6",
        b"[1,2],[3,4],[5,6]",
        b"[[1],[2]],[[3],[4]]",
        b"[1,[2],3],4,[5,6]",
        b"1,2,3,",
        b",1,2,3",
    ),
    *(
        b"[1],[2],[3],",
        b"[1],,[2],[3]",
        b"[1],[2]],[[3]",
        b"1,NaN,2,3",
        b"1,[1e999],2",
        b'"a],[b",[1,2]',
        b'{"a":[1]},2',
    ),
    *(b"[1] , [2] ,\n[3]", b"1 , 2", b"01,2,3,4", b"1,2,\xff,3"),
    *(
        b"[1,2,3,4,5,6,7,8,9]",
        b"[1], [2] , [1,2,3,4,5,6,7,8,9] ,[3]",
        b",[1,2,3,4,5,6,7,8,9]",
        b"[1],,[1,2,3,4,5,6,7,8,9]",
        b"[1] [1,2,3,4,5,6,7,8,9]",
        b"[1],[1,2,3,4,,5,6,7,8,9]",
        b"[[1,2,3,4,5,6,7,8,9],[1]]",
        b"[1,2,3,4,5,6,7,8,9] 1,[2]",
    ),
)


@pytest.mark.parametrize("around", WRITTEN)
@pytest.mark.parametrize("piece", [1, 4])
def test_a_body_means_the_same_in_pieces(around: bytes, piece: int, monkeypatch: pytest.MonkeyPatch) -> None:
    bodies = [around % inside for inside in INSIDE]
    whole = list(map(outcome, bodies))
    for module in ("decoding", "long_lists"):
        monkeypatch.setattr(f"service.http.{module}.PIECE", piece)
    for body, expected in zip(bodies, whole, strict=True):
        assert outcome(body) == expected, body


@pytest.mark.parametrize("around", WRITTEN)
def test_a_body_too_long_to_be_read_at_once_means_the_same_or_is_refused_as_such(
    around: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    """While ten megabytes with one text among the numbers were read at once, nobody else was served."""
    bodies = [around % inside for inside in INSIDE]
    whole = list(map(outcome, bodies))
    for module in ("decoding", "long_lists"):
        monkeypatch.setattr(f"service.http.{module}.PIECE", 1)
        monkeypatch.setattr(f"service.http.{module}.AT_ONCE", 0)
    for body, expected in zip(bodies, whole, strict=True):
        monkeypatch.setattr("service.http.decoding.LONGEST_REST", len(body))
        assert outcome(body) in (expected, [("body_too_large", (), {"limit": 0})]), body


def test_a_row_that_is_too_long_is_read_a_piece_at_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = [[0.25], [1] * 500_000, [2]]
    body = json.dumps({"robot": "puma560", "joints": rows}, separators=(",", ":")).encode()
    lengths = read_lengths(monkeypatch)
    assert decode_json(body, BATCH)["joints"] == rows
    assert max(lengths) < 1.1 * PIECE


@pytest.mark.parametrize("place", [0, 100_000, 199_999])
def test_a_long_list_with_one_text_is_read_a_piece_at_a_time(
    place: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    joints: list[list[object]] = [[0.25, -1.5, 3.125, 0.5] for _ in range(200_000)]
    joints[place][2] = "a],[b"
    body = json.dumps({"robot": "puma560", "joints": joints, "base": [[1]]}, separators=(",", ":")).encode()
    lengths = read_lengths(monkeypatch)
    assert decode_json(body, BATCH)["joints"] == joints
    assert max(lengths) < 0.6 * len(body)
    assert sum(length > 1.1 * PIECE for length in lengths) <= 1


def outcome(body: bytes) -> object:
    """What a body means, or what is wrong with it."""
    try:
        return decode_json(body, BATCH)
    except (BodyError, BodySizeError) as error:
        return [(fault.code, fault.where, fault.params) for fault in error.faults]


@given(VALUES, st.sampled_from([b'{"a": %b, "a": 1}', b'[{"b": {"a": 1, "a": %b}}]']))
def test_a_repeated_key_is_refused_beside_anything(value: object, around: bytes) -> None:
    with pytest.raises(BodyError) as refused:
        decode_json(around % json.dumps(value).encode())
    assert refused.value.faults[0].code == "json_duplicate_key"


def test_a_body_whose_fields_are_all_found_is_not_written_to_find_a_repeated_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """That took longer than to read it."""
    body = json.dumps({"chain": {"joints": [[0, 0, 1, 0, 0, "q1"]] * 10_000}}).encode()
    monkeypatch.setattr("service.http.decoding.orjson.dumps", None)
    assert len(decode_json(body)["chain"]["joints"]) == 10_000
