"""A minute of fuzzing: what is kept in the corpus, what was found, and inputs near them."""

from itertools import islice

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.fuzz.mutating import corpus, mutations
from tests.fuzz.targets import TARGETS, FindingError, run, watched

MUTATIONS = {"tables": 300, "answers": 150, "cells": 300, "tokens": 300, "scorm": 100}
USUAL = 1500
"""Inputs for a target: a few seconds each. Of titles there are fewer, since each makes a whole package of
files that are the same in all; `make fuzz` tries more of every kind."""


@pytest.mark.parametrize("target", TARGETS)
def test_a_reader_refuses_or_reads(target: str) -> None:
    for data in corpus(target).values():
        run(target, data)
    for data in islice(mutations(target, 0), MUTATIONS.get(target, USUAL)):
        run(target, data)


@pytest.mark.parametrize("target", [name for name in TARGETS if name not in ("tables", "answers")])
@given(data=st.binary(max_size=400))
@settings(max_examples=60)
def test_bytes_of_any_kind_are_refused_or_read(target: str, data: bytes) -> None:
    run(target, data)


def test_a_warning_an_error_in_the_log_and_a_crash_are_findings() -> None:
    import logging
    import warnings

    with pytest.raises(RuntimeWarning), watched():
        warnings.warn("overflow", RuntimeWarning, stacklevel=1)
    with pytest.raises(FindingError), watched():
        logging.getLogger("exercises").error("no repairs")
    with pytest.raises(ZeroDivisionError), watched():
        _ = 1 / 0
