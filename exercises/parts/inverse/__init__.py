"""Questions of inverse kinematics: `joint_solutions`, and what is said of wrong ones."""
