"""Where families of solutions cross others.

Along a family the Jacobian does not see one direction. Where it does not see a second one either another
family may begin: a PUMA whose wrist's centre lies on the shoulder's axes turns about them, and where that
brings the wrist into line joints 4 and 6 turn against each other as well. Such points are the least second
singular values along a path; from each the directions between that the Jacobian does not see are tried.

Source: E. L. Allgower, K. Georg, Introduction to numerical continuation methods (2003)
ch. 8, branch switching.
"""

import math
from collections.abc import Iterator
from itertools import combinations

import numpy as np

from kinematics.inverse.arm import Array
from kinematics.inverse.distinct import shorter_way
from kinematics.inverse.self_motions.families import FamilyPath, Follower, nearest_on

NEAR_A_CROSSING = 0.5
"""Second singular values above this at a point of a path do not vanish within a step of it: they change by
no more than one for each radian, and half a longest step is 0.2."""

SLOPE = 4.0  # A second singular value above this many times the width of its bracket does not vanish in it.

NARROW = 1e-8  # Brackets are no narrower than this part of a step.

MOST_TRIED = 12  # Least second singular values that are looked at on one path; the paths of a PUMA have four.

INNER = 8  # Points looked at together inside a bracket.

LOOKS = 90  # Directions looked at over half a turn: corrections bring back what two degrees are off.

A_LITTLE = 1e-4  # Step [rad, or parts of the size] of difference quotients.

LEVEL = 0.2  # Part of the largest bend up to which a least one may be none.

ONE_DIRECTION = 0.99  # Cosine above which two directions are one.

AT_REST = 1e-3
"""Singular values up to this do not tell which combination of directions leaves joints at rest."""

ANGLES = tuple(math.radians(degrees) for degrees in (0.0, 30.0, -30.0, 60.0, -60.0))
"""Directions tried in the plane that the Jacobian does not see, from across the path: corrections find a
family that is within 15° of one of them, and most that are farther."""


def branches(follower: Follower, path: FamilyPath, step: float, lost: float) -> Iterator[tuple[Array, Array]]:
    """Yield the configurations beside a path, on others that leave it where the Jacobian loses one rank more.

    Each comes with the direction from the path, in units; several may be on one path.

    Args:
        follower: of the path's target.
        path: a family.
        step: how far they are from the crossing [rad, or parts of the size].
        lost: singular values up to this are zero.
    """
    for x, along in _crossings(follower, path):
        ways = [sign * step * one for one in _across(follower, x, along, lost) for sign in (1.0, -1.0)]
        if follower.is_spent:
            return
        for moved in follower.moves_each(x, np.array(ways).reshape(-1, len(x))):
            if moved is not None:
                yield moved, (moved - x) / np.linalg.norm(moved - x)


def tangents(follower: Follower, x: Array, null: Array, smallest: float) -> list[Array]:
    """Return the unit directions along which families may leave a solution.

    Of several directions of the null space of the Jacobian, families leave along those in which it stays
    singular: l·(∂J/∂v) v = 0 for every l that it does not reach. In a plane these are looked for by angle;
    elsewhere tried are the directions given, and those that leave as many joints at rest as may be.

    Args:
        follower: of the solution's target.
        x: (n,) the solution, in units.
        null: (k, n) unit directions of the null space of the Jacobian.
        smallest: singular values up to this are zero.

    Source: E. L. Allgower, K. Georg, Introduction to numerical continuation methods (2003) eq. 8.1.15, the
    algebraic bifurcation equation.
    """
    if len(null) < 2:
        return list(null)
    tried = list(null)
    if len(null) == 2:
        tried += _level_directions(follower, x, null, smallest)
    else:
        tried += _resting_directions(null)
    found: list[Array] = []
    for direction in tried:
        if all(abs(float(direction @ other)) < ONE_DIRECTION for other in found):
            found.append(direction)
    return found


def _level_directions(follower: Follower, x: Array, null: Array, smallest: float) -> list[Array]:
    """Directions in a plane in which the way that a Jacobian does not reach bends least."""
    U, values, _ = np.linalg.svd(follower.jacobian(x))
    rank = int((values > smallest).sum())
    across = np.linalg.qr(null.T)[0].T
    half_circle = np.pi * np.arange(LOOKS) / LOOKS
    ways = np.cos(half_circle)[:, None] * across[0] + np.sin(half_circle)[:, None] * across[1]
    J = [follower.jacobians(x + step * ways) for step in (A_LITTLE, -A_LITTLE)]
    bends = np.linalg.norm(np.einsum("iu,mij,mj->mu", U[:, rank:], J[0] - J[1], ways), axis=1)
    least = (bends <= np.roll(bends, 1)) & (bends <= np.roll(bends, -1)) & (bends <= LEVEL * bends.max())
    return list(ways[least])


