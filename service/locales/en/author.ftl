error-text_markup = This is markup, which no text of an exercise may hold: { $found }. Write L1 < L2 with spaces.
error-text_too_long = The text is too long; at most { $limit } characters are allowed.
error-text_control_character = The text holds the control character { $found }, which cannot be seen. Delete it.
error-statement_not_text = The statement is not valid UTF-8 text.
error-draft_too_large = The definition is larger than one of a robot can be: a table or a list has at most { $entries } entries, all together have { $values }, and they are nested { $deepest } deep at most.
error-archive_too_large =
    The archive is too large; one exercise has at most { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-archive_not_zip = This is not a readable zip archive.
error-archive_too_many_files = The archive holds { $count } files; the folder of an exercise has at most { $limit }.
error-archive_entry = { $name } does not belong to an exercise: one folder with { $known } and statement.<language>.md files, and nothing else.
error-archive_method = { $name } is encrypted or compressed in a way that is not read here. Use a plain zip.
error-archive_file_too_large =
    { $name } is too large; a file of an exercise has at most { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-archive_no_exercise = The archive holds no exercise: one folder with { $known } is expected.
error-source_form = An exercise is started from one of { $known }.
error-drawing_too_many_axes = There are { $count } axes; at most { $limit } can be drawn.
error-drawing_too_many_lengths = There are { $count } named lengths; at most { $limit } are possible.
error-axis_not_before = { $before ->
    [0] No axis is drawn before this one, so axis { $axis } cannot be referred to.
    [one] Only axis 1 is drawn before this one, not axis { $axis }.
   *[other] Axis { $axis } is not among the { $before } axes drawn before this one.
}
error-length_unknown = { $name } is not a length of this drawing yet. Its lengths: { $known }.
error-draft_too_many_rows = The table has { $count } rows; in a draft it has at most { $limit }. A longer one can be written as a folder.
error-draft_without_table = The exercise asks for no DH table, so there are no tables to show. Add the part “DH table”.
error-publications_full = This service is full: it holds at most { $limit } published exercises. Download the folder instead.
author-title = Make an exercise
author-lead = Turn the arm in your own textbook into an exercise: draw it, or start from what you have. The exercise tests itself while you write.
author-card-start = The robot
author-card-texts = Title and statement
author-card-parts = What is asked
author-card-policy = What is free, what is fixed
author-card-values = Values
author-card-help = Help and attempts
author-card-figure = Figure
author-card-preview = Preview
author-card-trials = Try it
author-card-take = Download and publish
author-selftest = Self-test
author-start = Start from
author-start-robot = Catalogue
author-start-axes = Drawing
author-start-table = DH table
author-start-scm = SCM chain
author-start-urdf = URDF
author-start-robot-hint = A robot from the catalogue, with its table and dimensions.
author-start-axes-hint = Place the joint axes one after the other, base first, as the robot stands at zero. Lengths with a name become the dimensions of the figure; the table follows.
author-start-table-hint = The key as you would write it: numbers, or names such as L1. Lengths given as numbers are named automatically.
author-start-scm-hint = One row per joint: translations X Y Z and rotations A B C to the next joint; the joint’s variable stands in its own cell as q1, q2, …
author-start-urdf-hint = A file with one serial chain. Only joints are read, no meshes; the table ends at the last joint that moves, without the tool behind it.
author-robot = Robot
author-begin = Start with this robot
author-started = The exercise is ready to be written.
author-urdf-file = URDF file
author-scm-final = Final transformation
author-axes = Joint axes
author-axis = { $number } · { $joint }
author-axis-add = Add an axis
author-axis-added = Axis { $number } added.
author-axis-remove = Remove axis { $number }
author-axis-removed = Axis { $number } removed.
author-axis-joint = Type of joint { $number }
author-placed = Axis { $number } placed.
author-how = How
author-point = A point on the axis
author-point-at = at coordinates
author-point-on = on another axis
author-point-from = displaced from another axis
author-point-axis = Axis
author-point-distance = Distance along it
author-direction = Its direction
author-direction-vector = any vector
author-direction-through = through a further point
author-along = along { $axis }
author-parallel = parallel to axis { $axis }
author-opposite = opposite to axis { $axis }
author-perpendicular = perpendicular to axis { $axis }, towards …
author-across = perpendicular to axes { $axis } and { $other }
author-lengths-named = Named lengths
author-lengths-named-hint = Write a name such as L1 or a2 in any field above, also sums such as L1 + L2, and give its value here.
author-lengths-none = No length has a name yet.
author-scene = The axes in space
author-scene-hint = Click a point of the grid or of another axis to put the chosen axis there, an arrow to turn it, an axis to choose it. Everything can be done in the fields below, too.
author-scene-text = { $count ->
    [one] One joint axis
   *[other] { $count } joint axes
}, with the points and directions that can be clicked.
author-language = Language of the text
author-title-of = Title
author-statement = Statement
author-statement-hint = Markdown: paragraphs, lists, *emphasis*, **strong**, `code`. *L1* is set as a variable. What is asked and what is free need not be said: the service adds it in the reader’s language.
author-statement-preview = As students read it
author-statement-none = There is no text in this language yet: its readers are shown another language, and told so.
author-statement-waiting = A moment …
author-points = points
author-points-of = Points for { $part }
author-points-total =
    Altogether { $points ->
        [one] { $points } point
       *[other] { $points } points
    }.
author-rule-convention = Convention
author-rule-convention-any = either
author-rule-convention-standard = standard
author-rule-convention-modified = modified
author-rule-base = Frame 0
author-rule-base-free = anywhere
author-rule-base-axis = z as in the key
author-rule-base-origin = origin as in the key
author-rule-base-frame = exactly as in the key
author-rule-tool = Last frame
author-rule-tool-free = anywhere
author-rule-tool-point = origin at the marked point
author-rule-tool-axis = z on the last joint’s axis
author-rule-tool-frame = exactly as in the key
author-rule-zero = Zero of the variables
author-rule-zero-free = free
author-rule-zero-figure = as in the figure
author-rule-direction = Positive direction
author-rule-direction-free = free
author-rule-direction-figure = as in the figure
author-tolerance-length = Tolerance, as a share of the robot’s size
author-tolerance-angle = Tolerance of angles, rad
author-policy-admits = Of the { $choices } ways in which textbooks would write this robot’s table, { $admitted ->
    [one] one is
   *[other] { $admitted } are
} accepted. Frames between the joints are free in any case.
author-values-hint = Each student gets values of their own where a range is given; the usual value holds elsewhere.
author-values-none = The table has no named dimensions.
author-value = Usual value
author-drawn = drawn per student
author-draw-from = { $name } from
author-draw-to = { $name } to
author-draw-step = { $name } in steps of
author-draw-from-short = from
author-draw-to-short = to
author-draw-step-short = step
author-aliases = Other names for it
author-help-most = The most that students are told about a wrong table
author-help-ladder = little at first, more with every attempt
author-attempts = Attempts
author-access = What students may use while they work
author-access-hint = For students who come from a course link, the service itself refuses whatever is switched off.
author-access-catalogue = the catalogue of robots
author-access-playground = the playground
author-access-matrices = the matrices of a table
author-access-trainer = the frame trainer
author-view-azimuth = Viewed from: turn about the vertical
author-view-elevation = Viewed from: height
author-posture = Configuration in the figure
author-marks = Marked points
author-marks-hint = Needed if the rules hold the last frame to a point.
author-mark-end = mark the last origin as P
author-lengths = Dimensions drawn differently
author-lengths-hint = Give a small dimension another length in the figure, so that it reads well; the figure says that it is not to scale. Empty: as it is.
author-saved = kept in this browser
author-other-tab = This page is also open in another tab, and the draft has just been changed there. Only the draft that is changed last is kept.
author-test-waiting = Changed; the tests run in a moment.
author-test-refused = The tests run as soon as the faults above are corrected.
author-test-running = Testing: right answers in other frames, mistakes, every part …
author-test-passed = All { $passed } checks passed.
author-test-failed = { $failed ->
    [one] One check
   *[other] { $failed } checks
} failed, { $passed } passed.
author-test-warnings = Good to know:
author-try = Try it as a student
author-right = Show ten right answers that look different
author-right-shown = { $wrong ->
    [0] All { $count } are accepted; the first is your key.
   *[other] { $wrong } of { $count } are rejected.
}
author-wrong = Show the commonest wrong answers and their points
author-wrong-hint = The likeliest first: what a student would be told, and what the whole answer still earns. Add your own words where you like.
author-wrong-marks =
    { $points } of { $most ->
        [one] { $most } point
       *[other] { $most } points
    }, table { $score } %
author-wrong-refused = refused, costs no attempt
author-wrong-untold = No repair is suggested ({ $name }).
author-wrong-tested = the exercise tests itself with this mistake
author-own-words = Your own remark, shown after ours
author-id = Name of the folder
author-download = Download the folder
author-downloaded = The archive holds a folder for git and for “framewise exercises check”.
author-publish = Publish on this service
author-publish-closed = This service does not accept exercises from this page. Download the folder and give it to whoever runs the service.
author-published = Published. This version stays as it is for good; a change makes another one.
author-open = Open the exercise
author-insert = Insert it into the course
author-lti-hint = If your learning platform creates the link itself, add this custom parameter:
author-link = Copy a link to the draft
author-link-copied = The address now holds the whole draft, and has been copied.
author-import = Open a folder (zip)
author-import-hint = As it is downloaded here, or as you have it in git.
author-imported = The exercise is open.

## What a definition may say beside

author-add = Add: { $name }
author-remove = Remove { $name }
author-usual = default
author-dimension-handle = Dimension { $name }: drag it, or use the arrow keys; Backspace lets the service place it
author-dimension-hint = Drag the name of a dimension to where it reads well.
author-dimension-moved = { $name } moved.
author-dimension-free = { $name } is placed automatically again.
author-draw-without = without
author-part-keys = { $part }: what is given and asked
author-part-not-beside = Not together with “{ $part }”: one shows the answer to the other.
author-needs = Needed in every right answer
author-needs-hint = The rules have to ensure it: fix the base or the tool, otherwise a choice of frames can leave the dimension out.
author-rungs = Told at most
author-rung = at attempt { $number }
author-rung-more = One more rung
author-rung-less = One rung less
author-weights = What mistakes cost
author-weights-hint = Relative weights: a mistake with weight 2 costs twice as much as one with weight 1. Leave a field empty for the default.
author-weight-joint = a joint missing; of the wrong type, twice this
author-weight-twist = a twist α
author-weight-length = a length a
author-weight-offset = an offset d, or θ of a prismatic joint
author-weight-rule = a broken rule
author-weight-sign = only the sign, as a share
author-weight-row = a named mistake in a row, at most
author-weight-table = one throughout the table, at most
author-samples = Answers of your own to test with
author-samples-hint = The self-test judges them and reports where the verdict differs from what you expect. Try an answer as a student to keep it here.
author-sample = Sample
author-sample-key = the key
author-sample-name = What it shows
author-sample-expect = Expected
author-sample-correct = right
author-sample-incorrect = wrong
author-sample-invalid = refused
author-sample-feedback = Codes that the verdict contains
author-sample-keep = Keep this answer as a sample
author-sample-kept = Kept among the samples.
author-figure-more = Everything else about the figure
author-figure-upright = How frame 0 stands in the figure, degrees
author-figure-roll = roll
author-figure-pitch = pitch
author-figure-yaw = yaw
author-figure-width = Width of the paper
author-figure-points = Named points
author-figure-joints = Bodies of the joints
author-figure-name = Name
author-figure-at = at point
author-figure-label = number at the end
author-figure-scale = size
author-figure-reach = length of the axis
author-figure-links = Links
author-figure-links-hint = A chain of points on each line: O0 O1 P
author-figure-marks = All marked points
author-figure-ground = Ground
author-figure-normal = direction away from it, x y z
author-figure-gripper = Gripper
author-figure-away = away from point
author-figure-jaws = jaws side by side along, x y z
author-figure-dimension = Dimension
author-figure-value = length, if not the name
author-figure-offset = moved towards, x y z
author-figure-distance = how far
author-figure-distance-along = how far along it
author-figure-form = How
author-figure-frame = in a frame of the key
author-figure-between = between two points
author-figure-by = displaced
author-figure-joint = along a joint’s axis
author-figure-coordinates = coordinates
author-figure-ratio = at the fraction
author-figure-from = from point
author-key-joints = Joint values
author-key-turns = Angles drawn per student
author-key-slides = Displacements drawn per student
author-key-tolerance = Tolerance
author-key-point = Marked point
author-key-from = Distance from
author-key-limits = Joint limits
author-key-mistakes = Mistakes that may be planted
author-key-known = Known pose
author-key-asked = Asked: the pose
author-key-ask = What is asked
author-key-frame = In the axes of
author-key-axes = Order of the axes
author-key-turning = Turned about
author-key-asked_axes = Order of the axes that is asked for
author-key-asked_turning = Asked: turned about
author-key-wrench = Force and moment that the tool exerts
author-key-cases = Poses that may be asked for
author-key-solutions = Solutions asked for
author-key-reach = What has to be reached
author-key-given = Given as
author-key-angles = Angles
author-key-middle = Middle angle drawn from
author-choice-jacobian = the Jacobian
author-choice-forces = joint torques and forces
author-choice-base = frame 0
author-choice-end = the last frame
author-choice-reached = within reach
author-choice-out_of_reach = out of reach
author-choice-all = all
author-choice-one = one
author-choice-pose = position and orientation
author-choice-position = the position alone
author-choice-matrix = rotation matrix
author-choice-quaternion = quaternion
author-choice-axis_angle = axis and angle
author-choice-angles = three angles
author-choice-every_triple = every triple of angles
author-choice-current = the axes of the moving frame
author-choice-fixed = fixed axes
author-choice-axis = the axis of joint 1
author-key-one-joint = { $name } drawn by itself
author-version = Version: raise it when right answers or values change
author-variants = Sets of values for all students together
author-key-motion = Motion that counts
author-choice-twist = velocity and angular velocity
author-choice-translation = velocity alone
author-key-links = Links of the arm
author-key-gravity = Gravitational acceleration, in frame 0
author-key-weights = Symbols and their values
author-key-matrix = Matrix that is shown
author-choice-mass = the mass matrix M
author-choice-coriolis = a matrix C
author-choice-skew = that Ṁ − 2C is skew-symmetric
author-choice-velocity = C q̇ alone
author-choice-gravity = the gravity term g
author-choice-link = of one link
author-choice-transform = of the whole arm
author-body = Link { $number }
author-body-mass = mass
author-body-centre = centre of mass
author-body-moments = moments of inertia
author-quantity-name = Name of a quantity
author-quantity-value = value
author-quantity-draw = drawn per student
