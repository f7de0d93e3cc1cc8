"""Closed forms of DH tables: matrices as a lecturer writes them, and exact decisions about them.

`identity` proves that two tables are the same robot; `canonical` gives every function one normal form;
`closed_form`, `differential` write matrices to be read. All work on the expression trees of
`kinematics.expressions`; no computer algebra system is involved.
"""

from kinematics.symbolic.identity import Proof, Verdict, prove_identity

__all__ = ["Proof", "Verdict", "prove_identity"]
