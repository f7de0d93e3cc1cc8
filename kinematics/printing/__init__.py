"""Matrices of expressions as text, LaTeX, MathML, trees and functions in five programming languages."""

from kinematics.printing.formats import LIMIT, Format, MatrixPrinter
from kinematics.printing.notation import Notation
from kinematics.printing.program import Purpose
from kinematics.printing.trees import from_tree, to_tree

__all__ = ["LIMIT", "Format", "MatrixPrinter", "Notation", "Purpose", "from_tree", "to_tree"]
