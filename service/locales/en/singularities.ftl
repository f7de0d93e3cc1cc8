field-conditions = Conditions for a singularity
field-lost = A motion that is lost

task-singularities =
    The table of the robot is given. In which configurations does the arm lose a motion, that is, { $motion ->
        [translation] where does the Jacobian of the last origin’s velocity have less than its usual rank?
       *[twist] where does the Jacobian have less than its usual rank?
    } Write one condition in each row: a function that vanishes there (sin(q3)) or an equation (q3 = 0, π). Only the set of configurations counts, however you write it.{ $lost ->
        [yes] {" "}For the given configuration, write a vector λ ≠ 0 in the axes of frame 0 with λ · J q̇ = 0 whatever the joints do, at the last origin, lengths in { unit-word }: the motion that is lost.
       *[no] {""}
    }

feedback-singularities_right = The conditions hold exactly where the arm is singular, and nothing is missing.
feedback-singularities_missing = Families of singularities found: { $found } of { $count }.
feedback-singularity_missing_at = None of your conditions holds at this singular configuration: { $at }.
feedback-singularity_invented = Condition { $condition } also holds where the arm is not singular.
feedback-singularity_invented_at = Condition { $condition } holds at { $at }, where the arm is not singular.
feedback-singularity_rounded = Condition { $condition } comes close to a singularity, but not close enough: work with more decimal places.
feedback-singularity_sine_for_cosine = Condition { $condition } is a quarter turn off a singularity: sine and cosine have been exchanged.
feedback-singularity_half = Only a part of one family is found: mind the other solution of its equation (q = π besides q = 0, the folded arm besides the stretched one).
feedback-singularity_everywhere = Condition { $condition } always holds.
feedback-singularity_nowhere = Condition { $condition } never holds, so it says nothing.
feedback-conditions_missing = The conditions are missing.
feedback-lost_motion_missing = The lost motion is missing.
feedback-lost_motion_wrong = The vector is not a motion that is lost here.
feedback-lost_motion_is_kept = With this vector the arm still moves: λᵀJ is not zero.
feedback-lost_motion_zero = λ = 0 would do everywhere: give a vector that is not 0.
feedback-lost_motion_never = The arm moves this way in no configuration, so the motion is not lost just here.
error-conditions_empty = Give conditions or a lost motion.
error-condition_not_equation = { $text } is not a condition: write a function that vanishes or an equation with one = sign.
error-condition_angle_nonlinear = A joint angle outside a sine, cosine or tangent may stand only in an equation like q2 + q3 = π/2.
error-conditions_too_many = This cell holds more than { $limit } conditions.
error-condition_period = What is added k times has to be a turn divided by a whole number: 2π, π, π/2 …
error-singularities_no_families = No conditions can say where this arm is singular: it never is, or only in families of fewer dimensions. Choose the other motion or another robot.
error-not_singular = The arm is not singular in this configuration.
