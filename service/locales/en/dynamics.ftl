# How forces move a robot.

error-links_count = A list of links has one entry for each row of the table: { $expected }, not { $given }.
error-mass_negative = A mass cannot be negative: { $mass } kg.
error-inertia_not_symmetric = An inertia matrix is symmetric: the entry xy is the same as yx.
error-inertia_negative = A moment of inertia about an axis is never negative. This matrix has a negative one about some axis.
error-dynamics_without_joints = Nothing moves: equations of motion need a revolute or a prismatic row.
error-mass_matrix_singular = Some joint moves nothing that has mass, so no force determines its acceleration. Give the links mass and inertia.
error-links_missing = Give the masses of the links: links, one entry for each row of the table.
error-name_of_rate = { $name } is the name of a joint’s rate in closed forms. Call the parameter something else.
error-body_varies = The mass of a link and its place in the link do not change with the joint variables: these stand only in the table.
error-dynamics_not_finite = The masses, lengths or rates are so large that the result is not a number.

task-equations-of-motion =
    You are given the robot’s table and the body that moves with each frame i. Write the terms of M q̈ + C q̇ + g = τ that are asked for as functions of q1, q2, …, their rates dq1, dq2, … and the given symbols; lengths in { unit-word }, per radian. { $skew ->
        [yes] Any C that gives the right C q̇ is right; in addition, Ṁ − 2C has to be skew-symmetric.
       *[no] Any C that gives the right C q̇ is right.
    }
given-link-weights = The links: mass, centre in frame i, moments about it [kg { $unit }²]
given-gravity-vector = Gravitational acceleration in frame 0 [{ $unit }/s²]
given-weights = Values of the symbols
field-mass = Mass matrix M
field-coriolis = Matrix C
field-velocity = Coriolis and centrifugal terms C q̇
field-gravity = Gravity terms g
feedback-motion_right = These are the equations of motion.
feedback-motion_mass_wrong = Not every entry of M is right.
feedback-motion_coriolis_wrong = Not every row of C q̇ is right.
feedback-motion_velocity_wrong = Not every Coriolis and centrifugal term is right.
feedback-motion_skew_wrong = With this C, Ṁ − 2C is not skew-symmetric. Christoffel symbols give a C for which it is.
feedback-motion_gravity_wrong = Not every entry of g is right.
feedback-motion_missing =
    { $what ->
        [mass] The mass matrix is missing.
        [coriolis] The matrix C is missing.
        [skew] Without the matrix C there is no Ṁ − 2C.
        [velocity] The Coriolis and centrifugal terms are missing.
       *[gravity] The gravity terms are missing.
    }
feedback-motion_asymmetric = A mass matrix is symmetric; this one is not.
feedback-motion_point_masses = This is M of point masses: the links’ own moments of inertia are missing.
feedback-motion_gravity_sign = This g has the opposite sign: g is what the joints must exert against gravity, the gradient of the potential energy.
feedback-motion_velocity_sign = This C q̇ has the opposite sign.
feedback-motion_coupling_once = Each product q̇j q̇k of two different joints occurs twice in C q̇, as jk and as kj; here it counts once.
feedback-motion_mass_rate = This is Ṁ q̇. The gradient of the kinetic energy, ½ ∂(q̇ᵀM q̇)/∂q, has to be subtracted.
error-motion_row_count = The matrix has one row for each joint: { $expected }, not { $given }.
error-motion_empty = Write at least one of the matrices or rows that are asked for.
error-motion_cell = A number or an expression belongs here; for a position or for moments of inertia, three.
