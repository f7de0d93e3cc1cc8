"""Exercises: what is asked, and how an answer is judged.

definition        what an exercise is
library           which exercises there are, each read once
loader            from a folder to an exercise: `definition_files` and `reading`, and for its pieces
                  `sample_reading`, `text_reading` with `statements`
consistency, needs  what must hold between the pieces
draws, instance   a student's own values
answers           what was handed in, read or refused; `names` that it may use
grader            an answer judged, part by part
grading           the DH table          (a package)
parts             everything else       (a package)
departure         where a wrong table leaves the robot
access            what students may use and be told
drawings          the figure of an instance
figures           how it is drawn       (a package)
written_table     a table as it would be typed
alternatives      other right tables
errors            what goes wrong, and where
selftest          an exercise tests itself (a package)
authoring         how one is made       (a package)
"""
