"""Arrays as `application/x-npy`: numpy's own file format, read without trust.

The header is a Python literal; it is checked here before a byte of data is touched, and objects are never
unpickled. Format: numpy.lib.format, versions 1.0 to 3.0.
"""

from __future__ import annotations

import ast
import io
import math
import re
from typing import Any

import numpy as np
from numpy.lib import format as npy_format
from numpy.typing import NDArray

from kinematics.errors import Fault
from service.http.problems import BodyError

_MAGIC = b"\x93NUMPY"
_LENGTH_BYTES = {(1, 0): 2, (2, 0): 4, (3, 0): 4}
_LONGEST_HEADER = 4096
_MOST_DIMENSIONS = 32
_LARGEST_SIZE = 2**63 - 1
_NUMBER = re.compile(r"[<>|=]?(f[248]|[iu][1248])")
_OBJECT = re.compile(r"[<>|=]?O\d*")
_RULES = {
    "magic": "it must begin with \\x93NUMPY, a version and the length of the header",
    "version": "its version must be 1.0, 2.0 or 3.0",
    "length": f"its header must be complete, and at most {_LONGEST_HEADER} bytes long",
    "literal": "its header must be a dictionary written in Python",
    "keys": "its header must name descr, fortran_order and shape",
    "order": "fortran_order must be True or False",
    "shape": "its shape must be a tuple of sizes that an array can have",
}
_KEYS = {"descr", "fortran_order", "shape"}


def read_npy(body: bytes) -> NDArray[np.float64]:
    """The array in an npy file, as native float64 in C order.

    Integers and floats of every size and byte order are read, in C and in Fortran order.

    Raises:
        BodyError: not an npy file; a type that is not a number; a header whose shape is not that of the data.
    """
    header, start = _header(body)
    dtype = _dtype(header["descr"])
    shape = _shape(header["shape"])
    if type(header["fortran_order"]) is not bool:
        raise _invalid("order")
    promised, present = math.prod(shape) * dtype.itemsize, len(body) - start
    if promised != present:
        raise BodyError(
            Fault(
                code="npy_length_mismatch",
                params={"promised": promised, "present": present},
            )
        )
    flat = np.frombuffer(body, dtype=dtype, offset=start)
    try:
        array = flat.reshape(shape, order="F" if header["fortran_order"] else "C")
    except ValueError:  # no data, because one size is 0; and another is absurd
        raise _invalid("shape") from None
    return np.ascontiguousarray(array, dtype=np.float64).reshape(shape)


def npy_header(shape: tuple[int, ...]) -> bytes:
    """The header of an npy file of little-endian float64 in C order; the data follows it."""
    stream = io.BytesIO()
    npy_format.write_array_header_1_0(stream, {"descr": "<f8", "fortran_order": False, "shape": shape})
    return stream.getvalue()


def npy_data(array: NDArray[np.float64]) -> memoryview:
    """The data of an npy file of little-endian float64 in C order, copied only if it is not that already."""
    flat = np.ascontiguousarray(array, dtype="<f8").reshape(-1)
    return flat.view(np.uint8).data


def _header(body: bytes) -> tuple[dict[str, Any], int]:
    if not body.startswith(_MAGIC) or len(body) < 10:
        raise _invalid("magic")
    version = (body[6], body[7])
    size = _LENGTH_BYTES.get(version)
    if size is None:
        raise _invalid("version")
    length = int.from_bytes(body[8 : 8 + size], "little")
    start = 8 + size + length
    if length > _LONGEST_HEADER or start > len(body):
        raise _invalid("length")
    try:
        header = ast.literal_eval(body[8 + size : start].decode("utf-8").strip())
    except (ValueError, SyntaxError, TypeError, MemoryError, RecursionError):
        raise _invalid("literal") from None
    if not isinstance(header, dict) or set(header) != _KEYS:
        raise _invalid("keys")
    return header, start


def _dtype(description: object) -> np.dtype[Any]:
    if isinstance(description, str) and _NUMBER.fullmatch(description):
        return np.dtype(description)
    if isinstance(description, str) and _OBJECT.fullmatch(description):
        raise BodyError(
            Fault(
                code="npy_object_refused",
            )
        )
    shown = str(description)[:40]
    raise BodyError(
        Fault(
            code="npy_type_unsupported",
            params={"type": shown},
        )
    )


def _shape(shape: object) -> tuple[int, ...]:
    if not isinstance(shape, tuple) or len(shape) > _MOST_DIMENSIONS:
        raise _invalid("shape")
    if not all(type(size) is int and 0 <= size <= _LARGEST_SIZE for size in shape):
        raise _invalid("shape")
    return shape


def _invalid(rule: str) -> BodyError:
    return BodyError(
        Fault(
            code="npy_header_invalid",
            params={"rule": rule},
        )
    )
