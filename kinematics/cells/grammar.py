"""The grammar of a cell: from its tokens to its syntax tree.

The parser is LALR(1), so neither depth nor length of what it is given can exhaust the stack. It builds the
tree while it reads; sums and products come out flat.

    sum      = product { ("+" | "-") product }
    product  = signed { ("*" | "/") signed }
    signed   = ["-" | "+"] signed | run
    run      = power { power }                 an implicit product, which binds more tightly than "*"
    power    = marked ["^" exponent | superscript]
    marked   = atom ["°"]
"""

from collections.abc import Iterable
from fractions import Fraction
from functools import cache
from typing import Any

from lark import Lark, Token, Transformer, UnexpectedToken, v_args

from kinematics.caching import cached_by_size
from kinematics.cells.limits import Limits
from kinematics.cells.refusals import CellRefusal
from kinematics.cells.scanner import scan
from kinematics.cells.syntax import (
    Addition,
    Application,
    Degrees,
    HalfTurn,
    Literal,
    Multiplication,
    Name,
    Negation,
    Node,
    Parenthesized,
    Raised,
    Reciprocal,
    names_in,
)
from kinematics.expressions import Function

_GRAMMAR = r"""
?start: sum
?sum: product | sum PLUS product -> plus | sum MINUS product -> minus
?product: signed | product STAR signed -> times | product SLASH signed -> over
?signed: run | MINUS signed -> negative | PLUS signed -> positive
?run: power | run power -> beside
?power: marked | marked POW exponent -> raised | marked SUPERSCRIPT -> superscript
?exponent: power | MINUS exponent -> negative | PLUS exponent -> positive
?marked: atom | atom DEGREE -> degrees
?atom: NUMBER -> number | NAME -> name | PI -> half_turn | ROOT atom -> root
     | LPAR sum RPAR -> group | LBRACE sum RBRACE -> braced
     | RADIANS LPAR sum RPAR -> radians
     | FUNCTION LPAR arguments RPAR -> application
     | FUNCTION LBRACE sum RBRACE -> command
     | FRACTION LBRACE sum RBRACE LBRACE sum RBRACE -> fraction
arguments: sum (COMMA sum)*
%declare NUMBER NAME PI ROOT RADIANS FUNCTION FRACTION PLUS MINUS STAR SLASH POW SUPERSCRIPT DEGREE
%declare LPAR RPAR LBRACE RBRACE COMMA
"""


LARGEST_EXPONENT = 400  # More than any double has: the range proper is checked with the value.


def _deepest(nodes: Iterable[Node]) -> int:
    return max(node.depth for node in nodes)


def _column(token: Token) -> int:
    return token.column or 1


