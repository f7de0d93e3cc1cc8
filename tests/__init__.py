"""Tests of the stateless service keep no data; those of courses say where theirs is."""

import os

os.environ.setdefault("FRAMEWISE_STORAGE", "off")
