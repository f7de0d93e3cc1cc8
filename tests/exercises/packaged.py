"""The exercises of the package, at hand."""

from exercises.library import packaged

exercise = packaged().exercise
exercise_ids = packaged().ids
table_ids = tuple(found for found in exercise_ids if exercise(found).part("table") is not None)
"""Those that ask for the table of a robot of the documents; the others ask for something else about one."""