@v_args(inline=True)
class _Builder(Transformer[Token, Node]):
    def number(self, token: Token) -> Node:
        mantissa, _, exponent = token.lower().partition("e")
        if exponent and abs(int(exponent)) > LARGEST_EXPONENT:
            exponent = f"{LARGEST_EXPONENT if int(exponent) > 0 else -LARGEST_EXPONENT}"
        value = Fraction(mantissa.rstrip(".") or "0") * Fraction(10) ** int(exponent or 0)
        return Literal(column=_column(token), value=value)

    def name(self, token: Token) -> Node:
        return Name(column=_column(token), name=str(token))

    def half_turn(self, token: Token) -> Node:
        return HalfTurn(column=_column(token))

    def plus(self, left: Node, _: Token, right: Node) -> Node:
        terms = (*(left.terms if isinstance(left, Addition) else (left,)), right)
        return Addition(column=left.column, depth=_deepest(terms), terms=terms)

    def minus(self, left: Node, sign: Token, right: Node) -> Node:
        return self.plus(left, sign, Negation(column=_column(sign), depth=right.depth, operand=right))

    def times(self, left: Node, _: Token, right: Node) -> Node:
        factors = (*(left.factors if isinstance(left, Multiplication) else (left,)), right)
        return Multiplication(column=left.column, depth=_deepest(factors), factors=factors)

    def over(self, left: Node, sign: Token, right: Node) -> Node:
        divisor = right
        while isinstance(divisor, Negation):
            divisor = divisor.operand
        if isinstance(divisor, Multiplication):
            raise CellRefusal("division_ambiguous", column=_column(sign))
        return self.times(left, sign, Reciprocal(column=_column(sign), depth=right.depth, operand=right))

    def beside(self, left: Node, right: Node) -> Node:
        first = right.operand if isinstance(right, Raised | Degrees) else right
        if isinstance(first, Literal):
            raise CellRefusal("number_after_value", column=first.column)
        factors = (*(left.factors if isinstance(left, Multiplication) else (left,)), right)
        return Multiplication(column=left.column, depth=_deepest(factors), factors=factors)

    def negative(self, sign: Token, operand: Node) -> Node:
        return Negation(column=_column(sign), depth=operand.depth + 1, operand=operand)

    def positive(self, sign: Token, operand: Node) -> Node:
        return Parenthesized(column=_column(sign), depth=operand.depth + 1, operand=operand)

    def raised(self, base: Node, _: Token, exponent: Node) -> Node:
        power = _power_of_ten(base, exponent)
        if power is not None:
            return Literal(column=base.column, value=power)
        depth = _deepest((base, exponent)) + 1
        return Raised(column=base.column, depth=depth, operand=base, exponent=exponent)

    def superscript(self, base: Node, token: Token) -> Node:
        return self.raised(base, token, Literal(column=_column(token), value=Fraction(str(token))))

    def group(self, opening: Token, value: Node, _: Token) -> Node:
        return Parenthesized(column=_column(opening), depth=value.depth + 1, operand=value)

    def braced(self, opening: Token, value: Node, closing: Token) -> Node:
        # a number stays one: L{1} is no product
        return value if isinstance(value, Literal) else self.group(opening, value, closing)

    def degrees(self, operand: Node, _: Token) -> Node:
        return Degrees(column=operand.column, depth=operand.depth, operand=operand)

    def radians(self, name: Token, _: Token, operand: Node, __: Token) -> Node:
        group = Parenthesized(column=_column(name), depth=operand.depth + 1, operand=operand)
        return self.degrees(group, name)

    def root(self, sign: Token, operand: Node) -> Node:
        return Application(
            column=_column(sign), depth=operand.depth + 1, function=Function.SQRT, arguments=(operand,)
        )

    def arguments(self, *parts: Node | Token) -> tuple[Node, ...]:
        return tuple(part for part in parts if isinstance(part, Node))

    def application(self, name: Token, _: Token, arguments: tuple[Node, ...], __: Token) -> Node:
        function = Function(str(name))
        expected = 2 if function is Function.ATAN2 else 1
        if len(arguments) != expected:
            raise CellRefusal(
                "function_arity",
                column=_column(name),
                name=str(name),
                expected=expected,
                given=len(arguments),
            )
        depth = _deepest(arguments) + 1
        return Application(column=_column(name), depth=depth, function=function, arguments=arguments)

    def command(self, name: Token, opening: Token, argument: Node, closing: Token) -> Node:
        return self.application(name, opening, (argument,), closing)

    def fraction(
        self, command: Token, _: Token, top: Node, __: Token, ___: Token, bottom: Node, ____: Token
    ) -> Node:
        divisor = Reciprocal(column=bottom.column, depth=bottom.depth, operand=bottom)
        product = Multiplication(
            column=_column(command), depth=_deepest((top, bottom)) + 1, factors=(top, divisor)
        )
        return Parenthesized(column=product.column, depth=product.depth, operand=product)


def _power_of_ten(base: Node, exponent: Node) -> Fraction | None:
    """The value of 10^-33 as in 1.3*10^-33: a way to write an exponent, whatever powers may be computed."""
    if not isinstance(base, Literal) or base.value != 10:
        return None
    sign = 1
    while isinstance(exponent, Negation | Parenthesized):
        sign, exponent = -sign if isinstance(exponent, Negation) else sign, exponent.operand
    if (
        not isinstance(exponent, Literal)
        or exponent.value.denominator != 1
        or exponent.value > LARGEST_EXPONENT
    ):
        return None
    return Fraction(10) ** (sign * exponent.value.numerator)


