# The student web form: what every page says.

form-skip = Skip to the content
form-nav-label = Pages
form-nav-exercises = Exercises
form-nav-playground = Playground
form-language = Language
form-needs-script = This page needs JavaScript: it draws the robot and checks the table while you type.
form-unreachable = The service cannot be reached. What you typed is kept; try again in a moment.
form-retry = Try again
form-cancel = Cancel
form-close = Close
form-named = { $name }: { $said }
form-loading = Loading …

form-home-title = Exercises
form-home-heading = Describe the robot. Any valid choice of frames counts.
form-home-lead = Denavit–Hartenberg tables with a robot that moves while you type, and a checker that proves whether your table describes the same mechanism.
form-home-exercises = Exercises
form-home-subjects = Subjects
form-home-more = More
form-home-playground = Any table: poses, Jacobians, closed forms, conversions.
form-home-api = Programming interface
form-home-api-text = The same over HTTP, as an OpenAPI document.
form-home-best =
    Best: { $points } of { $total ->
        [one] { $total } point
       *[other] { $total } points
    }
form-home-joints =
    { $joints ->
        [one] One joint
       *[other] { $joints } joints
    }
form-home-trainer = Practise assigning frames

form-scene-role = 3-D view
form-scene-label = Robot
form-scene-tools = View
form-scene-view = Look from
form-scene-view-corner = Corner
form-scene-view-front = Front
form-scene-view-side = Side
form-scene-view-top = Top
form-scene-view-now = View: { $view }
form-scene-turn-left = Turn left
form-scene-turn-right = Turn right
form-scene-turn-up = Tilt up
form-scene-turn-down = Tilt down
form-scene-zoom-in = Zoom in
form-scene-zoom-out = Zoom out
form-scene-reset = Show everything
form-scene-keys = Arrow keys turn the view, Shift with arrow keys moves it, + and − zoom, 0 shows everything.

form-joint = Joint
form-joint-revolute = revolute
form-joint-prismatic = prismatic
form-joint-fixed = fixed
form-joint-of-row = Joint type, row { $row }
form-joint-turn = Joint angle { $name }
form-joint-slide = Joint displacement { $name }
form-joint-value = { $name } in { unit-word }
form-joints-reset = Reset the joints

form-convention = Convention
form-convention-standard = standard
form-convention-modified = modified
form-convention-now-standard = Your entries stay as they are and are now read in the standard convention: a and α belong to link i, joint i moves about z of frame i−1.
form-convention-now-modified = Your entries stay as they are and are now read in the modified convention: a and α belong to link i−1, joint i moves about z of frame i.
form-angle-unit = Unit of angles
form-degrees = degrees
form-radians = radians
form-length-unit = Unit of lengths
unit-word = { $unit ->
    [in] inches
   *[other] { $unit }
}
form-unit-now-deg = Numbers in the angle columns are now read as degrees.
form-unit-now-rad = Numbers in the angle columns are now read as radians.
form-unit-now-length = Numbers in the length columns are now read in { unit-word }.
form-unit-doubt-deg = { $value } rad is more than a whole turn. Are these angles in degrees?
form-unit-doubt-rad = { $value }° is a very small angle. Are these angles in radians?
form-unit-read-deg = Read them as degrees
form-unit-read-rad = Read them as radians
form-unit-convert = Convert the numbers
form-unit-converted = Numbers converted.
form-unit-converted-but =
    { $count ->
        [one] Numbers converted, except in one cell that is more than a sum: check it.
       *[other] Numbers converted, except in { $count } cells that are more than a sum: check them.
    }

form-table-caption = DH table, { $convention } convention
form-row-actions = Actions
form-row-add = Add a row
form-row-added = Row { $row } added
form-row-remove = Remove row { $row }
form-row-removed = Row { $row } removed
form-row-up = Move row { $row } up
form-row-down = Move row { $row } down
form-row-moved = Row { $row } is now row { $to }
form-row = row { $row }
form-column = column { $name }
form-row-cell = row { $row }, { $name }
form-cell-label = Row { $row }, { $name } [{ $unit }]
form-cell-empty = Empty: write 0 if it is zero.
form-refused = That did not work:
form-faults =
    { $count ->
        [one] One cell needs your attention:
       *[other] { $count } cells need your attention:
    }
