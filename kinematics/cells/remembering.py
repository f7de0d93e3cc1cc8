"""What is remembered of cells that were read: many short questions, few long ones.

A cache that is bounded in number alone holds a thousand times more once somebody asks for nothing but the
longest that is allowed.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, wraps
from typing import ParamSpec, TypeVar

_Question = ParamSpec("_Question")
_Answer = TypeVar("_Answer")
USUAL_TABLE = 512
"""Length of the cells of a table [character] that counts as a usual one: three times an arm of six joints."""


def remembered(
    length: Callable[_Question, int], *, longest: int, most: int, few: int
) -> Callable[[Callable[_Question, _Answer]], Callable[_Question, _Answer]]:
    """Return a decorator by which a function remembers its latest answers.

    Args:
        length: of a question [character]; what an answer holds is in proportion to it.
        longest: length of a question that counts as a usual one [character].
        most: how many usual ones are remembered.
        few: how many longer ones are, so that a request need not work out the same twice.
    """

    def decorated(function: Callable[_Question, _Answer]) -> Callable[_Question, _Answer]:
        usual, long = lru_cache(maxsize=most)(function), lru_cache(maxsize=few)(function)

        @wraps(function)
        def answer(*question: _Question.args, **named: _Question.kwargs) -> _Answer:
            if length(*question, **named) <= longest:
                return usual(*question, **named)  # type: ignore[arg-type]  # of what can be hashed
            return long(*question, **named)  # type: ignore[arg-type]

        return answer

    return decorated
