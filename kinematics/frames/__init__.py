"""Frame assignment: from the axes of a robot to its DH table, and the rules that the assignment follows.

axes         what is given: joint axes, the gripper frame, and what may be wrong with them
normals      how two axes lie relative to each other, and their common normal
parallels    axes that are parallel but for a tiny tilt
placement    where the line of a prismatic joint is drawn
ends         whether a given frame can be frame 0 or frame N
levels       where the origins stand along parallel axes
directions   which way the x axes point
exactness    right angles and short decimals come out exact
assignment   the whole procedure
assigned_frames  what it makes: frames with their rules, and the table
remarks      what a caller should know about an assignment that succeeded
advice       what would make a table simpler
rounding     frames that students rounded
rules        the rules for a student's frames, one by one
candidates   origins and directions to choose from
wrong_frames one mistake in frames that obey the rules: made, found, named and mended
chosen_frames  the frames that a student has chosen, as far as they are
trainer      a student's frames against the rules, and the table that follows
"""
