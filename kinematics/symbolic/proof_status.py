"""The three answers to a question about functions."""

from __future__ import annotations

from enum import StrEnum


class ProofStatus(StrEnum):
    """What is known of an identity.

    PROVED: it holds for all joint and parameter values. REFUTED: it does not. UNDECIDED: it was not proved,
    and the entries hold what has no unique normal form (a square root of lengths, an arctangent), or their
    expansion is too large.
    """

    PROVED = "proved"
    REFUTED = "refuted"
    UNDECIDED = "undecided"
