"""Methods that yield all solutions, and which arm has which: see `closed_form`.

closed_form    which arm has which method
wrist          three axes through one point
wrist_scalars  the same for one target that is away from singularities
clear_blocks   the same for many of them
wrist_tapes    what these have recorded of an arm
parallel       three parallel axes
general        six revolute joints of any kind, as an eigenproblem
partition      arms of few joints, or with slides before a wrist
position       three joints that bring points to their places
axis_lines     where axes meet, and turns about them
trigonometric  equations in the cosine and sine of one angle
locked         arms with a redundant joint: one is held
"""
