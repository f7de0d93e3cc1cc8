"""The parts of an exercise: how an answer to each is read and judged.

Fixed verbs, as in PrairieLearn: `generate` (exercises.instance) draws a student's values, `parse`
(exercises.answers) reads what was handed in or refuses it without costing an attempt, `grade` judges it.
"""
