"""Matrices of expressions as text, LaTeX, MathML, trees and functions in programming languages."""

from kinematics.printing.formats import LIMIT, SOURCES, Format, MatrixPrinter
from kinematics.printing.notation import Notation
from kinematics.printing.program import Purpose
from kinematics.printing.trees import from_tree, to_tree

__all__ = ["LIMIT", "SOURCES", "Format", "MatrixPrinter", "Notation", "Purpose", "from_tree", "to_tree"]
