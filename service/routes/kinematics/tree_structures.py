"""Arms that branch."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Annotated, Any

from kinematics.cells import Limits
from kinematics.errors import Fault, KinematicsError, TableError
from kinematics.inverse.lengths import check_lengths
from kinematics.tree_structures import fault_in_tree, path_table, read_tree, tree_frames, tree_jacobian
from service.http.openapi import body_with
from service.http.problems import located
from service.http.routing import ApiRequest, api_router
from service.schemas.kinematics.tree_request import TreeAnswer, TreeEnd, TreeRequest
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.prepared_robots import robot_of
from service.wire.kinematics.written_tables import TableWriter

router = api_router("kinematics")

_EXAMPLES: dict[str, Any] = {
    "a torso with two arms": {
        "tree": {
            "angle_unit": "deg",
            "rows": [
                {"after": 0, "alpha": 0, "a": 0, "d": "h", "theta": "q1"},
                {"after": 1, "alpha": 90, "a": "w", "d": 0, "theta": "q2"},
                {"after": 2, "alpha": 0, "a": "L", "d": 0, "theta": "q3"},
                {"after": 1, "gamma": 180, "b": 0.1, "alpha": 90, "a": "w", "d": 0, "theta": "q4"},
                {"after": 4, "alpha": 0, "a": "L", "d": 0, "theta": "q5"},
            ],
        },
        "parameters": {"h": 0.5, "w": 0.2, "L": 0.3},
        "joints": [10, 30, -40, -30, 40],
    }
}


@router.post("/trees", summary="Frames, Jacobians and tables of an arm that branches")
async def trees(body: Annotated[TreeRequest, body_with(_EXAMPLES)], request: ApiRequest) -> TreeAnswer:
    """Return the poses of all frames of a tree (Khalil, Kleinfinger), and each tip's Jacobian and table.

    Frame j follows frame i: iT_j = Rot_z(γ) Trans_z(b) Rot_x(α) Trans_x(a) Rot_z(θ) Trans_z(d). The path to a
    tip is a serial arm, whose modified table is returned and can be given to every other call. Closed loops
    are not treated.
    """
    return await request.in_turn(partial(_answer, body, request.settings.cell_limits))


def _answer(body: TreeRequest, limits: Limits) -> TreeAnswer:
    with located("tree"):
        tree = read_tree(body.tree.raw(), body.tree.angle_unit, body.tree.length_unit, limits)
    try:
        robot = robot_of(tree.read, body.parameters)
        check_lengths(robot.table)
    except KinematicsError as error:
        raise type(error)(map(_placed, error.faults)) from None
    joints = values_in_radians(body.joints, robot.joint_units, "joints")
    count = len(tree.after)
    unknown = [
        Fault.at("frame_unknown", "ends", i, given=end, count=count)
        for i, end in enumerate(body.ends or ())
        if not 1 <= end <= count
    ]
    if unknown:
        raise TableError(unknown)
    frames = tree_frames(tree, robot.table, joints)
    writer = TableWriter(angle_unit=tree.read.angle_unit, length_unit=tree.read.length_unit)
    ends = [
        TreeEnd.model_validate(
            {
                "frame": end,
                "joints": list(tree.joints(end)),
                "transform": plain_lists(frames[end - 1]),
                "J0": plain_lists(tree_jacobian(tree, robot.table, joints, end)),
                "table": writer.table(path_table(tree, tree.read.table, end)),
            }
        )
        for end in body.ends or tree.tips
    ]
    units: dict[str, Any] = dict(robot.units)
    return TreeAnswer(**units, frames=[plain_lists(frame) for frame in frames], ends=ends)


def _placed(fault: Fault) -> Fault:
    """The place of a fault in the request."""
    if fault.where[:1] == ("parameters",):
        return fault
    inside = replace(fault, where=tuple(step for step in fault.where if step != "table"))
    return fault_in_tree(inside).within("tree")
