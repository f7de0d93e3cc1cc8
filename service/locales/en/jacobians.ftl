task-jacobian-analytic =
    { $variables ->
        [own] Take your own table and your own joint variables at these values.
       *[given] The table of the robot and a configuration are given.
    } Write the analytic Jacobian: the velocity of the last origin in frame 0, then the rates of the three angles about the { $turning ->
            [fixed] fixed
           *[current] current
        } axes { $axes }, in their order. Numbers, lengths in { unit-word }, per radian.

task-jacobian-form =
    { $variables ->
        [own] Take your own table and your own joint variables.
       *[given] The table of the robot is given.
    } { $ask ->
        [jacobian] Write the geometric Jacobian of the last origin in closed form: its entries are functions of the joint variables, per radian.
        [forces] Write the joint torques and forces that belong to the force and moment at the last origin, τ = Jᵀ(f, m), as functions of the joint variables.
       *[both] Write the geometric Jacobian of the last origin in closed form, per radian, and the joint torques and forces τ = Jᵀ(f, m) that belong to the force and moment at the last origin.
    } { $frame ->
        [end] All vectors are in the axes of the last frame.
       *[base] All vectors are in the axes of frame 0.
    }

task-jacobian-form-analytic =
    { $variables ->
        [own] Take your own table and your own joint variables.
       *[given] The table of the robot is given.
    } Write the analytic Jacobian: the velocity of the last origin in frame 0, then the rates of the three angles about the { $turning ->
            [fixed] fixed
           *[current] current
        } axes { $axes }, in their order. The entries are functions of the joint variables.

feedback-jacobian_geometric = The last three rows are those of the angular velocity; the rates of the angles are asked for.
feedback-jacobian_other_point = These are the velocities of another point; that of the last frame’s origin is asked for.
feedback-jacobian_reversed =
    { $count ->
        [1] Column { $joint } has the opposite sign: mind which way z points.
       *[other] Columns { $joints } have the opposite sign: mind which way z points.
    }
feedback-jacobian_per_degree = The columns of the revolute joints are per degree; they are asked for per radian.
feedback-jacobian_other_unit = The lengths are in a different unit from the one asked for.
feedback-jacobian_angles_locked = In this configuration, the first and the last angle turn about the same line: the angles have no rates, and there is no analytic Jacobian.
error-angles_locked = The first and the last of the angles { $axes } turn about the same line here: there is no analytic Jacobian. Choose other angles.
