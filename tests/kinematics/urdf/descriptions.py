"""Every serial chain of the robot descriptions that others publish, against Pinocchio: `make descriptions`.

From the root of each description to each of its ends, and from one end to another, a chain is read as a DH
table in either convention. Its poses are Pinocchio's; written as URDF and read again it has the same poses,
names and limits. A chain that is refused is looked at here once more, with nothing but the XML: the reason
must be there. Lastly, robots of the catalogue are held against their makers' descriptions.
"""

import argparse
import importlib.util
import itertools
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element, ParseError, tostring

import numpy as np
import pytest
from defusedxml.ElementTree import fromstring

from kinematics import catalogue
from kinematics.cells import bind_parameters
from kinematics.chain import Chain, chain_of_table
from kinematics.errors import DescriptionError
from kinematics.forward import end_poses
from kinematics.se3 import cross_arrays
from kinematics.table import Convention
from kinematics.urdf import UrdfRobot, chain_from_urdf, table_from_urdf, urdf_from_table

TOLERANCE = 1e-9
FIGURES = 1e-6
"""How far axes may differ: descriptions print right angles as 1.57079632679 or 1.570796."""
PAIRS = 6
"""Chains from one end to another that are tried of each description."""

CATALOGUE = {
    "ur5": ("ur5_robot.urdf", "base_link", "tool0"),
    "ur10": ("ur10_robot.urdf", "base_link", "tool0"),
    "panda": ("panda.urdf", "panda_link0", "panda_link8"),
}
"""Robots of the catalogue that a maker or ROS-Industrial describes: file, first and last link."""


def sources() -> Iterator[Path]:
    """Yield the description files of example-robot-data and rtb-data."""
    for package in ("cmeel", "rtbdata"):
        found = importlib.util.find_spec(package)
        assert found is not None, f"{package} is not installed"
        root = Path(next(iter(found.submodule_search_locations or ())))
        yield from sorted((root.parent / "cmeel.prefix" if package == "cmeel" else root).rglob("*.urdf"))


def ends(root: Element) -> tuple[list[str], list[str]]:
    """Return the links that hang on no other, and those that carry none."""
    links = [link.get("name", "") for link in root.findall("link")]
    parents = {joint.find("parent").get("link") for joint in root.findall("joint")}  # type: ignore[union-attr]
    children = {joint.find("child").get("link") for joint in root.findall("joint")}  # type: ignore[union-attr]
    return [x for x in links if x not in children], [x for x in links if x not in parents]


def path(root: Element, base: str, tip: str) -> list[Element]:
    """Return the joints between two links of a tree."""
    above = {joint.find("child").get("link"): joint for joint in root.findall("joint")}  # type: ignore[union-attr]
    ways = []
    for link in (base, tip):
        way = []
        while link in above:
            way.append(above[link])
            link = above[link].find("parent").get("link")  # type: ignore[union-attr,assignment]
        ways.append(way)
    return [joint for joint in (*ways[0], *ways[1]) if (joint in ways[0]) != (joint in ways[1])]


def is_true(code: str, joints: list[Element], known: set[str | None]) -> bool:
    """Whether a chain is as its refusal says."""
    moving = [joint for joint in joints if joint.get("type") in ("revolute", "continuous", "prismatic")]
    followed = [
        joint.get("name") if (mimic := joint.find("mimic")) is None else mimic.get("joint")
        for joint in moving
    ]
    match code:
        case "urdf_nothing_moves":
            return not moving
        case "urdf_several_freedoms":
            return any(joint.get("type") in ("floating", "planar") for joint in joints)
        case "urdf_mimic":
            return max(Counter(followed).values()) > 1
        case "urdf_mimic_unknown":
            return not known.issuperset(followed)
        case "urdf_too_many_joints":
            return len(moving) > 64
    return False


class Foreign:
    """Poses by Pinocchio."""

    def __init__(self, text: str) -> None:
        import pinocchio

        self._pin: Any = pinocchio
        self._model = pinocchio.buildModelFromXML(text)
        self._data = self._model.createData()

    def poses(self, names: tuple[str, ...], joints: Any, base: str, tip: str) -> Any:
        """Return (m, 4, 4) poses of the tip link in the base link."""
        found = []
        body = self._pin.FrameType.BODY
        for values in joints:
            q = self._pin.neutral(self._model)
            for name, value in zip(names, values, strict=True):
                joint = self._model.joints[self._model.getJointId(name)]
                pair = [np.cos(value), np.sin(value)] if joint.nq == 2 else [value]
                q[joint.idx_q : joint.idx_q + joint.nq] = pair
            self._pin.framesForwardKinematics(self._model, self._data, q)
            one, two = (self._data.oMf[self._model.getFrameId(link, body)] for link in (base, tip))
            found.append((one.inverse() * two).homogeneous)
        return np.array(found)


