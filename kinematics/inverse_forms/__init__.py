"""Inverse kinematics in symbols, as books print it.

derivation     which joint follows from what
parts          how an arm is taken apart
signed_axes    axes at right angles, in symbols
planar_joints  joints that move in a plane
axis_turns     turns about axes through one point
steps          what is written down: equations, branch signs, conditions, singular cases
singular_cases the equations of a singular case
formulas       what the equations are made of
outer_frames   equations for the pose of the tool in the world
branches       the numbers of each branch
"""

from kinematics.inverse_forms.branches import joint_values
from kinematics.inverse_forms.derivation import inverse_form
from kinematics.inverse_forms.singular_cases import form_of_case
from kinematics.inverse_forms.steps import (
    ConditionKind,
    InverseCondition,
    InverseForm,
    InverseQuantity,
    InverseReach,
    InverseStep,
    SingularCase,
)
