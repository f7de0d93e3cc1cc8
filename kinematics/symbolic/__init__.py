"""Closed forms of DH tables: matrices as a lecturer writes them, and exact decisions about them.

Matrices to be read, nested as people nest them:
  motions           a table as elementary motions about and along x and z
  runs              motions merged: angles of parallel axes add up
  angles            sums of joint variables and constants, their cosines and sines
  nested, terms     sums of products that stay nested
  writing           vectors and poses, from the end of a chain to its beginning
  closed_form       link matrices, frames and ⁰T_N
  differential      columns of Jacobians
  analytic          the Jacobian of three angles
  shortening        entries of any matrix in a short form
Decisions, in a ring in which every function has one normal form:
  elements, ring    symbols, monomials, forms, and their arithmetic
  key_layout        the exponents of a term in one integer
  roots, surds      roots of unity and of numbers
  form_reader       from expressions to forms
  canonical         the normal form, and equality of functions
  poses             rigid motions with entries in the ring
  identity          proof that two tables are the same robot
  determinants      where a Jacobian loses rank
  polynomials, quotients  functions as polynomials, and as quotients
Beside them:
  exact_poses       numbers from outside as exact entries
  size              how large an expression is
  interchange       to SymPy and back

All work on the expression trees of `kinematics.expressions`. The method is explained in docs/symbolic.md.
"""

from kinematics.symbolic.canonical import Canonical, ProofStatus, canonical, compare, same_function
from kinematics.symbolic.closed_form import ClosedForm, Workings, closed_form, inverse, jacobian
from kinematics.symbolic.identity import Proof, prove_identity
from kinematics.symbolic.interchange import from_sympy, to_sympy
from kinematics.symbolic.size import count_operations
from kinematics.symbolic.writing import Matrix
