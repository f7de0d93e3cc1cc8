"""The exercises of the package, at hand."""

from exercises.loader import packaged

exercise = packaged().exercise
exercise_ids = packaged().ids
