"""Which mistake a seed plants, and where."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeVar

from exercises.draws import Picker
from exercises.errors import ExerciseError
from exercises.instance import seed_text
from kinematics.errors import Fault, TableError
from service.http.problems import RequestError

Way = TypeVar("Way")


def chosen_mistake(
    call: str, seed: str | None, ways: Mapping[str, Sequence[Way]], field: str
) -> tuple[str, Way]:
    """Return a mistake and the place where it is planted, the same for the same seed for ever.

    Args:
        call: what asks for it; a seed plants something else for every call.
        seed: names a student or a try.
        ways: by code of a mistake where it can be planted.
        field: of the request, where nothing can be planted.

    Raises:
        RequestError: the seed is too long.
        TableError: there is no way.
    """
    try:
        picker = Picker(exercise_id=call, seed=seed_text(seed))
    except ExerciseError as error:
        raise RequestError(error.faults) from None
    if not ways:
        raise TableError(Fault.at("not_plantable", field))
    code = picker.choice(tuple(ways), "mistake")
    return code, picker.choice(ways[code], "place")
