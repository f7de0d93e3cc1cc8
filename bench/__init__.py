"""Measurements of the project beside its peers; `make bench` runs them all. See bench/README.md."""

from bench.measure import Better, Outcome, Row, Skipped, measured, race

__all__ = ["Better", "Outcome", "Row", "Skipped", "measured", "race"]