form-undo = Undo
form-undone = Undone
form-redo = Redo
form-redone = Redone
form-symbols = Symbols
form-symbol-insert = Insert { $symbol }
form-keys = Arrow up and down change rows · Alt with an arrow moves the row · Alt+Enter adds one · Alt+Delete removes it · Ctrl+Z undoes.
form-paste-title = Paste a table
form-paste-label = A table from a spreadsheet, LaTeX, Markdown, a PDF, MATLAB or Python
form-paste-order = Columns without headings are read as: { $order }
form-paste-found =
    { $rows ->
        [one] One row found:
       *[other] { $rows } rows found:
    }
form-paste-nothing = No table is recognised in this text: each row needs the four DH parameters.
form-paste-preview = What was found
form-paste-apply = Use this table
form-pasted =
    { $rows ->
        [one] One row pasted.
       *[other] { $rows } rows pasted.
    }

form-matrix-mode = Matrices as
form-matrix-numbers = Numbers
form-matrix-symbols = Symbols
form-matrix-notation = Notation
form-matrix-short = short
form-matrix-full = full
form-matrix-none = The matrices appear as soon as every row can be read.
form-matrix-name = Pose of frame { $to } in frame { $from }
form-copy = Copy as
form-copy-group = Copy: { $what }
form-copied = Copied as { $format }
form-copy-failed = The browser does not allow copying

form-exercise-title = Exercise
form-exercise-task = Task
form-exercise-robot = The robot
form-exercise-description = Description in words
form-exercise-answer = Your answer
form-exercise-givens = Given
form-exercise-rules = What is free and what is fixed
form-figure-mode = Show the robot
form-figure-drawing = Drawing
form-figure-space = 3-D
form-figure-alt = Drawing of the robot: { $title }. A description in words follows.
form-figure-label = { $title } in space
form-figure-move = Move the joints
form-figure-posture = Measured from the configuration in the drawing.
form-choose = Choose …
form-choose-missing = Choose one.
form-points =
    { $points } of { $total ->
        [one] { $total } point
       *[other] { $total } points
    }
form-row-go = Go to row { $row }
form-row-heading = Row
form-row-missing =
    { $after ->
        [0] before 1
       *[other] after { $after }
    }
form-submit = Check my answer
form-submitting = Checking …
form-submit-hint = Ctrl+Enter does the same.
form-help = If my answer is wrong, tell me
form-help-verdict = only that it is
form-help-row = which rows are wrong
form-help-kind = what is wrong in each row
form-help-repair = what would make it right

form-part-table = DH table
form-part-schematic = Structure
form-part-link-matrices = Link matrices
form-part-transform = Pose of the last frame, in symbols
form-part-pose = Pose of the last frame, in numbers
form-part-workspace = Workspace
form-part-orientation = Orientation
form-part-rotation-check = Rotation or not
form-part-frame-chain = Chain of frames
form-part-inverse-kinematics = Inverse kinematics
form-part-find-mistake = Find the mistake
form-part-matrix-mistake = Find the mistake in a matrix
form-part-frame-mistake = Find the mistake in a figure
form-part-compare-tables = Two tables
form-part-screws = Product of exponentials
form-part-jacobian = Jacobian and statics
form-part-jacobian-form = Jacobian in closed form
form-part-singularities = Singularities
form-part-equations-of-motion = Equations of motion
form-part-wrong = To look at again:
form-radius-inner = Inner radius
form-radius-outer = Outer radius
form-matrix-cell = { $name }, row { $row }, column { $column }
form-schematic-joint = Joint { $joint }
form-schematic-relation = Axis { $joint } to axis { $next }
form-relation-coincident = coincident
form-relation-parallel = parallel
form-relation-intersecting-perpendicular = intersecting, perpendicular
form-relation-intersecting-oblique = intersecting, oblique
form-relation-skew-perpendicular = skew, perpendicular
form-relation-skew-oblique = skew, oblique

form-own-heading = Your robot
form-own-scene = Your robot, as your table describes it
form-own-empty = Your robot grows here with every row that can be read.
form-own-missing =
    { $count ->
        [one] One cell is still empty.
       *[other] { $count } cells are still empty.
    }
form-own-unread =
    { $count ->
        [one] One cell cannot be read yet.
       *[other] { $count } cells cannot be read yet.
    }
form-own-last = The picture shows the last table that could be read.
form-own-values = To draw your robot, give a value to: { $names }.
form-own-shown =
    { $joints ->
        [one] Drawn from your table: one joint.
       *[other] Drawn from your table: { $joints } joints.
    }
