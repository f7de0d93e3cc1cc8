"""Matrices of expressions as text, LaTeX, MathML, trees and functions in programming languages.

formats         one matrix in every format
equation_lists  equations one after another
entries         a matrix entry by entry, with named intermediates
notation        short and full: c23 or cos(q2 + q3)
numbers, symbols  how a number is written, and the name of a parameter
ledger, writer  what all writers share: each node is met once
text            on one line, as the cell grammar reads it
latex           LaTeX
mathml, content  MathML to be drawn, and what it means
trees           plain data, for JSON
program         a function: SymPy finds what is repeated
language, words  what a programming language is, and the words it reserves
languages       each of them
table_markup    DH tables in notebooks
"""

from kinematics.printing.formats import LIMIT, SOURCES, Format, MatrixPrinter
from kinematics.printing.notation import Notation
from kinematics.printing.program import Purpose
