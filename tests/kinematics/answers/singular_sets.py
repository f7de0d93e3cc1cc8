"""Conditions for singularities, right and wrong, and an oracle that knows none of our decisions.

What is right is known from the
textbooks' determinants, written down here; that these are right is tested by differences of DH products.
"""

import random
from collections.abc import Iterator

from exercises.parts.motion.conditions import read_conditions
from kinematics import catalogue
from kinematics.answers.singular_arms import SingularArm, arm_of
from kinematics.cells import AngleUnit
from kinematics.errors import Fault
from kinematics.expressions import Expression
from kinematics.symbolic.determinants import MotionRows

TEXTBOOK: dict[tuple[str, MotionRows], tuple[str, ...]] = {
    ("twolink", MotionRows.TRANSLATION): ("sin(q2)",),
    ("scara", MotionRows.TWIST): ("sin(q2)",),
    ("stanford", MotionRows.TWIST): ("sin(q2)", "q3", "sin(q5)"),
    ("rx90", MotionRows.TWIST): ("cos(q3)", "sin(q5)", "D3*cos(q2) - RL4*sin(q2 + q3)"),
    ("puma560", MotionRows.TWIST): (
        "a3*sin(q3) + d4*cos(q3)",
        "sin(q5)",
        "a2*cos(q2) + a3*cos(q2 + q3) - d4*sin(q2 + q3)",
    ),
    ("kr125", MotionRows.TWIST): ("sin(q3)", "sin(q5)", "L1 + L2*cos(q2) + L3*cos(q2 + q3)"),
}
"""Factors of det J: Craig's PUMA (modified table), Stanford's wrist and slider, two parallel links …"""

ARMS = tuple(TEXTBOOK)


def arm(name: str, rows: MotionRows) -> SingularArm:
    """Return an arm of the catalogue."""
    listed = catalogue.robot(name)
    return arm_of(listed.table.table, rows, tuple(sorted(listed.parameters.items())))


def read(name: str, text: str) -> list[Expression]:
    """Return the functions of one cell."""
    types = catalogue.robot(name).table.table.joint_types
    found = read_conditions(text, types, AngleUnit.RAD, ("conditions", 0))
    faults = [entry for entry in found if isinstance(entry, Fault)]
    assert not faults, (text, faults)
    return [entry.expression for entry in found if not isinstance(entry, Fault)]


def written(factor: str, rng: random.Random) -> str:
    """Return the same condition written otherwise."""
    ways = [
        factor,
        f"{factor} = 0",
        f"-({factor})",
        f"{rng.randint(2, 9)}*({factor}) = 0",
        f"({factor})^{rng.randint(2, 3)}",
        f"({factor})*(2 + cos(q1))",
        f"({factor})*(sin(q1)^2 + cos(q1)^2) = 0",
        f"0 = {factor}",
    ]
    if factor.startswith(("sin(q", "cos(q")) and factor[4:-1].startswith("q"):
        angle = factor[4:-1]
        if factor.startswith("sin"):
            ways += [
                f"{angle} = 0, pi",
                f"{angle} = k*pi",
                f"{angle} = 0 or {angle} = 180°",
                f"cos({angle})^2 = 1",
                f"tan({angle})",
                f"sin({angle}/2)*cos({angle}/2)",
                f"1 - cos(2*{angle})",
                f"{angle} = ±pi; {angle} = 2*k*pi",
            ]
        else:
            ways += [f"{angle} = ±pi/2", f"{angle} = pi/2 + k*pi", f"sin({angle})^2 = 1", f"cos(-{angle})"]
    if factor == "a3*sin(q3) + d4*cos(q3)":
        ways += ["tan(q3) = -d4/a3", "q3 = atan2(-d4, a3), atan2(d4, -a3)", "q3 = atan(-d4/a3) + k*pi"]
    if " - d4*sin(q2 + q3)" in factor:
        ways += ["a2*c2 + a3*c23 = d4*s23", "a2*c2 + a3*(c2*c3 - s2*s3) - d4*(s2*c3 + c2*s3) = 0"]
    return rng.choice(ways)


def right_answer(factors: tuple[str, ...], rng: random.Random) -> list[str]:
    """Return all families in any order, some of them in one product, one of them twice."""
    parts = [written(factor, rng) for factor in factors]
    if rng.random() < 0.3 and len(factors) > 1:
        parts = ["*".join(f"({factor})" for factor in factors)]
    if rng.random() < 0.2:
        parts.append(written(rng.choice(factors), rng))
    rng.shuffle(parts)
    return parts


def wrong_answer(factors: tuple[str, ...], rng: random.Random) -> list[str]:
    """Return one family too few, half of one, one too many, or another one in its place."""
    k = rng.randrange(len(factors))
    rest = [written(factor, rng) for i, factor in enumerate(factors) if i != k]
    factor = factors[k]
    ways = [
        rest,
        [*rest, "cos(q1)"],
        [*rest, factor, "sin(q1) = 1/3"],
        [*rest, factor, f"({factor})*sin(q1)"],
    ]
    ways += [[*rest, factor, "0"], [*rest, f"{factor} = 1/5"], [*rest, f"({factor})^2 = 1/50"]]
    if factor.startswith("sin(q"):
        angle = factor[4:-1]
        ways += [
            [*rest, f"{angle} = 0"],
            [*rest, f"{angle} = pi"],
            [*rest, f"cos({angle})"],
            [*rest, f"sin({angle}/2)"],
            [*rest, f"{angle} = k*pi/2"],
            [*rest, f"1 - cos({angle})"],
        ]
    if factor == "a3*sin(q3) + d4*cos(q3)":
        ways += [[*rest, "q3 = atan2(d4, a3)"], [*rest, "q3 = atan2(-d4, a3)"], [*rest, "d4*s3 + a3*c3"]]
    if " - d4*sin(q2 + q3)" in factor:
        ways += [
            [*rest, "a2*c2 + a3*c23 + d4*s23"],
            [*rest, "a2*c2 - d4*s23"],
            [*rest, "d4*c2 + a3*c23 - a2*s23"],
        ]
    return rng.choice(ways)


def cases(count: int, seed: int) -> Iterator[tuple[str, SingularArm, list[str], bool]]:
    """Yield answers: of which robot, which arm, what, and whether it is right."""
    rng = random.Random(seed)
    for k in range(count):
        name, rows = rng.choice(ARMS)
        factors = TEXTBOOK[name, rows]
        texts = wrong_answer(factors, rng) if k % 2 else right_answer(factors, rng)
        yield name, arm(name, rows), texts, not k % 2
