"""Settings of the property tests.

The default run draws the same examples every time, so that it passes or fails for everybody alike.
Exploring with fresh seeds (`make explore`) is a search for faults; what it finds becomes an example.
"""

import os

from hypothesis import settings

# The machine that runs the tests may be busy: time is measured by the benchmarks, not by tests.
settings.register_profile("framewise", deadline=None, derandomize=True, database=None)
settings.register_profile("explore", deadline=None)
settings.load_profile("explore" if os.environ.get("FRAMEWISE_EXPLORE") else "framewise")
