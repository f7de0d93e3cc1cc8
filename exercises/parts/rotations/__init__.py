"""Questions of rotations and chains of frames: `orientation`, `rotation_check`, `frame_chain`."""
