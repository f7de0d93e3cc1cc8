# How forces move a robot.

error-links_count = A list of links has one entry for each row of the table: { $expected }, not { $given }.
error-mass_negative = A mass is not negative: { $mass } kg.
error-inertia_not_symmetric = An inertia matrix is symmetric: the entry xy is the same as yx.
error-inertia_negative = A moment of inertia about an axis is never negative. This matrix has a negative one about some axis.
error-mass_matrix_singular = Some joint moves nothing that weighs, so no force says how it accelerates. Give the links mass and inertia.
error-links_missing = Say what the links weigh: links, one entry for each row of the table.
error-name_of_rate = { $name } is the name of a joint’s rate in closed forms. Call the parameter something else.
error-body_varies = What a link weighs, and where, does not change with the joint variables: they stand in the table only.
error-dynamics_not_finite = The masses, lengths or rates are so large that the result is no number.