def own_poses(robot: UrdfRobot, joints: Any) -> Any:
    """Return (m, 4, 4) poses of the tip link in the base link by this package."""
    return end_poses(robot.table, joints, base=robot.base, tool=robot.tool)


def compared(text: str, foreign: Foreign, base: str, tip: str) -> float:
    """Return the largest difference to Pinocchio; both conventions, and once more through URDF."""
    worst = 0.0
    for convention in Convention:
        robot = table_from_urdf(text, convention, base_link=base, tip_link=tip)
        joints = np.random.default_rng(5).uniform(-1.0, 1.0, (4, len(robot.joints)))
        expected = foreign.poses(robot.joints, joints, base, tip)
        written = urdf_from_table(
            robot.table, name=robot.name or "robot", base=robot.base, tool=robot.tool,
            limits=robot.limits, joint_names=robot.joints,
        )  # fmt: skip
        again = table_from_urdf(written.text, convention)
        assert (again.joints, again.limits) == (robot.joints, robot.limits), "names or limits changed"
        for found in (own_poses(robot, joints), own_poses(again, joints)):
            worst = max(worst, float(np.abs(found - expected).max()))
    return worst


def look_at(file: Path, counts: Counter[str]) -> list[str]:
    """Read every chain of a file; return what is wrong."""
    text = file.read_text(encoding="utf-8", errors="replace")
    try:
        root = fromstring(text.encode())
    except ParseError:
        with pytest.raises(DescriptionError, check=lambda error: error.code == "urdf_not_xml"):
            table_from_urdf(text, Convention.STANDARD)
        counts["urdf_not_xml"] += 1
        return []
    roots, tips = ends(root)
    root.set("name", root.get("name") or "nameless")  # Pinocchio asks for one
    try:
        foreign = Foreign(tostring(root, encoding="unicode"))
    except (ValueError, RuntimeError) as error:
        counts["no model in Pinocchio"] += 1
        return [] if len(roots) != 1 else [f"{file.name}: Pinocchio: {error}"]
    wrong = []
    pairs = list(itertools.islice(itertools.permutations(tips, 2), PAIRS))
    for base, tip in (*((roots[0], tip) for tip in tips), *pairs):
        try:
            worst = compared(text, foreign, base, tip)
        except DescriptionError as error:
            counts[error.code] += 1
            known = {joint.get("name") for joint in root.findall("joint")}
            if not is_true(error.code, path(root, base, tip), known):
                wrong.append(f"{file.name}: {base} → {tip}: {error.code} is not true")
            continue
        counts["as Pinocchio"] += 1
        if worst > TOLERANCE:
            wrong.append(f"{file.name}: {base} → {tip}: {worst:.1e}")
    return wrong


def catalogue_differences(files: dict[str, Path]) -> list[str]:
    """Return which robots of the catalogue have other axes than their makers' descriptions."""
    wrong = []
    for robot_id, (name, base, tip) in CATALOGUE.items():
        robot = catalogue.robot(robot_id)
        ours = chain_of_table(bind_parameters(robot.table, robot.parameters))
        text = files[name].read_text(encoding="utf-8")
        theirs = chain_from_urdf(text, base_link=base, tip_link=tip).chain
        apart = max(np.abs(a - b).max() for a, b in zip(invariants(ours), invariants(theirs), strict=True))
        print(f"  {apart:.1e}  {robot_id} beside {name}")
        if apart > FIGURES:
            wrong.append(f"{robot_id}: other axes than {name}: {apart:.1e}")
    return wrong


def invariants(chain: Chain) -> tuple[Any, Any]:
    """Return what no choice of base frame changes of the joint axes: z_i · z_j and z_i · m_j + z_j · m_i."""
    z = np.array([axis.direction for axis in chain.axes])
    m = cross_arrays(np.array([axis.point for axis in chain.axes]), z)
    return z @ z.T, z @ m.T + m @ z.T


def main() -> int:
    """Look at every file; report and return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", default="", help="part of the file's name")
    only = parser.parse_args().only
    counts: Counter[str] = Counter()
    files = {file.name: file for file in sources() if only in file.name}
    wrong = [fault for file in files.values() for fault in look_at(file, counts)]
    if not only:
        wrong += catalogue_differences(files)
    print(f"{len(files)} descriptions")
    for what, count in counts.most_common():
        print(f"  {count:5d}  {what}")
    print(*wrong, sep="\n")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
