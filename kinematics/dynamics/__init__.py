"""How forces move a robot: M(q) q̈ + C(q, q̇) q̇ + g(q) = τ, in numbers and in closed form.

links      what a link weighs; everything is in SI units
reading    links as they are handed in
recursion  joint forces and motions in numbers
composite  links that move as one, in the ring of closed forms
fourier    finite Fourier series, differentiated term by term
equations  M, C and g in closed form
"""

from kinematics.dynamics.equations import Derivation, EquationsOfMotion, rate_name, reading_order
from kinematics.dynamics.links import NumericBody, RigidBody, SymbolicBody, bind_links, check_links
from kinematics.dynamics.recursion import EARTH, MovingRobot
