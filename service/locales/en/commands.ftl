### What the self-test of an exercise tells its author.

check-counts = { $exercise }: { $passed ->
    [one] { $passed } check passed
   *[other] { $passed } checks passed
}, { $failed } failed, { $warnings ->
    [one] { $warnings } warning
   *[other] { $warnings } warnings
}
check-structure = Seed { $seed } changes the robot’s structure.
check-drawn_structure = A student may be given { $name } = { $value }, which changes the robot’s structure. Leave that value out (without), or draw from another range.
check-figure = Seed { $seed }: the figure cannot be drawn ({ $reason }).
check-right = A right table is rejected: { $table }
check-certificate = The certificate of a right table does not hold: { $table }
check-harmless = A wrong table is accepted: { $table }
check-mistake = The mistake { $mistake } is not explained in { $table }
check-part = Seed { $seed }: a right answer to the part { $part } is rejected.
check-follow_through = Seed { $seed }: what follows from a wrong table earns no points in the part { $part }.
check-wrong_part = Seed { $seed }: a wrong answer to the part { $part } is explained not as { $mistake } but as { $told }.
check-invalid = A malformed table is graded: { $name }.
check-sample = The sample “{ $name }” is not judged as expected; the verdict is: { $told }.
check-rounded = A right table rounded to { $digits } digits is rejected under the tool rule { $rule }: { $table }
check-tool_rule = A right table is rejected under the tool rule { $rule }: { $table }
check-crash = Seed { $seed }: grading fails: { $reason }
check-unneeded = No right answer needs { $name }: a student may choose frames in which it does not appear. { $rules ->
    [none] No rule of the policy changes that: leave it out of the statement.
   *[other] If answers are to contain it, each of these rules is enough: { $rules }. Otherwise leave it out of the statement.
}
check-alike = Some students may swap the numbers of { $name } and { $other } without being noticed: the two differ by no more than 1 %. Choose values, or ranges to draw from, that lie further apart.
check-taken_by_slide = In the row of joint { $joint }, { $name } under d means the joint variable, not the dimension. Students whose frames put the dimension there cannot write it. Give it another name.
check-taken_by_short_form = Where an answer is a formula, { $name } means a cosine or a sine, not the dimension. Give it another name.
check-no_joints = The robot has no joint: there is nothing to describe. Give a row of the table a joint.
check-nothing_earned = No wrong table earns anything: nothing that a table of zeros gets wrong about this robot carries any weight. Set other weights, or fix more in the policy.
check-asked_as_shown = The part { $kind } shows what it asks for. Ask for something else, or show it in another form.
check-gravity_not_down = In the figure, gravity as part { $kind } gives it does not point down. Turn frame 0 with upright, or change gravity.
check-frames_coincide = In the figure of part { $kind }, two frames have the same origin because a prismatic joint between them is drawn at zero. Give it another value in posture.
check-limits_ambiguous = The answer to part { $kind } depends on the direction in which a joint with limits increases, which students choose freely. Fix the directions (figure), or choose limits for which it makes no difference.
warm-counts = { $exercise }: { $values ->
    [one] { $values } set of values
   *[other] { $values } sets of values
} tested and drawn, { $figures ->
    [one] { $figures } figure
   *[other] { $figures } figures
}, { $forms ->
    [one] { $forms } closed form
   *[other] { $forms } closed forms
}, { $failed } failed, { $seconds } s
error-nothing_to_warm = There is no exercise, and no course with links, called { $name }.
error-variants_set = How many variants { $name } has is set in the exercise, or in the rules of the course’s links. Leave out --variants.
