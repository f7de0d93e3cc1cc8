from __future__ import annotations

import io

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from service.http.npy import npy_data, npy_header, read_npy
from service.http.problems import BodyError
from tests.service.test_bad_input import saved


def with_header(text: str, data: bytes = b"", version: tuple[int, int] = (1, 0)) -> bytes:
    size = 2 if version == (1, 0) else 4
    header = text.encode()
    return b"\x93NUMPY" + bytes(version) + len(header).to_bytes(size, "little") + header + data


def code_of(body: bytes) -> str:
    with pytest.raises(BodyError) as refusal:
        read_npy(body)
    return refusal.value.faults[0].code


@given(
    arrays.arrays(
        st.sampled_from(["<f8", ">f8", "<f4", ">f4", "<f2", "<i4", ">i8", "u1", "<u2"]),
        arrays.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=4),
    ),
    st.sampled_from("CF"),
)
def test_every_array_of_numbers_is_read(array: np.ndarray, order: str) -> None:
    read = read_npy(saved(np.asarray(array, order=order)))
    assert read.dtype == np.float64
    assert read.flags.c_contiguous
    np.testing.assert_array_equal(read, array.astype(np.float64))


@given(arrays.arrays(np.float64, arrays.array_shapes(max_dims=3, max_side=4)))
def test_what_is_written_numpy_reads(array: np.ndarray) -> None:
    written = npy_header(array.shape) + npy_data(array)
    np.testing.assert_array_equal(np.load(io.BytesIO(written)), array)


def test_pickled_objects_are_refused_unread() -> None:
    assert code_of(saved(np.array([{"a": 1}], dtype=object), allow_pickle=True)) == "npy_object_refused"


@pytest.mark.parametrize(
    "array", [np.ones(2, complex), np.array(["a"]), np.array([True]), np.zeros(2, "f8,i4")]
)
def test_other_types_are_refused(array: np.ndarray) -> None:
    assert code_of(saved(array)) == "npy_type_unsupported"


GOOD = saved(np.ones((2, 3)))
NOT_FINISHED = "{'descr': '<f8', 'fortran_order': False, 'shape': "


@pytest.mark.parametrize(
    ("body", "code"),
    [
        (b"", "npy_header_invalid"),
        (b"PK\x03\x04 a zip file", "npy_header_invalid"),
        (b"\x93NUMPY", "npy_header_invalid"),
        (b"\x93NUMPY\x01\x00\xff\xff", "npy_header_invalid"),
        (GOOD[:60], "npy_header_invalid"),
        (GOOD[:-1], "npy_length_mismatch"),
        (GOOD + b"\0", "npy_length_mismatch"),
        (with_header(NOT_FINISHED + "(10**12,)}"), "npy_header_invalid"),
        (with_header(NOT_FINISHED + "(1000000000000, 6)}"), "npy_length_mismatch"),
        (with_header(NOT_FINISHED + "(-1, 6)}"), "npy_header_invalid"),
        (with_header(NOT_FINISHED + "(True, 6)}", b"\0" * 48), "npy_header_invalid"),
        (with_header(NOT_FINISHED + "6}"), "npy_header_invalid"),
        (with_header(NOT_FINISHED + "(0, " + "9" * 30 + ")}"), "npy_header_invalid"),
        (with_header(NOT_FINISHED + "(0, 2305843009213693952, 6)}"), "npy_header_invalid"),
        (with_header(NOT_FINISHED + "(" + "1," * 100 + ")}", b"\0" * 8), "npy_header_invalid"),
        (with_header(NOT_FINISHED + "(0x" + "F" * 4000 + ", 6)}"), "npy_header_invalid"),
        (with_header("{'descr': '<f8', 'fortran_order': 0, 'shape': (1,)}", b"\0" * 8), "npy_header_invalid"),
        (with_header("{'descr': '<f8', 'fortran_order': False}"), "npy_header_invalid"),
        (with_header("__import__('os').abort()"), "npy_header_invalid"),
        (with_header("(" * 3000), "npy_header_invalid"),
        (
            with_header("{'descr': '|O', 'fortran_order': False, 'shape': (1,)}", b"cos\nsystem\n"),
            "npy_object_refused",
        ),
        (with_header("{'descr': '<f9', 'fortran_order': False, 'shape': (1,)}"), "npy_header_invalid"),
        (with_header("{'descr': ['<f8'], 'fortran_order': False, 'shape': (1,)}"), "npy_header_invalid"),
        (with_header(NOT_FINISHED + "(1,)}", b"\0" * 8, version=(9, 9)), "npy_header_invalid"),
        (with_header(" " * 5000 + NOT_FINISHED + "(1,)}", b"\0" * 8, version=(2, 0)), "npy_header_invalid"),
    ],
)
def test_lying_and_broken_files_are_refused(body: bytes, code: str) -> None:
    assert code_of(body) == code


@pytest.mark.parametrize("version", [(1, 0), (2, 0), (3, 0)])
def test_every_version_of_the_format_is_read(version: tuple[int, int]) -> None:
    body = with_header(NOT_FINISHED + "(1,)}", np.array([7.0]).tobytes(), version)
    assert read_npy(body).tolist() == [7.0]
