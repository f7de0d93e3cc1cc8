"""Dynamics: numbers and closed forms against derivations of another kind."""
