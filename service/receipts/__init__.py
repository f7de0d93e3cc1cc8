"""Receipts: what a student takes away from a verdict, signed, so that a lecturer can trust it."""