def _resting_directions(null: Array) -> list[Array]:
    """Combinations of k directions that leave k - 1 joints at rest."""
    k, n = null.shape
    found = []
    for resting in combinations(range(n), k - 1):
        weights = np.linalg.svd(null[:, list(resting)].T)
        if weights[1][-1] > AT_REST:
            found.append(weights[2][-1] @ null)
    return [direction / np.linalg.norm(direction) for direction in found]


def is_beside(follower: Follower, path: FamilyPath, x: Array, distance: float) -> bool:
    """Return whether a configuration is within a distance of a path's points and the chords between them."""
    off, _ = nearest_on(follower.arm, path, x * follower.arm.units)
    return float(np.linalg.norm(off)) <= distance


def _crossings(follower: Follower, path: FamilyPath) -> Iterator[tuple[Array, Array]]:
    """Where the second singular value is least along a path, in units, and the path's direction there."""
    x, values = _with_middles(follower, path)
    last = len(x) - 1
    tried = 0
    for k in range(len(x)):
        if tried == MOST_TRIED or follower.is_spent:
            return
        before = k - 1 if k or not path.closed else last
        after = k + 1 if k < last or not path.closed else 0
        sides = [i for i in (before, after) if 0 <= i <= last and i != k]
        if not sides or values[k] > NEAR_A_CROSSING or any(values[i] < values[k] for i in sides):
            continue
        if before in sides and values[before] == values[k]:
            continue
        tried += 1
        ways = [shorter_way(x[i] - x[k], follower.arm.revolute) for i in sides]
        found = _least(follower, x[k], ways[0], ways[-1] if len(ways) > 1 else np.zeros_like(ways[0]))
        if found is not None:
            way = ways[-1] - (ways[0] if len(ways) > 1 else 0.0)
            yield found, way / max(float(np.linalg.norm(way)), 1e-300)


def _with_middles(follower: Follower, path: FamilyPath) -> tuple[Array, Array]:
    """A path's points, in units, and their second singular values, with a point between every two.

    Two crossings within two steps of the path would else look like one.
    """
    x = path.points / follower.arm.units
    ends = np.concatenate((x[1:], x[:1])) if path.closed else x[1:]
    ways = shorter_way(ends - x[: len(ends)], follower.arm.revolute)
    units = ways / np.maximum(np.linalg.norm(ways, axis=1), 1e-300)[:, None]
    middles, _, _ = follower.corrected_all(x[: len(ends)] + 0.5 * ways, units[:, None])
    between = np.arange(1, len(ends) + 1)
    return np.insert(x, between, middles, axis=0), np.insert(path.second, between, follower.second(middles))


def _least(follower: Follower, x: Array, back: Array, ahead: Array) -> Array | None:
    """The configuration between x + back and x + ahead at which the second singular value is least.

    By brackets around the least of several points; None as soon as it cannot vanish.
    """
    width = float(np.linalg.norm(back) + np.linalg.norm(ahead))
    low, high = -1.0 if back.any() else 0.0, 1.0 if ahead.any() else 0.0
    least, best, at = float(follower.second(x[None])[0]), x, 0.0
    while high - low > NARROW:
        inner = np.linspace(low, high, INNER + 2)
        s = inner[1:-1][:, None]
        ways = np.where(s > 0.0, ahead, -back)
        units = ways / np.linalg.norm(ways, axis=1)[:, None]
        there, _, _ = follower.corrected_all(x + s * ways, units[:, None])
        values = follower.second(there)
        k = int(values.argmin())
        if values[k] < least:
            least, best, at = float(values[k]), there[k], float(s[k, 0])
        low, high = float(inner[inner < at].max(initial=low)), float(inner[inner > at].min(initial=high))
        if least <= 0.1 * follower.lost:
            break
        if least > SLOPE * (high - low) * width and least > follower.lost:
            return None
    return best


def _across(follower: Follower, x: Array, along: Array, lost: float) -> Iterator[Array]:
    """Directions across a path that the Jacobian does not see."""
    frames = follower.arm.frames((x * follower.arm.units)[None])
    J = follower.arm.jacobians(frames)[0] * follower.arm.units
    _, values, rows = np.linalg.svd(J)
    values = np.concatenate((values, np.zeros(len(x) - len(values[: len(x)]))))
    null = rows[values[: len(x)] <= max(lost, follower.lost)]
    t = null.T @ (null @ along)
    if len(null) < 2 or not float(np.linalg.norm(t)):
        return
    t /= np.linalg.norm(t)
    others = np.linalg.svd(null - np.outer(null @ t, t))[2][: len(null) - 1]
    for n in others:
        for angle in ANGLES:
            yield math.cos(angle) * n + math.sin(angle) * t
