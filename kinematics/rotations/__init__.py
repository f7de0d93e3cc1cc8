"""Orientations: sequences of angles, what makes a matrix a rotation, chains of frames, answers about them.

matrices             rotation matrices as plain floats
sequences            three angles about current or fixed axes, and all triples of a rotation
properties           which property of a rotation a matrix lacks
orientation_answers  does a matrix, a quaternion, an axis with an angle or a triple mean a given orientation
orientation_verdicts  what is said of them
frame_chains         poses from known poses, and what a wrong one looks like
"""
