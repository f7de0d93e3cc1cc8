"""Forward kinematics of a URDF text by a library that has nothing to do with this one."""

import io

import numpy as np
import yourdfpy


def foreign_poses(text: str, joints: np.ndarray, base: str, tip: str) -> np.ndarray:
    """(m, 4, 4) poses of the tip link in the base link [m], joints in the order of the chain."""
    urdf = yourdfpy.URDF.load(io.BytesIO(text.encode()), load_meshes=False)
    parents = {joint.child: joint for joint in urdf.robot.joints}
    names, link = [], tip
    while link != base:
        joint = parents[link]
        if joint.type != "fixed":
            names.append(joint.name)
        link = joint.parent
    found = []
    for q in joints:
        urdf.update_cfg(dict(zip(reversed(names), q.tolist(), strict=True)))
        found.append(urdf.get_transform(tip, base))
    return np.array(found)