form-own-description = The frames of your table with their axes x, y and z.{ $count ->
    [0] {""}
   *[other] {" "}Joints: { $joints }.
}
form-own-parameters = Values for drawing
form-joints = Joints
form-matrices = Matrices

form-verdict-heading = Verdict
form-verdict-correct = Your table describes this robot.
form-verdict-wrong = Your table is not right yet.
form-verdict-all = Everything that you handed in is right.
form-verdict-some = Not everything is right yet.
form-verdict-outdated = You have changed your answer since.
form-basis-proved = Proved: the identity holds for all joint values.
form-basis-verified = Verified on many configurations.
form-links-caption = What is right in each row
form-fact-twist = Twist α
form-fact-length = Length a
form-fact-offset = Offset
form-fact-joint = Joint type
form-finding-ok = right
form-finding-wrong = wrong
form-finding-doubtful = perhaps wrong
form-finding-missing = missing
form-finding-unknown = open
form-finding-hidden = –
form-repairs = What would make it right
form-repair-or = or
form-both-label = The exercise’s robot and yours, moving together
form-both-text = Both robots move together: yours with your frames, the exercise’s in grey and orange.
form-both-description = Your frames lie on the exercise’s robot, and both follow the same motion.
form-both-position = Point of the motion
form-play = Play
form-pause = Pause

form-history-heading = Your attempts
form-history-restore = Put back into the form
form-history-restored = The attempt is back in the form
form-history-kept = Kept in this browser only.
form-history-clear = Clear history

form-missing-title = Not found
form-missing-text = There is no such page here. The exercises are all on the first page.
form-missing-home = Go to the exercises
form-storage-blocked = The browser stores nothing for this page: what you type is lost when you close or reload it.
form-other-tab = This exercise is also open in another tab, and something has just been typed there. Whatever is typed last is kept.
form-other-tab-take = Show what was typed there

form-row-play = Play row { $row } in the picture
form-film = The row as a film
form-film-hint = Put the cursor into a cell or press a row’s number: the film shows how the row’s four numbers carry frame i−1 into frame i.
form-film-none = Row { $row } cannot be shown yet: fill it and the rows before it.
form-film-play = Play the row
form-film-back = One step back
form-film-forward = One step forward
form-film-row-before = The row before
form-film-row-after = The next row
form-film-start = Row { $row }: it starts from frame { $frame }.
form-film-turn = Row { $row }, { $number } of 4: turn about { $axis } by { $letter } = { $value }.
form-film-slide = Row { $row }, { $number } of 4: move along { $axis } by { $letter } = { $value }.
form-scene-enlarge = Full screen
form-scene-record = Save as a picture
form-scene-recorded = Picture saved
form-own-rows =
    { $rows ->
        [one] Drawn so far: one row.
       *[other] Drawn so far: { $rows } rows.
    }

form-matrix-text = As text
form-matrix-text-label = { $name } as text: LaTeX, MATLAB, Python or cells of a spreadsheet
form-matrix-text-unread = No 4×4 matrix is recognised in this text.
form-name-unknown =
    { $known ->
        [none] { $name } is not a dimension of this robot; it has none with a name.
       *[other] { $name } is not a dimension of this robot. Its dimensions: { $names }.
    }

form-nav-lesson = First lesson
form-term = What does “{ $term }” mean?
form-convention-what = What are these?
form-exercise-write = Attach a frame to every link and write the DH table of this robot.

form-why = Why each row is right
form-why-row = Row { $row }: z{ $before } and z{ $row } are { $relation }, so α = { $alpha } and a = { $a }; along z the frames are d = { $d } apart.
form-second-table = A second valid table
form-second-other-convention = It is written in the { $convention } convention.
form-second-axis-reversed = A z axis points the opposite way, or a joint variable increases in the opposite direction.
form-second-x-turned = An x axis points elsewhere, so the variable of its joint is zero elsewhere.
form-second-origin-moved = An origin lies elsewhere on its axis.
form-second-none = The rules of this exercise leave no other table.

form-ghost-label = Your robot as a ghost over the exercise’s
form-ghost-text = The exercise’s robot is grey and orange, yours transparent red. Both make the same motion. The marked frame { $row }, the one of row { $row }, is the first that departs from the exercise’s robot.
form-ghost-description = Your robot coincides with the exercise’s before frame { $row }, which is marked: this is where the two diverge.
form-ghost-later = So many answers are being checked just now that the picture of where your robot departs from the exercise’s has not been drawn yet.
form-ghost-draw = Draw it now
form-ghost-none = Your robot cannot be drawn over the exercise’s.
form-new = New
form-new-done = Started a new, empty table.

