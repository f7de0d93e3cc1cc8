"""What the identifiers of a language must not be, besides what SymPy's printers know."""

C = """
asm typeof main unix linux NULL NAN INFINITY EOF FILE I errno signgam double_t float_t MAXFLOAT
HUGE_VAL HUGE_VALF HUGE_VALL isnan isinf isfinite isnormal signbit fpclassify math_errhandling
M_E M_LOG2E M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2
DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS X_TLOSS FP_NAN FP_INFINITE FP_ZERO FP_SUBNORMAL FP_NORMAL
acosh asinh atanh cosh sinh tanh exp exp2 exp10 expm1 log log10 log1p log2 logb ilogb pow cbrt hypot fabs
floor ceil fmod remainder remquo round rint lrint llrint lround llround nearbyint trunc fmin fmax fdim fma
frexp ldexp modf scalb scalbn scalbln copysign nan nextafter nexttoward erf erfc lgamma tgamma gamma lgamma_r
drem significand finite isinff isnanf sincos pow10 j0 j1 jn y0 y1 yn labs div exit free
constexpr nullptr static_assert thread_local bool true false alignas alignof typeof_unqual
"""
"""Besides the keywords: macros, and functions of the standard headers, which compilers know by name."""
CPP = """
catch register char8_t concept consteval constinit co_await co_return co_yield requires
"""
"""What SymPy's list of the keywords of C++17 lacks, and those of C++20."""
MATLAB = """
break case catch classdef continue else elseif end for function global if otherwise parfor persistent return
spmd switch try while endfunction endif endfor endwhile end_try_catch unwind_protect do until
pi i j I J e eps Inf NaN NA inf nan ans numel assert zeros max min
arguments properties methods events enumeration import isargout nargin nargout varargin varargout
"""
JAVASCRIPT = """
break case catch class const continue debugger default delete do else enum export extends false finally for
function if import in instanceof new null return super switch this throw true try typeof var void while with
yield let static implements interface package private protected public await async of get set eval arguments
undefined NaN Infinity Math Object Array Number RangeError Symbol
"""
JULIA = """
baremodule begin break catch const continue do else elseif end export false finally for function global if
import in isa let local macro module quote return struct true try using while where outer abstract mutable
primitive type pi im length throw zeros cbrt max min DimensionMismatch
"""
FORTRAN = """
call do double else end function if implicit in integer intent kind none out parameter real result return
subroutine then while
"""
RUST = "None Some Ok Err async await dyn gen union f64 std"
