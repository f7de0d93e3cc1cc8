"""The one serial chain of a description that is meant: from a base link to a tip link.

The chain may climb from the base link to a link that carries both ends, and go down to the tip from there.
"""

from collections.abc import Sequence
from typing import NamedTuple

from kinematics.urdf.document import MAX_NUMBER, UrdfDocument, UrdfJoint, refused

MOVING = {"revolute", "continuous", "prismatic"}
SEVERAL_FREEDOMS = {"floating": 6, "planar": 2}
KNOWN = (*sorted(MOVING), "fixed")


class ChainStep(NamedTuple):
    """A joint of a chain, and which way it is passed.

    Attributes:
        upwards: from the link that it carries to the link that it stands on.
        value: where it stands still, at zero or where another joint holds it [rad, or m]; None if it has a
            variable in this chain.
    """

    joint: UrdfJoint
    upwards: bool
    value: float | None

    @property
    def moves(self) -> bool:
        """Whether it has a variable in this chain."""
        return self.value is None


def serial_chain(
    document: UrdfDocument, base_link: str | None = None, tip_link: str | None = None
) -> tuple[ChainStep, ...]:
    """Return the joints from the base link to the tip link, base first.

    A joint that follows another one by `mimic` is read as a joint of its own where nothing else in the chain
    moves with it: the joint that it follows and others that follow the same one lie elsewhere. Where it
    follows by the factor 0, or follows a joint that stands still, it stands still.

    Args:
        base_link: name of the first link; the root of the tree if left out.
        tip_link: name of the last link; may be left out if only one link carries no other.

    Raises:
        DescriptionError: a link has two parents, links form a ring, a name is unknown, nothing connects the
            links, several links could be the base or the tip, or a joint of the chain is none that a DH table
            can hold.
    """
    above = _parents(document)
    _check_tree(document, above)
    base = _base(document, above, base_link)
    tip = _tip(document, base, tip_link)
    up, down = _ancestors(base, above), _ancestors(tip, above)
    while up and down and up[-1] is down[-1]:
        del up[-1], down[-1]
    top = (up[-1].parent if up else base), (down[-1].parent if down else tip)
    if top[0] != top[1]:
        raise refused("urdf_no_path", base=base, tip=tip)
    for joint in (*up, *down):
        _check_kind(joint)
    path = [*((joint, True) for joint in up), *((joint, False) for joint in reversed(down))]
    steps = _steps(document, path)
    if not any(step.moves for step in steps):
        raise refused("urdf_nothing_moves", base=base, tip=tip)
    return steps


def _parents(document: UrdfDocument) -> dict[str, UrdfJoint]:
    """Return for every link that hangs on another the joint that carries it."""
    above: dict[str, UrdfJoint] = {}
    for joint in document.joints:
        other = above.setdefault(joint.child, joint)
        if other is not joint:
            raise refused("urdf_two_parents", link=joint.child, first=other.name, second=joint.name)
    return above


def _check_tree(document: UrdfDocument, above: dict[str, UrdfJoint]) -> None:
    settled: set[str] = set()
    for start in document.links:
        way: dict[str, None] = {}
        link = start
        while link not in settled and link not in way:
            way[link] = None
            joint = above.get(link)
            if joint is None:
                break
            link = joint.parent
        else:
            if link in way:
                raise refused("urdf_ring", link=link)
        settled.update(way)


def _ancestors(link: str, above: dict[str, UrdfJoint]) -> list[UrdfJoint]:
    """Return the joints between a link and the root, the nearest first."""
    found = []
    while (joint := above.get(link)) is not None:
        found.append(joint)
        link = joint.parent
    return found


def _base(document: UrdfDocument, above: dict[str, UrdfJoint], given: str | None) -> str:
    if given is not None:
        return _known(document, given)
    roots = tuple(link for link in document.links if link not in above)
    if len(roots) != 1:
        raise refused("urdf_base_needed", count=len(roots), links=roots[:10])
    return roots[0]


def _tip(document: UrdfDocument, base: str, given: str | None) -> str:
    if given is not None:
        return _known(document, given)
    carried: dict[str, list[str]] = {}
    for joint in document.joints:
        carried.setdefault(joint.parent, []).append(joint.child)
    leaves, pending = [], [base]
    while pending:
        link = pending.pop()
        pending += reversed(carried.get(link, []))
        if link not in carried:
            leaves.append(link)
    if len(leaves) > 1:
        raise refused("urdf_tip_needed", count=len(leaves), links=tuple(leaves[:10]))
    return leaves[0]


def _known(document: UrdfDocument, link: str) -> str:
    if link not in document.links:
        raise refused("urdf_link_unknown", link=link, known=document.links[:10])
    return link


def _check_kind(joint: UrdfJoint) -> None:
    if joint.kind in SEVERAL_FREEDOMS:
        raise refused("urdf_several_freedoms", joint=joint.name, kind=joint.kind)
    if joint.kind not in KNOWN:
        raise refused("urdf_type_unknown", joint=joint.name, kind=joint.kind, known=KNOWN)


def _steps(document: UrdfDocument, path: Sequence[tuple[UrdfJoint, bool]]) -> tuple[ChainStep, ...]:
    """Return the steps of a path of joints; make sure that no two of them follow the same variable."""
    everything = {joint.name: joint for joint in document.joints}
    owners: dict[str, str] = {}
    steps = []
    for joint, upwards in path:
        variable, value = _driven(joint, everything)
        steps.append(ChainStep(joint, upwards, value))
        if variable is None:
            continue
        if variable in owners:
            pair = (joint.name, owners[variable]) if joint.mimics() else (owners[variable], joint.name)
            raise refused("urdf_mimic", joint=pair[0], other=pair[1])
        owners[variable] = joint.name
    return tuple(steps)


def _driven(joint: UrdfJoint, everything: dict[str, UrdfJoint]) -> tuple[str | None, float | None]:
    """Return (name of the joint whose variable moves this one, None), or (None, where it stands still).

    It may follow through joints that follow joints.
    """
    multiplier, offset = 1.0, 0.0
    way = [joint.name]
    here = joint
    while here.kind in MOVING and (mimics := here.mimics()) is not None:
        multiplier, offset = multiplier * mimics.multiplier, offset + multiplier * mimics.offset
        if not (abs(multiplier) <= MAX_NUMBER and abs(offset) <= MAX_NUMBER):
            raise joint.malformed("mimic", "offset" if abs(multiplier) <= MAX_NUMBER else "multiplier", 1)
        if multiplier == 0.0:
            return None, offset
        followed = everything.get(mimics.joint)
        if followed is None:
            raise refused("urdf_mimic_unknown", joint=here.name, other=mimics.joint)
        if followed.name in way:
            circle = way[way.index(followed.name) :]
            raise refused("urdf_mimic_circle", joint=joint.name, circle=tuple(circle[:10]))
        way.append(followed.name)
        here = followed
    return (None, offset) if here.kind == "fixed" else (here.name, None)
