"""The one serial chain of a description that is meant: from a base link to a tip link."""

from __future__ import annotations

from kinematics.urdf.document import UrdfDocument, UrdfJoint, refused

MOVING = {"revolute", "continuous", "prismatic"}
SEVERAL_FREEDOMS = {"floating": 6, "planar": 2}
KNOWN = (*sorted(MOVING), "fixed")


def serial_chain(
    document: UrdfDocument, base_link: str | None = None, tip_link: str | None = None
) -> tuple[UrdfJoint, ...]:
    """The joints from the base link to the tip link, base first.

    Args:
        document: the description.
        base_link: name of the first link; the root of the tree if left out.
        tip_link: name of the last link; may be left out if only one link carries no other.

    Raises:
        DescriptionError: a link has two parents, links form a ring, a name is unknown, the tip does not hang
            on the base, several links could be the base or the tip, or a joint of the chain is none that a DH
            table can hold.
    """
    above = _parents(document)
    _check_tree(document, above)
    base = _base(document, above, base_link)
    tip = _tip(document, above, base, tip_link)
    chain: list[UrdfJoint] = []
    link = tip
    while link != base:
        joint = above.get(link)
        if joint is None:
            raise refused("urdf_no_path", base=base, tip=tip)
        chain.append(joint)
        link = joint.parent
    for joint in chain:
        _check_kind(joint)
    if not any(joint.kind in MOVING for joint in chain):
        raise refused("urdf_nothing_moves", base=base, tip=tip)
    return tuple(reversed(chain))


def _parents(document: UrdfDocument) -> dict[str, UrdfJoint]:
    """For every link that hangs on another the joint that carries it."""
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


def _base(document: UrdfDocument, above: dict[str, UrdfJoint], given: str | None) -> str:
    if given is not None:
        return _known(document, given)
    roots = tuple(link for link in document.links if link not in above)
    if len(roots) != 1:
        f"{len(roots)} links hang on no other; name one as base_link: {', '.join(roots[:10])}"
        raise refused("urdf_base_needed", count=len(roots), links=roots[:10])
    return roots[0]


def _tip(document: UrdfDocument, above: dict[str, UrdfJoint], base: str, given: str | None) -> str:
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
        f"the description branches; name one of its {len(leaves)} ends as tip_link: "
        raise refused("urdf_tip_needed", count=len(leaves), links=tuple(leaves[:10]))
    return leaves[0]


def _known(document: UrdfDocument, link: str) -> str:
    if link not in document.links:
        f"the description has no link {link}; it has {', '.join(document.links[:10])}"
        raise refused("urdf_link_unknown", link=link, known=document.links[:10])
    return link


def _check_kind(joint: UrdfJoint) -> None:
    if joint.kind in SEVERAL_FREEDOMS:
        raise refused("urdf_several_freedoms", joint=joint.name, kind=joint.kind)
    if joint.kind not in KNOWN:
        f"joint {joint.name} is of the type “{joint.kind}”; known are {', '.join(KNOWN)}"
        raise refused("urdf_type_unknown", joint=joint.name, kind=joint.kind, known=KNOWN)
    if joint.element.find("mimic") is not None:
        raise refused("urdf_mimic", joint=joint.name)
