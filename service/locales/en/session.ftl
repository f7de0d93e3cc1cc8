### Launches from a course, and what a signed-in student reads.

session-launch-title = Opening the exercise
session-registration-title = Registering a learning platform
session-new-window = Open in a new window
session-registered = Framewise is registered with { $issuer }. An administrator of Framewise activates the registration; then links can be made.
session-registered-again = Framewise is registered with { $issuer } again; links work as before.
session-tool-description = Exercises in robot kinematics: every valid choice of frames is accepted, and wrong tables are explained.
session-heading = Your session
session-signed-in = Signed in as { $name } · { $course }
session-attempts = Attempts: { $made }
session-attempts-of = Attempts: { $made } of { $allowed }
session-hand-in = Hand in
session-hand-in-ready = Hand in what is ready
session-counting = { $counting ->
    [first] The first attempt counts
   *[last] The last attempt counts
}
session-penalty = Each further attempt costs { $percent } of all points
session-closes = Closes: { $when }
session-grade =
    Counted: { $points } of { $total ->
        [one] { $total } point
       *[other] { $total } points
    }
session-gradebook = For the gradebook: { $percent }
session-no-more = No attempts are accepted now
session-back = Back to the course
session-received = Attempt { $attempt } has been received and stored. The result will be shown later.
session-draft-other = What you typed last is shown. There is another version of your answer, from { $when }.
session-draft-take = Show the other version
session-exercise-changed = The exercise has been changed since an earlier attempt
session-attempt-then = Attempt { $attempt } was made before the exercise was changed. Its result refers to the exercise as it was then.
session-exercise-then = See the exercise as it was
session-opens = Opens: { $when }
session-late = Closed: attempts no longer count
session-handed-in = handed in
session-attempts-kept = Kept in your course.
session-attempts-latest = The latest { $count } are listed here.
session-ended = You are no longer signed in: answers that you give here do not count. Open the exercise from your course again; what you typed there is still there.
session-elsewhere = The link in your course has another exercise: answers to this one do not count.
session-elsewhere-go = Open the exercise of the course
session-launch-by-hand = Learning platforms send students here, so the address shows nothing by itself. Open the exercise from your course.
