"""A least-recently-used cache with separate bounds for short and for long arguments.

A cache that is bounded in number alone holds a thousand times more once somebody asks for nothing but the
longest that is allowed.
"""

from collections.abc import Callable
from functools import lru_cache, update_wrapper
from typing import Generic, ParamSpec, TypeVar

_Question = ParamSpec("_Question")
_Answer = TypeVar("_Answer")
USUAL_TABLE = 512
"""Length of the cells of a table [character] that counts as a usual one: three times an arm of six joints."""
USUAL_ROWS = 12  # Rows of a table that counts as a usual one: twice those of an arm of six joints.

USUAL_INVARIANTS = 4 * USUAL_ROWS  # Invariants of such a table, and some.


class SizedCache(Generic[_Question, _Answer]):
    """A function whose latest results are cached."""

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
        """Return the result for hashable arguments."""
        if self._length(*question, **named) <= self._longest:
            return self._usual(*question, **named)  # type: ignore[arg-type]
        return self._long(*question, **named)  # type: ignore[arg-type]

    def cache_clear(self) -> None:
        """Empty the cache."""
        self._usual.cache_clear()
        self._long.cache_clear()


def cached_by_size(
    length: Callable[_Question, int], *, longest: int, most: int, few: int
) -> Callable[[Callable[_Question, _Answer]], SizedCache[_Question, _Answer]]:
    """Return a decorator that caches the latest results of a function.

    Args:
        length: of the arguments, such as their characters or rows; the size of a result grows with it.
        longest: up to this length the arguments count as short.
        most: how many results for short arguments are cached.
        few: how many for longer ones, so that one request need not compute the same twice.
    """
    return lambda function: SizedCache(function, length, longest, most, few)
