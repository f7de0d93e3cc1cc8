"""Making exercises: from a robot, a table, drawn axes, an SCM chain or URDF to a draft and its folder.

sources       what an exercise is started from, in one form: a DH table with values
named_tables  names for its lengths
axes_drawing  joint axes placed by coordinates, lengths and each other, and the table in these lengths
scaffold      the draft of a new exercise, and its folder
draft         an exercise as plain data; the reader of folders reads it
admission     how many of the ways to write a robot's table a policy accepts
trials        a draft drawn, tested and rehearsed
toml_text     a definition as TOML, in one form
archive       the folder as a zip file, in and out
"""
