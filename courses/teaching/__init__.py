"""What staff does and sees.

link_changes   exercise and rules, extra time, release of feedback; grades follow
regrading      stored attempts judged again by a mended exercise: looked at, then applied
settling       what follows from a regrading that counts, a few students at a time
statistics     how a class does
attempts_behind  the attempts behind a number
attempt_export  what a lecturer takes away as a file
course_erasure  courses that have ended: what each holds, and its erasure
"""
