"""Why a cell or a table is refused."""

from fractions import Fraction

from kinematics.cells.limits import Limits
from kinematics.errors import Fault, ParamValue


class CellRefusal(Exception):  # noqa: N818 - it becomes a Fault of a CellError where the cell's place is known
    """A cell cannot be read: the code and values of a fault that doesn't know its place yet."""

    def __init__(self, code: str, **params: ParamValue) -> None:
        super().__init__(code)
        self.code, self.params = code, params

    @property
    def column(self) -> int:
        """The character that it is about, counted from 1; 0 if it is about all of the cell."""
        column = self.params.get("column", 0)
        assert isinstance(column, int)
        return column

    def at(self, *where: str | int) -> Fault:
        """Return the fault, at its place."""
        return Fault.at(self.code, *where, **self.params)


def size_refusal(value: Fraction, column: int, limits: Limits) -> CellRefusal:
    """Return the refusal of a number that is larger or smaller in size than what is read."""
    size = "small" if abs(value) < limits.smallest or abs(value) < 1 <= limits.largest else "large"
    return CellRefusal("number_out_of_range", column=column, size=size, largest=limits.largest)
