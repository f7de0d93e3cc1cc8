"""Expression trees as plain data, for JSON."""

from typing import Any, TypeAlias

from kinematics.expressions import Call, JointVariable, Number, Parameter, Pi, Power, Product, Sum
from kinematics.printing.numbers import decimal_text
from kinematics.printing.writer import Writer

Tree: TypeAlias = dict[str, Any]


class TreeWriter(Writer[Tree]):
    """Writes expressions as nested dictionaries, each with a `type`.

    number (value: "1/2" or "0.4318"), pi, parameter (name), variable (name q1, index), sum (terms),
    product (factors), power (base, exponent: "2" or "1/2") and call (function, arguments). What occurs twice
    is one and the same dictionary.
    """

    def _write(self, number: int) -> Tree:
        below = [self._written[child] for child in self.ledger.below[number]]
        match self.ledger.nodes[number]:
            case Product():
                return {"type": "product", "factors": below}
            case Sum():
                return {"type": "sum", "terms": below}
            case Call(function, _):
                return {"type": "call", "function": function.value, "arguments": below}
            case Number(value):
                return {"type": "number", "value": decimal_text(value) or str(value)}
            case Parameter(name):
                return {"type": "parameter", "name": name}
            case JointVariable(index):
                return {"type": "variable", "name": self._names.variable(index), "index": index}
            case Pi():
                return {"type": "pi"}
            case Power(_, exponent):
                return {"type": "power", "base": below[0], "exponent": str(exponent)}
