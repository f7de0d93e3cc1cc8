"""What must hold between the pieces of a definition: figure and robot, statements and names, points."""

from collections.abc import Iterator

from exercises.definition import Exercise
from exercises.drawings import end_marks
from exercises.errors import DefinitionError
from exercises.figures.geometry import build_scene
from exercises.grading import ToolRule, ZeroRule
from exercises.needs import rules_that_need, unmet_needs
from exercises.parts.registry import part_type
from exercises.statements import names_in
from kinematics.cells import parameters_in_radians
from kinematics.cells.variables import variable_index
from kinematics.errors import Fault

FILE = "exercise.toml"


def inconsistencies(exercise: Exercise) -> Iterator[Fault]:
    """Yield what does not fit together, each at (file, key, …)."""
    yield from _figure_faults(exercise)
    yield from _name_faults(exercise)
    yield from _alias_faults(exercise)
    yield from _part_faults(exercise)
    for i in unmet_needs(exercise):
        name = exercise.needs[i]
        rules = "; ".join(rules_that_need(exercise, name)) or "none"
        yield Fault.at("need_unmet", FILE, "needs", i, name=name, rules=rules)


def _figure_faults(exercise: Exercise) -> list[Fault]:
    """What keeps the figure from being drawn, as it is and as it is drawn."""
    values = parameters_in_radians(exercise.usual_values, exercise.reference.parameters, exercise.angle_unit)
    unknown = [name for name in exercise.figure.lengths if name not in values]
    if unknown:
        return [Fault.at("parameter_unused", FILE, "figure", "lengths", name, name=name) for name in unknown]
    for drawn in (False, True):
        try:
            build_scene(exercise.figure, exercise.reference.table, values, signed_axes=False, drawn=drawn)
        except DefinitionError as error:
            return [fault.within(FILE, "figure") for fault in error.faults]
    if exercise.policy.zero is ZeroRule.FIGURE and any(exercise.figure.posture):
        return [Fault.at("posture_not_zero", FILE, "figure", "posture")]
    if exercise.policy.tool is ToolRule.POINT and not end_marks(exercise):
        last = len(exercise.reference.table.rows)
        return [Fault.at("tool_point_unmarked", FILE, "figure", "marks", last=last)]
    return []


def _name_faults(exercise: Exercise) -> list[Fault]:
    """Names in statements that stand neither in the table nor in the figure nor among a part's weights."""
    table = exercise.reference.table
    known = {parameter.name for parameter in exercise.parameters} | set(exercise.figure.marks)
    known |= {mark.name for mark in exercise.figure.dimensions}
    known |= {weight.name for part in exercise.parts for weight in getattr(part, "weights", ())}
    known |= {f"q{joint}" for joint in range(1, table.n_joints + 1)}
    known |= {f"{axis}{frame}" for axis in "xyz" for frame in range(len(table.rows) + 1)}
    return [
        Fault.at("statement_name_unknown", f"statement.{language}.md", name=name)
        for language, text in exercise.statements.items()
        for name in sorted(names_in(text) - known)
    ]


def _alias_faults(exercise: Exercise) -> Iterator[Fault]:
    """Yield other names of dimensions that are joint variables in a cell, and never mean the dimension."""
    for dimension in dict.fromkeys(exercise.aliases.values()):
        for i, alias in enumerate(name for name, own in exercise.aliases.items() if own == dimension):
            if variable_index(alias) is not None:
                yield Fault.at("alias_taken", FILE, "parameters", dimension, "aliases", i, name=alias)


def _part_faults(exercise: Exercise) -> Iterator[Fault]:
    """Yield what parts ask for and the exercise lacks."""
    for i, part in enumerate(exercise.parts):
        kind = part_type(part.kind)
        if any(exercise.part(other) is not None for other in kind.gives_away):
            yield Fault.at("key_given_away", FILE, "parts", i, "kind")
        for fault in kind.inconsistencies(part, exercise):
            yield fault.within(FILE, "parts", i)
