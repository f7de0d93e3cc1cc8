"""`framewise warm`: draw, test and write down beforehand what a course or an exercise will be asked for."""

import argparse
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from courses.links.course_links import links_of_course
from courses.model import LinkSettings
from exercises.access import MOST_VARIANTS
from exercises.definition import Exercise
from exercises.instance import generate, variant_seeds
from exercises.selftest.checks import check_values
from exercises.written_table import written_table
from kinematics.errors import Fault, KinematicsError
from kinematics.printing import SOURCES, Notation
from service.cli.commands import FAILED
from service.cli.environment import Subparsers, count_up_to, settings_of_environment
from service.http.problems import NotFoundError, RequestError
from service.messages import languages, sentence
from service.resources import Resources
from service.routes.kinematics.symbolic import SymbolicRequest, symbolic_task
from service.settings import Settings
from service.wire.exercises.figure_files import packed_figure
from service.wire.kinematics.symbolic_forms import written_answer
from service.wire.kinematics.symbolic_tasks import form_address

MISTAKES = 0
"""A variant is tested by right answers, by wrong parts and by its figure. How well mistakes are explained
is tested by `framewise exercises check`."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Prepared:
    """What is prepared of an exercise: its values, by seeds, and the languages of its figures."""

    exercise: Exercise
    seeds: tuple[str | None, ...]
    languages: tuple[str, ...]


def add(subparsers: Subparsers) -> None:
    """Declare `warm`."""
    parser = subparsers.add_parser(
        "warm", help="prepare an exam: draw figures, test variants, write closed forms"
    )
    parser.add_argument("what", help="id of an exercise, or title or number of a course")
    parser.add_argument(
        "--variants",
        type=count_up_to(MOST_VARIANTS, "variants are shared out"),
        help="variants of an exercise that sets no number of them itself; not for a course",
    )
    parser.add_argument("--untested", action="store_true", help="draw only: the variants were tested before")
    parser.set_defaults(run=_warm)


def _warm(options: argparse.Namespace) -> int:
    settings = settings_of_environment()
    resources = Resources(settings)
    try:
        found = list(_asked(resources, options.what, options.variants))
        return max([_prepare(resources, settings, each, options) for each in found], default=0)
    finally:
        resources.closed_forms.write_down()
        resources.figures.write_down()
        resources.close()


def _asked(resources: Resources, what: str, variants: int | None) -> Iterator[Prepared]:
    """An exercise by its id, else every link of the courses that are called so."""
    if what in resources.exercises.ids:
        exercise = resources.exercises.exercise(what)
        if variants is not None and exercise.access.variants not in (None, variants):
            raise RequestError(Fault.at("variants_set", name=what))
        yield _of(exercise, variants, None)
        return
    links = links_of_course(resources.courses.store, what) if resources.courses is not None else []
    if not links:
        raise NotFoundError(Fault.at("nothing_to_warm", name=what))
    if variants is not None:
        raise RequestError(Fault.at("variants_set", name=what))
    for settings, seeds in links:
        if settings.exercise_id is None:
            continue
        exercise = resources.exercises.exercise(settings.exercise_id)
        yield _of(exercise, settings.variants, settings, seeds)


def _of(
    exercise: Exercise, variants: int | None, settings: LinkSettings | None, students: Sequence[str] = ()
) -> Prepared:
    """The variants where there are some, else the usual values and those of students who have been there."""
    number = exercise.access.variants or variants
    own = students if settings is not None and settings.per_student else ()
    spoken = languages() if settings is None or settings.language is None else (settings.language,)
    seeds = variant_seeds(min(number, MOST_VARIANTS)) if number else (None, *(key[:16] for key in own))
    return Prepared(exercise=exercise, seeds=tuple(seeds), languages=tuple(spoken))


def _prepare(
    resources: Resources, settings: Settings, prepared: Prepared, options: argparse.Namespace
) -> int:
    exercise, begun = prepared.exercise, time.monotonic()
    failed = 0
    for seed in prepared.seeds:
        if not options.untested:
            for failure in check_values((seed,), exercise, MISTAKES).failures:
                failed += 1
                reason = sentence(options.lang, f"check-{failure.check}", failure.params) or failure.check
                sys.stdout.write(f"  {exercise.id} {seed or '–'}: {reason}\n")
        instance = generate(exercise, seed)
        for language in prepared.languages:
            packed_figure(resources.figures, instance, language)
        resources.figures.write_down()
    forms = _write_closed_forms(resources, settings, exercise)
    params = {
        "exercise": exercise.id,
        "values": len(prepared.seeds),
        "figures": len(prepared.seeds) * len(prepared.languages),
        "forms": forms,
        "failed": failed,
        "seconds": f"{time.monotonic() - begun:.0f}",
    }
    sys.stdout.write(f"{sentence(options.lang, 'warm-counts', params)}\n")
    return FAILED if failed else 0


def _write_closed_forms(resources: Resources, settings: Settings, exercise: Exercise) -> int:
    """The matrices of the exercise's own table, as programs and pages ask for them; how many were written."""
    table = written_table(exercise.reference)
    rows = [
        {
            "joint": None if row.joint is None else row.joint.value,
            "alpha": row.alpha,
            "a": row.a,
            "d": row.d,
            "theta": row.theta,
        }
        for row in table.rows
    ]
    asked = {
        "convention": table.convention.value,
        "angle_unit": exercise.reference.angle_unit.value,
        "length_unit": exercise.reference.length_unit.value,
        "rows": rows,
    }
    written = 0
    for form in ({}, *({"formats": list(SOURCES), "notation": notation} for notation in Notation)):
        wire: SymbolicRequest = SymbolicRequest.model_validate({"table": asked, **form})
        try:
            task = symbolic_task(wire, settings)
            answer = written_answer(task)
        except KinematicsError:  # too large to be written out: whoever asks is told so
            continue
        resources.closed_forms.keep(form_address(resources.closed_forms, task, written_answer), answer)
        written += 1
    return written
