"""Arrays as `application/x-npy`: numpy's own file format, read without trust.

numpy reads the header, which is bounded, and says shape and type; they are held against the bytes that are
there before an array is made of them, and objects are never unpickled. Format: numpy.lib.format, versions
1.0 to 3.0.
"""

import io
import math
import sys
import tokenize

import numpy as np
from numpy.lib import format as npy_format
from numpy.typing import NDArray

from kinematics.errors import Fault
from service.http.problems import BodyError

_LONGEST_HEADER = 4096  # Bytes; what `numpy.save` writes of an array of numbers has 118.
_UNREADABLE = (
    *(ValueError, TypeError, SyntaxError, OverflowError, MemoryError, RecursionError),
    *(tokenize.TokenError, UserWarning),  # met where numpy tries a header as Python 2 wrote it
)
_READERS = {
    (1, 0): npy_format.read_array_header_1_0,
    (2, 0): npy_format.read_array_header_2_0,
    (
        3,
        0,
    ): npy_format.read_array_header_2_0,  # 3.0 differs in the names of fields, which numbers have none of
}


def read_npy(body: bytes) -> NDArray[np.float64]:
    """Return the array in an npy file, as native float64 in C order.

    Integers and floats of every size and byte order are read, in C and in Fortran order.

    Raises:
        BodyError: not an npy file; a type that is not a number; a header whose shape is not that of the data.
    """
    shape, fortran, dtype, start = _header(body)
    if dtype.hasobject:
        raise BodyError(Fault.at("npy_object_refused"))
    if dtype.kind not in "fiu":
        raise BodyError(Fault.at("npy_type_unsupported", type=str(dtype)[:40]))
    promised, present = math.prod(shape) * dtype.itemsize, len(body) - start
    if promised != present:
        raise BodyError(Fault.at("npy_length_mismatch", promised=promised, present=present))
    flat = np.frombuffer(body, dtype=dtype, offset=start)
    try:
        array = flat.reshape(shape, order="F" if fortran else "C")
    except (ValueError, OverflowError):  # no data, because one size is 0; and another is absurd
        raise _invalid("shape") from None
    return np.ascontiguousarray(array, dtype=np.float64).reshape(shape)


def npy_header(shape: tuple[int, ...]) -> bytes:
    """Return the header of an npy file of little-endian float64 in C order; the data follows it."""
    stream = io.BytesIO()
    npy_format.write_array_header_1_0(stream, {"descr": "<f8", "fortran_order": False, "shape": shape})
    return stream.getvalue()


def npy_data(array: NDArray[np.float64]) -> memoryview:
    """Return the data of an npy file of little-endian float64 in C order, copied only if it is not so."""
    return np.ascontiguousarray(array, dtype="<f8").reshape(-1).view(np.uint8).data


def _header(body: bytes) -> tuple[tuple[int, ...], bool, np.dtype[np.generic], int]:
    """Return the shape, whether the order is Fortran's, the type, and where the data begins."""
    stream = io.BytesIO(body)
    try:
        version = npy_format.read_magic(stream)
    except ValueError:
        raise _invalid("magic") from None
    reader = _READERS.get(version)
    if reader is None:
        raise _invalid("version")
    try:
        shape, fortran, dtype = reader(stream, max_header_size=_LONGEST_HEADER)
    except _UNREADABLE:
        raise _invalid("header") from None
    if any(type(size) is not int or not 0 <= size <= sys.maxsize for size in shape):
        raise _invalid("shape")
    return shape, fortran, dtype, stream.tell()


def _invalid(rule: str) -> BodyError:
    return BodyError(Fault.at("npy_header_invalid", rule=rule))
