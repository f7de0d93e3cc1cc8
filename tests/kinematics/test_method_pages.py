"""The examples of the pages on inverse kinematics, URDF and the workspace print what they say."""

import doctest
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"


@pytest.mark.parametrize("page", ["inverse-kinematics.md", "urdf.md", "workspace.md"])
def test_every_example_of_the_page(page):
    found = doctest.testfile(str(DOCS / page), module_relative=False)
    assert (found.failed, found.attempted > 3) == (0, True)
