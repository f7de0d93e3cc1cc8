"""How each programming language spells an expression, and which words it keeps for itself."""

from __future__ import annotations

import keyword
from dataclasses import dataclass
from fractions import Fraction

from kinematics.expressions import Function
from kinematics.printing.infix import Spelling, infix_power
from kinematics.printing.writer import Binding, Written

_COMMON = {function: function.value for function in Function}
_PYTHON = _COMMON | {Function.ABS: "abs"}
_NUMPY = {function: f"np.{function.value}" for function in Function} | {
    Function.ASIN: "np.arcsin",
    Function.ACOS: "np.arccos",
    Function.ATAN: "np.arctan",
    Function.ATAN2: "np.arctan2",
}
_C = _COMMON | {Function.ABS: "fabs"}
_JAVASCRIPT = {function: f"Math.{function.value}" for function in Function}

_C_WORDS = """
auto break case char const continue default do double else enum extern float for goto if inline int long
register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
alignas alignof bool constexpr false nullptr static_assert thread_local true typeof typeof_unqual asm
and and_eq bitand bitor catch class compl const_cast delete dynamic_cast explicit export friend mutable
namespace new not not_eq operator or or_eq private protected public reinterpret_cast static_cast template
this throw try typeid typename using virtual wchar_t xor xor_eq
linux unix main NULL NAN INFINITY HUGE_VAL HUGE_VALF HUGE_VALL EOF FILE errno signgam math_errhandling
isnan isinf isfinite isnormal signbit fpclassify double_t float_t
M_E M_LOG2E M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2 MAXFLOAT
DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS X_TLOSS FP_NAN FP_INFINITE FP_ZERO FP_SUBNORMAL FP_NORMAL
acos asin atan atan2 cos sin tan acosh asinh atanh cosh sinh tanh exp exp2 exp10 expm1 log log10 log1p log2
logb ilogb pow sqrt cbrt hypot fabs floor ceil fmod remainder remquo round rint lrint llrint lround llround
nearbyint trunc fmin fmax fdim fma frexp ldexp modf scalb scalbn scalbln copysign nan nextafter nexttoward
erf erfc lgamma tgamma gamma lgamma_r drem significand finite isinff isnanf sincos pow10
j0 j1 jn y0 y1 yn abs labs div exit free
"""
_MATLAB_WORDS = """
break case catch classdef continue else elseif end for function global if otherwise parfor persistent return
spmd switch try while endfunction endif endfor endwhile end_try_catch unwind_protect do until
pi i j e eps Inf NaN NA inf nan ans sin cos tan asin acos atan atan2 abs sqrt numel assert zeros
arguments properties methods events enumeration import isargout nargin nargout varargin varargout
"""
_JAVASCRIPT_WORDS = """
break case catch class const continue debugger default delete do else enum export extends false finally for
function if import in instanceof new null return super switch this throw true try typeof var void while with
yield let static implements interface package private protected public await async of get set eval arguments
undefined NaN Infinity Math Object Array Number RangeError Symbol
"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Language:
    """A programming language.

    Attributes:
        reserved: words that no identifier may be: keywords, and names that the written code relies on.
        spelling: how expressions are written.
    """

    reserved: frozenset[str]
    spelling: Spelling


def _c_power(base: str, factor: str, exponent: Fraction) -> Written:
    if exponent == 2:
        return Written(f"({factor}*{factor})", Binding.ATOM)
    written = f"{exponent.numerator}.0" + (f"/{exponent.denominator}.0" if exponent.denominator != 1 else "")
    return Written(f"pow({base}, {written})", Binding.ATOM)


def _javascript_power(base: str, _: str, exponent: Fraction) -> Written:
    return Written(f"Math.pow({base}, {exponent})", Binding.ATOM)


PYTHON = Language(
    reserved=frozenset([*keyword.kwlist, *keyword.softkwlist, *_PYTHON.values(), "pi", "len", "ValueError"]),
    spelling=Spelling(functions=_PYTHON, variable=lambda joint: f"q[{joint - 1}]", power=infix_power("**")),
)
NUMPY = Language(
    reserved=frozenset([*keyword.kwlist, *keyword.softkwlist, "np", "float", "ValueError"]),
    spelling=Spelling(
        pi="np.pi",
        functions=_NUMPY,
        variable=lambda joint: f"q[..., {joint - 1}]",
        power=infix_power("**"),
    ),
)
C = Language(
    reserved=frozenset(_C_WORDS.split()),
    spelling=Spelling(
        pi="3.14159265358979323846",
        whole="{}.0".format,
        functions=_C,
        variable=lambda joint: f"q[{joint - 1}]",
        power=_c_power,
    ),
)
MATLAB = Language(
    reserved=frozenset(_MATLAB_WORDS.split()),
    spelling=Spelling(functions=_COMMON, variable="q({})".format, power=infix_power("^")),
)
JAVASCRIPT = Language(
    reserved=frozenset(_JAVASCRIPT_WORDS.split()),
    spelling=Spelling(
        pi="Math.PI",
        functions=_JAVASCRIPT,
        variable=lambda joint: f"q[{joint - 1}]",
        power=_javascript_power,
    ),
)