@cache
def _parser() -> Lark:
    """Return the parser; a twentieth of a second goes into its tables, and plain numbers need none."""
    return Lark(_GRAMMAR, parser="lalr", lexer="basic", transformer=_Builder())


@cached_by_size(lambda text, limits: len(text), longest=40, most=8192, few=256)
def parse(text: str, limits: Limits) -> Node:
    """Return the syntax tree of a cell.

    Raises:
        CellRefusal: the text is not a cell, or passes a limit.
    """
    tokens = scan(text, limits)
    parser = _parser().parse_interactive("")
    try:
        for token in tokens:
            parser.feed_token(token)
        node: Any = parser.feed_token(Token.new_borrow_pos("$END", "", tokens[-1]))
    except UnexpectedToken as error:
        raise _refusal(error.token, tokens) from None
    assert isinstance(node, Node)
    if node.depth > limits.cell_depth:
        raise CellRefusal("cell_too_deep", column=node.column, limit=limits.cell_depth)
    names = dict.fromkeys(name.name for name in names_in(node))
    if len(names) > limits.cell_symbols:
        raise CellRefusal("cell_too_many_symbols", column=node.column, limit=limits.cell_symbols)
    return node


def _refusal(token: Token, tokens: list[Token]) -> CellRefusal:
    column = _column(token)
    opened = _open_brackets(tokens, token)
    if token.type == "$END" and all(each.type == "MINUS" for each in tokens):
        return CellRefusal("cell_dash")
    if token.type == "$END":
        if opened and tokens[-1].type not in {
            "PLUS",
            "MINUS",
            "STAR",
            "SLASH",
            "POW",
            "COMMA",
            "LPAR",
            "LBRACE",
        }:
            return CellRefusal("parenthesis_not_closed", column=_column(opened[-1]))
        return CellRefusal("cell_incomplete", column=_column(tokens[-1]) + len(tokens[-1]))
    if token.type == "COMMA":
        return _comma_refusal(token, tokens)
    if token.type in {"RPAR", "RBRACE"}:
        code = "value_missing" if opened else "parenthesis_not_opened"
        return CellRefusal(code, column=column, **({"symbol": str(token)} if opened else {}))
    if token.type in {"STAR", "SLASH", "POW"}:
        return CellRefusal("value_missing", column=column, symbol=str(token))
    return CellRefusal("symbol_misplaced", column=column, symbol=str(token))


def _open_brackets(tokens: list[Token], until: Token) -> list[Token]:
    opened: list[Token] = []
    for token in tokens:
        if token is until:
            break
        if token.type in {"LPAR", "LBRACE"}:
            opened.append(token)
        elif token.type in {"RPAR", "RBRACE"} and opened:
            opened.pop()
    return opened


_BEFORE_A_VALUE = {"COMMA", "PLUS", "MINUS", "STAR", "SLASH", "LPAR"}
"""What stands before a number that begins with its comma: an operator, or nothing but the comma itself."""


def _comma_refusal(comma: Token, tokens: list[Token]) -> CellRefusal:
    index = next(i for i, token in enumerate(tokens) if token is comma)
    around = tokens[max(index - 1, 0) : index + 2]
    if len(around) == 3 and around[0].type == around[2].type == "NUMBER":
        if "." in around[0] + around[2]:
            return CellRefusal("number_malformed", column=_column(around[0]), text=f"{around[0]},{around[2]}")
        return CellRefusal("decimal_comma", column=_column(comma), suggestion=f"{around[0]}.{around[2]}")
    if around[-1].type == "NUMBER" and around[-1].isdecimal() and around[0].type in _BEFORE_A_VALUE:
        return CellRefusal("decimal_comma", column=_column(comma), suggestion=f"0.{around[-1]}")
    return CellRefusal("comma_misplaced", column=_column(comma))
