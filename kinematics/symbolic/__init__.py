"""Closed forms of DH tables: matrices as a lecturer writes them, and exact decisions about them.

`closed_form` and `differential` write matrices to be read; `canonical` gives every function one normal form;
`identity` proves that two tables are the same robot. All work on the expression trees of
`kinematics.expressions`, which `to_sympy` and `from_sympy` exchange with SymPy.
"""

from kinematics.symbolic.canonical import (
    Canonical,
    CanonicalMatrix,
    canonical,
    canonical_transform,
    compare,
    same_function,
)
from kinematics.symbolic.closed_form import ClosedForm, Workings, closed_form, inverse, jacobian
from kinematics.symbolic.identity import Proof, prove_identity
from kinematics.symbolic.interchange import from_sympy, to_sympy
from kinematics.symbolic.proof_status import ProofStatus
from kinematics.symbolic.size import count_operations
from kinematics.symbolic.writing import Matrix

__all__ = [
    "Canonical",
    "CanonicalMatrix",
    "ClosedForm",
    "Matrix",
    "Proof",
    "ProofStatus",
    "Workings",
    "canonical",
    "canonical_transform",
    "closed_form",
    "compare",
    "count_operations",
    "from_sympy",
    "inverse",
    "jacobian",
    "prove_identity",
    "same_function",
    "to_sympy",
]
