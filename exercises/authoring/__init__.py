"""Starting an exercise: from a catalogue robot, a table, axes or URDF to a folder that loads.

sources    what the exercise is about, in one form: a DH table with values
scaffold   the folder: exercise.toml and statements to go on from
"""
