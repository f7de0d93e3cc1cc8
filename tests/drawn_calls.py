"""A test of every call of an OpenAPI document, with bodies that schemathesis draws."""

import os
from collections.abc import Callable, Mapping
from typing import Any

import pytest
import schemathesis
from schemathesis import GenerationMode
from schemathesis.checks import load_all_checks
from schemathesis.generation.feedback import FeedbackSources
from schemathesis.pytest._test_builder import build_operation_test

Test = Callable[..., None]

MOST = (
    None if os.environ.get("FRAMEWISE_EXPLORE") else {GenerationMode.POSITIVE: 8, GenerationMode.NEGATIVE: 24}
)
"""Covering cases of a call, allowed and forbidden; a call has up to 1 150, `make explore` sends all.

What is allowed is computed as well, and so costs the most.
"""
DEEP = {GenerationMode.POSITIVE: (": ", 2), GenerationMode.NEGATIVE: (" -> ", 2)}
"""By what in its description a case is about a field within fields of a body, such as a cell of a row of a
table: calls share the shapes of those, and what is so described is sent to one of them.
"""


def for_each_call(
    schema: schemathesis.BaseSchema, most: Mapping[GenerationMode, int] | None = MOST
) -> Callable[[Test], Test]:
    """Make one test a call of what takes a `case`, and what the fixture `called` gives, by name.

    Args:
        schema: the calls.
        most: covering cases of a call that are sent; None: all.

    Schemathesis's own `parametrize` draws its covering cases when tests are collected, in every worker: most
    of what collecting eleven thousand tests cost. Here a call's cases are drawn when its test runs.
    """
    sent: dict[str, str] = {}
    operations = {found.ok().label: found.ok() for found in schema.get_all_operations()}

    def parametrized(check: Test) -> Test:
        @pytest.mark.parametrize("label", operations)
        def test(called: dict[str, Any], label: str) -> None:
            load_all_checks()
            drawn: Any = build_operation_test(
                config=schema.config,
                operation=operations[label],
                test_func=check,
                given_kwargs={},
                feedback=FeedbackSources(),
            )
            covering = getattr(
                drawn, "hypothesis_explicit_examples", None
            )  # a test without covering cases has none
            if covering is not None and most is not None:
                drawn.hypothesis_explicit_examples = _spread(_new(covering, label, sent), most)
            drawn(**called)

        return test

    return parametrized


def _new(examples: list[Any], label: str, sent: dict[str, str]) -> list[Any]:
    """What differs from what is sent already, to this call or, of what calls share, to another."""
    new = {}
    for place, example in enumerate(examples):
        meta = example.kwargs["case"].meta
        about = f"{meta.generation.mode.value} {meta.phase.data.description}"
        text, count = DEEP[meta.generation.mode]
        if about.count(text) < count or sent.setdefault(about, label) == label:
            new.setdefault(about, place)
    return [examples[place] for place in new.values()]


def _spread(examples: list[Any], sent: Mapping[GenerationMode, int]) -> list[Any]:
    """As many of a call's covering cases as are sent, evenly over all of its fields."""
    kept = set()
    for mode, most in sent.items():
        places = [
            place
            for place, example in enumerate(examples)
            if example.kwargs["case"].meta.generation.mode is mode
        ]
        kept |= {places[len(places) * k // most] for k in range(most)} if len(places) > most else set(places)
    return [example for place, example in enumerate(examples) if place in kept]
