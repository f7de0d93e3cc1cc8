"""DH tables as a notebook shows them: HTML with MathML, and LaTeX."""

from collections.abc import Callable, Sequence
from xml.sax.saxutils import escape

from kinematics.expressions import Expression, JointVariable, add, negate
from kinematics.printing.latex import LatexWriter
from kinematics.printing.mathml import MathmlWriter
from kinematics.printing.notation import Names
from kinematics.table import COLUMNS, VARIABLE_CELLS, Convention, DHRow, DHTable, JointType

_LETTERS = {"theta": ("θ", r"\theta"), "d": ("d", "d"), "a": ("a", "a"), "alpha": ("α", r"\alpha")}
_DIGITS = ".6g"  # Enough to recognise a number; the table itself keeps all digits.


def table_html(table: DHTable[Expression] | DHTable[float], variables: Sequence[str] = ()) -> str:
    """Return a table as an HTML table: one row a link, angles in radians."""
    columns = COLUMNS[table.convention]
    indices = _indices(table.convention)
    heads = "".join(f"<th>{_LETTERS[column][0]}<sub>{indices[column]}</sub></th>" for column in columns)
    writer = MathmlWriter(Names(variables=variables))
    rows = _written(table, lambda entry: f"<math>{writer.text(entry)}</math>")
    body = "".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in rows)
    caption = f"<caption>{escape(table.convention.value)}, rad</caption>"
    return f"<table>{caption}<thead><tr><th>i</th>{heads}</tr></thead><tbody>{body}</tbody></table>"


def table_latex(table: DHTable[Expression] | DHTable[float], variables: Sequence[str] = ()) -> str:
    """Return a table as a LaTeX array between dollar signs, angles in radians."""
    columns = COLUMNS[table.convention]
    indices = _indices(table.convention)
    heads = " & ".join(["i", *(f"{_LETTERS[column][1]}_{{{indices[column]}}}" for column in columns)])
    rows = [" & ".join(row) for row in _written(table, LatexWriter(Names(variables=variables)).text)]
    lines = " \\\\\n".join([heads + r" \\ \hline" + "\n" + rows[0], *rows[1:]] if rows else [heads])
    return f"$\\displaystyle\n\\begin{{array}}{{c|cccc}}\n{lines}\n\\end{{array}}$"


def _indices(convention: Convention) -> dict[str, str]:
    """In a modified table a and alpha belong to the link before."""
    behind = "i-1" if convention is Convention.MODIFIED else "i"
    return {"theta": "i", "d": "i", "a": behind, "alpha": behind}


def _written(
    table: DHTable[Expression] | DHTable[float], write: Callable[[Expression], str]
) -> list[list[str]]:
    """Row by row its number and its cells; the joint variable stands before its offset."""
    rows, joint = [], 0
    lines: Sequence[DHRow[Expression] | DHRow[float]] = table.rows
    for i, row in enumerate(lines, 1):
        joint += row.joint is not JointType.FIXED
        rows.append([str(i), *(_cell(row, column, joint, write) for column in COLUMNS[table.convention])])
    return rows


def _cell(
    row: DHRow[Expression] | DHRow[float], column: str, joint: int, write: Callable[[Expression], str]
) -> str:
    entry: Expression | float = getattr(row, column)
    moves = VARIABLE_CELLS.get(row.joint) == column
    variable: Expression = JointVariable(joint)
    if row.sign < 0:
        variable = negate(variable)
    if isinstance(entry, float | int):
        number = format(entry, _DIGITS)
        if not moves:
            return number
        return write(variable) if not entry else f"{write(variable)}{'' if entry < 0 else '+'}{number}"
    return write(add((variable, entry)) if moves else entry)
