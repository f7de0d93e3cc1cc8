"""Figures of exercises: a robot drawn from its reference's geometry, without the frames that are asked for.

specification   what a definition says of its figure: posture, view, points, links, dimensions
figure_keys     the same read from its file
geometry        specification + reference -> the scene in space: axes, links, bodies, dimensions
points          names resolved to places in space
skeleton        the scene that a DH table alone gives, for definitions that say nothing
description     the scene in words (codes and values; the prose is elsewhere)
camera          space -> paper
bodies          cylinders and blocks on paper
shapes          axes, arrows, gripper, ground, frames
strokes         lines in space that pass behind or in front of bodies
dimensioning    dimension lines, extension lines, arrows
labels          where numbers and names may stand
placement       where labels and dimensions stand without covering each other
svg             the file
drawing         scene -> SVG
dimension_layout  where its dimensions stand, and where else they may
"""
