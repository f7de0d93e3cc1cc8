"""A course: people who open links, attempts that they hand in, and grades that follow from them.

A learning management system, the *platform*, launches a *person* into a *link* of a *course*; the first
launch makes all three known. A link asks an exercise by rules of its own: how many attempts, until when,
which of them counts, what is shown of a verdict and when. What somebody hands in is judged, and stored as an
*attempt* before it is answered; it never changes afterwards. From the attempts and the rules follows the
*grade*, and from that the score that the platform's gradebook has to hear. Staff changes rules, judges
attempts again by a mended exercise, and looks at statistics: grades are derived anew in the transaction that
changed what they follow from, and no verdict is computed again to count something.

teaching    what staff does and sees: rules changed, attempts judged again, statistics, exports
attempts    what was typed and handed in, stored many at a time
grades      the judgement that counts, the grade that follows from it, and its way to the platform
people      platforms and launches, sessions, secrets; what people may ask for by law
links       what is asked and by which rules, as it is stored; published exercises
storage     the database: connections, transactions, relations and their history, backup
model       the records of all of them
policies    what attempts are worth, whether another one is taken, what is shown: pure functions
refusals    what goes wrong

Each of these knows only those below it; people and grades do not know each other. Nothing here knows of HTTP
or LTI. A clock is handed in wherever time matters.
"""
