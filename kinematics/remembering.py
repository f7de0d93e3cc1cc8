"""What is remembered of what was read and worked out: many short questions, few long ones.

A cache that is bounded in number alone holds a thousand times more once somebody asks for nothing but the
longest that is allowed.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, update_wrapper
from typing import Generic, ParamSpec, TypeVar

_Question = ParamSpec("_Question")
_Answer = TypeVar("_Answer")
USUAL_TABLE = 512
"""Length of the cells of a table [character] that counts as a usual one: three times an arm of six joints."""
USUAL_ROWS = 12
"""Rows of a table that counts as a usual one: twice those of an arm of six joints."""

USUAL_INVARIANTS = 4 * USUAL_ROWS
"""Invariants of such a table, and some."""


class Remembered(Generic[_Question, _Answer]):
    """A function that remembers its latest answers."""

    def __init__(
        self,
        function: Callable[_Question, _Answer],
        length: Callable[_Question, int],
        longest: int,
        most: int,
        few: int,
    ) -> None:
        self._usual, self._long = lru_cache(maxsize=most)(function), lru_cache(maxsize=few)(function)
        self._length, self._longest = length, longest
        update_wrapper(self, function)

    def __call__(self, *question: _Question.args, **named: _Question.kwargs) -> _Answer:
        """Return the answer to a question, of what can be hashed."""
        if self._length(*question, **named) <= self._longest:
            return self._usual(*question, **named)  # type: ignore[arg-type]
        return self._long(*question, **named)  # type: ignore[arg-type]

    def cache_clear(self) -> None:
        """Forget all answers."""
        self._usual.cache_clear()
        self._long.cache_clear()


def remembered(
    length: Callable[_Question, int], *, longest: int, most: int, few: int
) -> Callable[[Callable[_Question, _Answer]], Remembered[_Question, _Answer]]:
    """Return a decorator by which a function remembers its latest answers.

    Args:
        length: of a question, such as its characters or rows; what an answer holds grows with it.
        longest: length of a question that counts as a usual one.
        most: how many usual ones are remembered.
        few: how many longer ones are, so that a request need not work out the same twice.
    """
    return lambda function: Remembered(function, length, longest, most, few)
