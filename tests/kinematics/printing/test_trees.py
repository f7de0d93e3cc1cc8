"""Expression trees: plain data, and back."""

import json
import random
from fractions import Fraction

import pytest

from kinematics.expressions import Function, JointVariable, Parameter, add, call, multiply, number, power
from kinematics.printing.notation import Names
from kinematics.printing.trees import TreeWriter
from tests.kinematics.printing.tree_reader import from_tree
from tests.kinematics.symbolic.rewriting import random_expression


@pytest.mark.parametrize("seed", range(60))
def test_a_tree_survives_json(seed: int) -> None:
    expression = random_expression(random.Random(seed))
    assert from_tree(json.loads(json.dumps(TreeWriter(Names()).written(expression)))) == expression


def test_the_shape() -> None:
    expression = multiply((number("-1/3"), Parameter("L1"), power(call(Function.COS, JointVariable(2)), 2)))
    assert TreeWriter(Names()).written(expression) == {
        "type": "product",
        "factors": [
            {"type": "number", "value": "-1/3"},
            {"type": "parameter", "name": "L1"},
            {
                "type": "power",
                "base": {
                    "type": "call",
                    "function": "cos",
                    "arguments": [{"type": "variable", "name": "q2", "index": 2}],
                },
                "exponent": "2",
            },
        ],
    }
    assert TreeWriter(Names()).written(number("0.4318")) == {"type": "number", "value": "0.4318"}
    assert from_tree({"type": "number", "value": "0.25"}) == number(Fraction(1, 4))


def test_what_occurs_twice_is_one_object() -> None:
    shared = add((Parameter("a"), Parameter("b")))
    tree = TreeWriter(Names()).written(multiply((shared, shared)))
    assert tree["factors"][0] is tree["factors"][1]
