"""Denavit–Hartenberg kinematics: pure mathematics, SI units and radians."""
