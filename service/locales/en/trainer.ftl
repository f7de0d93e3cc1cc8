# The frame trainer.

trainer-title = Frame trainer
trainer-heading = Attach the frames
trainer-lead = Frame by frame, in the order in which it is taught: all z axes, the common normals, the origins, all x axes. Each step is checked when you finish it; then the DH table is read off.
trainer-back = Back to the exercise
trainer-frames = Frames
trainer-table = The table that follows
trainer-scene = Axes and frames
trainer-click = Click or drag an arrow or a point to choose it; the lists do the same.
trainer-complete = Every frame obeys the convention: the table is complete.
trainer-unfinished = A row appears as soon as both of its frames are complete and break no rule.
trainer-status =
    { $broken ->
        [0] No rule is broken so far.
        [one] One rule is broken.
       *[other] { $broken } rules are broken.
    }
trainer-step = Frame { $frame }: { $state }
trainer-state-open = not finished
trainer-state-whole = complete
trainer-state-broken = breaks a rule
trainer-part-z = Direction of z, frame { $frame }
trainer-part-origin = Origin, frame { $frame }
trainer-part-x = Direction of x, frame { $frame }
trainer-opposite = opposite:
trainer-candidate-foot = on axis { $axis }, at the foot of the normal to axis { $other }
trainer-candidate-intersection = where axes { $axis } and { $other } meet
trainer-candidate-level = on axis { $axis }, level with the origin of frame { $frame }
trainer-candidate-axis_point = on axis { $axis }, where the joint is drawn
trainer-candidate-base = as in the given base frame
trainer-candidate-tool = as in the given tool frame
trainer-candidate-coordinates =
    { $axis ->
        [1] along X of the figure’s coordinates
        [2] along Y of the figure’s coordinates
        [3] along Z of the figure’s coordinates
       *[other] the origin of the figure’s coordinates
    }
trainer-candidate-axis = along axis { $axis }
trainer-candidate-normal = along the normal of axes { $axis } and { $other }
trainer-candidate-frame_x = along x of frame { $frame }
trainer-candidate-across = at right angles to axis { $axis }

trainer-step-z = z axes
trainer-step-normals = Common normals
trainer-step-origin = Origins
trainer-step-x = x axes
trainer-step-read = Read off
trainer-task-z = For every frame choose the direction of z. It lies along the axis of a joint: which one depends on the convention.
trainer-task-normals = The common normals of neighbouring axes are drawn. Origins and x axes follow from them.
trainer-task-origin = For every frame choose the origin. The common normals are drawn.
trainer-task-x = For every frame choose the direction of x. It lies along the common normal to the next z axis, or at right angles to both z axes where they meet.
trainer-normal-skew = Axes { $axis } and { $other } are skew: they have one common normal, and it is drawn.
trainer-normal-meet = Axes { $axis } and { $other } intersect: x is at right angles to both, and the origin belongs at the point of intersection.
trainer-normal-parallel = Axes { $axis } and { $other } are parallel or on one line: every common normal will do; choose the one that makes d vanish.
trainer-check = Check this step
trainer-onward = Continue
trainer-restart = Start again
trainer-step-done = This step is right.
trainer-why-z =
    Every z lies along the axis of the joint that it belongs to: { $convention ->
        [standard] z of frame i−1 along axis i, because row i turns by θ and slides by d about and along z of frame i−1.
       *[modified] z of frame i along axis i, because row i ends with θ and d about and along z of frame i.
    }
trainer-why-origin = Every origin stands where the common normal meets its axis, because a is measured from there along x.
trainer-why-x = Every x lies along a common normal or at right angles to both axes, because a and α are measured along and about it.
trainer-open-choice = Frame { $frame } has no choice yet.
trainer-point-missed = The origin of frame { $frame } belongs at the marked point { $point }.
trainer-read = Press a row’s number: the picture shows how its four numbers carry one frame into the next.
trainer-take = Take the table into the exercise
