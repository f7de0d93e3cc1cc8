# The frame trainer.

trainer-title = Frame trainer
trainer-heading = Attach the frames
trainer-lead = For each frame choose the direction of z, the origin and the direction of x. Each rule is checked as you go, and the DH table follows from your frames.
trainer-back = Back to the exercise
trainer-frames = Frames
trainer-table = The table that follows
trainer-scene = Axes and frames
trainer-click = Click a point or an arrow to choose it; the lists do the same.
trainer-clear = Clear this frame
trainer-next = Next frame
trainer-complete = Every frame obeys the convention: the table is complete.
trainer-unfinished = A row appears as soon as both of its frames are complete and break no rule.
trainer-status =
    { $broken ->
        [0] No rule is broken so far.
        [one] One rule is broken.
       *[other] { $broken } rules are broken.
    }
trainer-open = Open the table in the playground
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
        [1] along x of the coordinates
        [2] along y of the coordinates
        [3] along z of the coordinates
       *[other] the origin of the coordinates
    }
trainer-candidate-axis = along axis { $axis }
trainer-candidate-normal = along the normal of axes { $axis } and { $other }
trainer-candidate-frame_x = along x of frame { $frame }
trainer-candidate-across = across axis { $axis }
