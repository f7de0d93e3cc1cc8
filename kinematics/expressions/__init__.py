"""Exact expressions: what a cell of a DH table holds and what a closed form is made of.

An expression is an immutable tree. The constructors `add`, `multiply`, `power` and `call` fold what is exact
(rational numbers, rational multiples of π, nested sums and products) and leave the rest as written, so a
lecturer's `L1*cos(alpha)` stays what it is. Angles are in radians: a degree never gets this far.
"""

from kinematics.expressions.trees import (
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Parameter,
    Pi,
    Power,
    Product,
    Sum,
    add,
    call,
    multiply,
    negate,
    number,
    pi_fraction,
    pi_times,
    power,
    rational_root,
    rational_value,
    split_weight,
    terms_of,
    with_parts,
)
from kinematics.expressions.values import evaluate, evaluate_each, joint_variables_in, parameters_in, walk
