"""Questions of motions and forces.

screws           S_i and M of a product of exponentials
jacobians        a Jacobian in numbers, and the joint torques that hold a force
jacobian_forms   a Jacobian in symbols
jacobian_cells   what both read
singularities, singularity_cells, conditions   where rank is lost, by which conditions
equations_of_motion         M, C and g
motion_cells, weighed_links   how they are typed, and what the links weigh
"""
