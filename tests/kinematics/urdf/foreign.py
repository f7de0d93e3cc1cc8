"""Forward kinematics of a URDF text by a library that has nothing to do with this one."""

import io

import numpy as np


def foreign_poses(text: str, joints: np.ndarray, base: str, tip: str) -> np.ndarray:
    """(m, 4, 4) poses of the tip link in the base link [m], joints in the order of the chain.

    Each joint's matrix is the library's. They are multiplied here, because its scene graph leaves out
    matrices within 1e-8 of the identity, and with them lengths below 10 nm.
    """
    import yourdfpy  # with all it needs half a second, and only one of the test processes comes here

    urdf = yourdfpy.URDF.load(io.BytesIO(text.encode()), load_meshes=False)
    parents = {joint.child: joint for joint in urdf.robot.joints}
    chain, link = [], tip
    while link != base:
        chain.insert(0, parents[link])
        link = chain[0].parent
    found = []
    for q in joints:
        values = iter(q.tolist())
        pose = np.eye(4)
        for joint in chain:
            value = 0.0 if joint.type == "fixed" else next(values)
            matrix, _ = urdf._forward_kinematics_joint(joint, value)
            pose = pose @ matrix
        found.append(pose)
    return np.array(found)
