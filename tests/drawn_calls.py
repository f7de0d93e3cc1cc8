"""A test of every call of an OpenAPI document, with bodies that schemathesis draws."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import schemathesis
from schemathesis.checks import load_all_checks
from schemathesis.generation.feedback import FeedbackSources
from schemathesis.pytest._test_builder import build_operation_test

Test = Callable[..., None]


def for_each_call(schema: schemathesis.BaseSchema) -> Callable[[Test], Test]:
    """Make one test a call of what takes a `base_url` and a `case`.

    Schemathesis's own `parametrize` draws its covering cases when tests are collected, in every worker: most
    of what collecting eleven thousand tests cost. Here a call's cases are drawn when its test runs.
    """
    operations = {found.ok().label: found.ok() for found in schema.get_all_operations()}

    def parametrized(check: Test) -> Test:
        @pytest.mark.parametrize("label", operations)
        def test(base_url: str, label: str) -> None:
            load_all_checks()
            drawn: Any = build_operation_test(
                config=schema.config,
                operation=operations[label],
                test_func=check,
                given_kwargs={},
                feedback=FeedbackSources(),
            )
            drawn(base_url=base_url)

        return test

    return parametrized
