"""The exercises of some folders and of the package: which there are, and each read once."""

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path

from exercises.consistency import FILE
from exercises.definition import Exercise
from exercises.definition_files import files_of_folder
from exercises.errors import DefinitionError, UnknownExerciseError
from exercises.loader import exercise_of_files
from kinematics.errors import Fault

ROOT = files("exercises") / "definitions"  # The folder of the package.

Shelf = Callable[[str], Exercise | None]
"""Where exercises are that stand in no folder, by an id that nobody finds in a list."""


class Library:
    """The exercises of some folders and of the package; each is read once.

    One of your own goes before a packaged one of its id. What stands in no folder may be on the shelf.
    """

    def __init__(self, folders: Sequence[Path] = (), shelf: Shelf | None = None) -> None:
        self._shelf = shelf
        self._folders: tuple[Traversable, ...] = (*folders, ROOT)
        self._read: dict[str, Exercise] = {}
        self._files: dict[str, Mapping[str, bytes]] = {}
        missing = [folder for folder in folders if not folder.is_dir()]
        if missing:
            raise DefinitionError(Fault.at("folder_missing", folder=str(f)) for f in missing)
        found = (entry for folder in self._folders for entry in folder.iterdir())
        self.ids: tuple[str, ...] = tuple(sorted({e.name for e in found if (e / FILE).is_file()}))

    def exercise(self, exercise_id: str) -> Exercise:
        """Return the exercise of that id.

        Raises:
            UnknownExerciseError: there is none.
            DefinitionError: its folder is malformed.
        """
        if exercise_id not in self._read:
            if exercise_id not in self.ids:
                kept = self._shelf(exercise_id) if self._shelf is not None else None
                if kept is not None:
                    return kept
                raise UnknownExerciseError(
                    Fault.at("exercise_unknown", "exercise_id", id=exercise_id, known=", ".join(self.ids))
                )
            holding = self._holding(exercise_id)
            found = files_of_folder(holding / exercise_id)
            # packaged ones are checked by the tests: to do so again takes half of the time of reading all
            exercise = exercise_of_files(exercise_id, found, is_checked=holding is ROOT)
            self._files[exercise_id] = found
            self._read.setdefault(exercise_id, exercise)  # another thread may have read it meanwhile
        return self._read[exercise_id]

    def files(self, exercise_id: str) -> Mapping[str, bytes] | None:
        """Return the files that an exercise was read from; None where it stands in no folder.

        Raises:
            UnknownExerciseError: there is no such exercise.
            DefinitionError: its folder is malformed.
        """
        self.exercise(exercise_id)
        return self._files.get(exercise_id)

    def take(self, exercise_id: str, files: Mapping[str, bytes]) -> None:
        """Hold an exercise as it was read from some files, whatever stands in its folder now.

        Raises:
            DefinitionError: they are malformed.
        """
        if self._files.get(exercise_id) != files:
            self._read[exercise_id] = exercise_of_files(exercise_id, files, is_checked=True)
            self._files[exercise_id] = files

    def read_own(self) -> None:
        """Read every exercise of the folders now; the packaged ones are known to be well-formed.

        Raises:
            DefinitionError: some are malformed; every fault of every folder.
        """
        faults: list[Fault] = []
        for exercise_id in self.ids:
            try:
                if self._holding(exercise_id) is not ROOT:
                    self.exercise(exercise_id)
            except DefinitionError as error:
                faults += error.faults
        if faults:
            raise DefinitionError(faults)

    def _holding(self, exercise_id: str) -> Traversable:
        """Return the first folder that has the exercise."""
        return next(folder for folder in self._folders if (folder / exercise_id / FILE).is_file())


@cache
def packaged() -> Library:
    """Return the exercises that come with the package."""
    return Library()
