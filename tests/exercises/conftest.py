"""Settings of the property tests."""

from hypothesis import settings

# The machine that runs the tests may be busy: time is measured by the benchmarks, not by tests.
settings.register_profile("framewise", deadline=None)
settings.load_profile("framewise")