form-progress = Progress
form-progress-open = not answered yet
form-progress-typed = not checked yet
form-part-missing = not handed in
form-part-empty = Nothing has been entered here yet.
form-submit-part = Check this part
form-points-for = A wrong table earns points for the twists, lengths and offsets that it gets right beyond what a table of zeros would. A joint that is missing or of the wrong type costs most, a wrong sign least.
form-help-steps = one hint at a time
form-help-principle = The principle.
form-help-worked = A worked step, on another robot.
form-help-next = To get the next hint, change your answer and check it again.
form-principle-twist = The twist α turns one z axis into the next, seen along the x axis that is perpendicular to both. Parallel z axes have 0° or 180°, perpendicular ones 90° or −90°; the right hand, its thumb along x, gives the sign.
form-principle-length = The length a is the distance between two neighbouring z axes along their common normal, which is the x axis. It is 0 if and only if the two lines meet.
form-principle-offset = The offset d is the distance along a z axis between the feet of two common normals: the one from the previous axis and the one to the next. Between parallel axes you may choose where the normal stands, but only once.
form-principle-joint = A revolute joint turns about its z axis, so its variable is θ; a prismatic joint slides along it, so its variable is d. Every joint has one row, in the order from the base to the tool.
form-worked-twist = A shoulder whose first axis is vertical and whose second axis is horizontal: the two z axes are perpendicular. With x pointing towards you, the right hand turns the vertical z into the horizontal one by −90° or by 90°, depending on the sense you gave z; so α = −90° or 90°, never 0.
form-worked-length = Two links in a plane, 0.4 m and 0.3 m long: both joint axes are vertical, 0.4 m apart. Their common normal is the first link, so a = 0.4 m. In a wrist whose axes meet in one point, each a is 0.
form-worked-offset = A shoulder stands 0.2 m to the side of the upright first axis, and the second axis is horizontal. Along the second axis, the foot of the normal from the first axis and that of the normal to the third are 0.2 m apart: d = 0.2 m, in the row of the second joint.
form-worked-joint = A gantry moves its carriage along a rail and turns the gripper below it. The rail is a prismatic joint: its row has the variable in d and a number in θ. The gripper is a revolute joint: its row has the variable in θ and a number in d.
form-home-author = Make an exercise
form-home-author-text = For lecturers: turn the arm in your own textbook into an exercise in a quarter of an hour.

form-matrices-withheld = The matrices appear here once the parts that ask for them are right.
form-sharing = For lecturers: links and packages
form-sharing-text = A link carries these settings in signed form: students who follow it cannot change them, and the service itself enforces them. A SCORM package goes into a course without an administrator; its score comes from the student’s browser, but the receipt in its comments cannot be forged.
form-sharing-may = Students may use
form-sharing-catalogue = the catalogue of robots
form-sharing-playground = the playground
form-sharing-matrices = the matrices of their own table
form-sharing-trainer = the frame trainer
form-sharing-help = What they are told about a wrong answer
form-sharing-attempts = Attempts
form-sharing-link = Make a link
form-sharing-receipts = Verify receipts
form-receipt = Get a receipt
form-receipt-text = A receipt states what this answer earned, signed by this service. Hand it in to your lecturer as text, as a QR code or as a printed page.
form-receipt-name = Your name, as your course knows it
form-receipt-as-text = Receipt as text
form-receipt-copy = Copy the text
form-receipt-qr = Receipt as a QR code
form-receipt-pdf = Page to print (PDF)

form-part-frames = Frames
form-frames-hint = Lengths in { unit-word }. A direction may have any length.
form-frames-scene = The robot with your frames
form-frames-drawn = Frames drawn: { $drawn } of { $all }.
form-frames-frame = Frame { $frame }
form-frames-z = z points
form-frames-origin = Origin
form-frames-x = x points
form-frames-z-of = z of frame { $frame }
form-frames-origin-of = origin of frame { $frame }
form-frames-x-of = x of frame { $frame }
form-frames-ends = where the first and the last frame lie
form-frames-typed = typed …
form-frames-at-joint = at the body of joint { $joint }
form-frames-at-point = at { $name }
form-frames-at-ground = where the robot is fixed
form-frames-along = along the axis of joint { $joint }
form-frames-against = against the axis of joint { $joint }
form-answer-empty = Nothing was handed in. The exercise asks for: { $parts }.
