"""Links in a plane, with names for all that they weigh, and their equations as text."""

from kinematics.dynamics import Derivation, RigidBody, SymbolicBody
from kinematics.expressions import ZERO, Parameter, add, negate
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.symbolic import Matrix
from kinematics.table import Convention, DHRow, DHTable, JointType, SymbolicTable

P = Parameter
__all__ = ["DOWN", "Derivation", "planar", "written"]


def planar(joints: int) -> tuple[SymbolicTable, tuple[SymbolicBody, ...]]:
    """Links in a plane: lengths L, centres at r from each joint, moments I about them."""
    rows = tuple(
        DHRow(joint=JointType.REVOLUTE, theta=ZERO, d=ZERO, a=P(f"L{i}"), alpha=ZERO)
        for i in range(1, joints + 1)
    )
    links = tuple(
        RigidBody(
            mass=P(f"m{i}"),
            centre=(add((P(f"r{i}"), negate(P(f"L{i}")))), ZERO, ZERO),
            inertia=((ZERO,) * 3, (ZERO,) * 3, (ZERO, ZERO, P(f"I{i}"))),
        )
        for i in range(1, joints + 1)
    )
    return DHTable(convention=Convention.STANDARD, rows=rows), links


DOWN = (ZERO, negate(P("g")), ZERO)


def written(matrix: Matrix, joints: int) -> list[list[str]]:
    names = [f"{word}{i}" for word in ("m", "L", "r", "I", "dq") for i in range(1, joints + 1)]
    printer = MatrixPrinter(n_joints=joints, parameters=(*names, "g"), notation=Notation.SHORT)
    text = printer.write(matrix, [Format.TEXT], Purpose(name="M", meaning="M.", result="M"))["text"]
    assert isinstance(text, list)
    return text
