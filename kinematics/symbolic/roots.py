"""Roots of unity, written in one basis that holds in every cyclotomic field.

A root of unity e^(2πi·r) is named by its turn r in ℚ/ℤ. Over ℚ the only relations between roots of unity
come from primes: for each prime p the p turns r, r + 1/p, …, r + (p-1)/p sum to zero. Splitting r into its
parts of prime-power denominator and removing, in every such coset, the turn whose p-part lies in
[(p-1)/p, 1) leaves a basis. It does not depend on the field that the computation happens to live in, so a
number has one normal form whatever it is compared with.

Source: W. Bosma, Canonical bases for cyclotomic fields, AAECC 1 (1990), 125-134, whose bases have the same
property.
"""

from fractions import Fraction
from functools import lru_cache
from math import isqrt

LARGEST_PRIME = 31
"""Relations are used for primes up to this; a turn with a larger prime in its denominator stays as it is."""

_TRIAL_BOUND = 10_000  # Primes that are tried: numbers below its square are factored surely.


@lru_cache(maxsize=4096)
def basis_terms(turn: Fraction) -> tuple[tuple[Fraction, int], ...]:
    """Return the root of unity e^(2πi·turn) in the basis.

    It is a sum of pairs of a turn in [0, 1) and an integer coefficient.
    """
    terms = {Fraction(0): 1}
    for prime, part in _prime_parts(turn):
        reduced = _reduce_part(prime, part)
        terms = {
            (turn_so_far + piece) % 1: weight * sign
            for turn_so_far, weight in terms.items()
            for piece, sign in reduced
        }
    return tuple(terms.items())


@lru_cache(maxsize=65536)
def basis_steps(step: int, order: int) -> tuple[tuple[Fraction, int], ...]:
    """Return the same for e^(2πi·step/order)."""
    return basis_terms(Fraction(step, order))


def has_large_prime(turn: Fraction) -> bool:
    """Return whether the turn's denominator has a prime whose relation is not used."""
    return any(prime > LARGEST_PRIME for prime, _ in _prime_parts(turn))


@lru_cache(maxsize=256)
def square_root_of_prime(prime: int) -> tuple[tuple[Fraction, int], ...]:
    """Return √prime as a sum of roots of unity, for a prime up to `LARGEST_PRIME`.

    √2 = ζ_8 + ζ_8^(-1). For an odd prime the Gauss sum Σ (k/p) ζ_p^k is √p if p ≡ 1
    and i·√p if p ≡ 3 (mod 4).
    """
    if prime == 2:
        return ((Fraction(1, 8), 1), (Fraction(7, 8), 1))
    quarter = Fraction(1 - prime % 4, 8)  # back if p ≡ 3, else none
    squares = {k * k % prime for k in range(1, prime)}
    return tuple((Fraction(k, prime) + quarter, 1 if k in squares else -1) for k in range(1, prime))


def square_free(number: int) -> tuple[int, tuple[int, ...], bool]:
    """Return a positive integer as root² · (product of distinct primes).

    Returns:
        The root, the primes, and whether they are certainly distinct primes: a cofactor too large for trial
        division is returned as if it were one.
    """
    root, primes = 1, []
    candidate = 2
    while candidate * candidate <= number and candidate <= _TRIAL_BOUND:
        exponent = 0
        while number % candidate == 0:
            number //= candidate
            exponent += 1
        root *= candidate ** (exponent // 2)
        if exponent % 2:
            primes.append(candidate)
        candidate += 1 if candidate == 2 else 2
    certain = number <= _TRIAL_BOUND**2
    if number > 1:
        exact = isqrt(number)
        if exact * exact == number:
            return root * exact, tuple(primes), True
        primes.append(number)
    return root, tuple(primes), certain


@lru_cache(maxsize=4096)
def _prime_parts(turn: Fraction) -> tuple[tuple[int, Fraction], ...]:
    """The turn as a sum of fractions in [0, 1) whose denominators are powers of different primes."""
    denominator = turn.denominator
    parts = []
    for prime, size in _prime_powers(denominator):
        cofactor = denominator // size
        numerator = turn.numerator * pow(cofactor, -1, size) % size
        parts.append((prime, Fraction(numerator, size)))
    return tuple(parts)


def _prime_powers(number: int) -> list[tuple[int, int]]:
    powers = []
    candidate = 2
    while number > 1:
        if candidate * candidate > number or candidate > _TRIAL_BOUND:
            candidate = number
        size = 1
        while number % candidate == 0:
            number //= candidate
            size *= candidate
        if size != 1:
            powers.append((candidate, size))
        candidate += 1
    return powers


def _reduce_part(prime: int, part: Fraction) -> list[tuple[Fraction, int]]:
    if prime > LARGEST_PRIME or part < Fraction(prime - 1, prime):
        return [(part, 1)]
    return [(part - Fraction(step, prime), -1) for step in range(1, prime)]
