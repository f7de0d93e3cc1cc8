"""An exercise tests itself: right answers in other frames, listed mistakes, malformed tables, every part.

answers     a table and all that follows from it, as a student would hand it in
variants    the key as other people would have written it: other frames, signs, zeros, conventions
mistakes    what students get wrong, done to a right table
structure   whether the values that students may have leave the robot what it is
robustness  rounded numbers, other rules, several mistakes at once
checks      all of it for one exercise over many seeds
rehearsal   what students will hand in and be told, for the author to look at
findings    what was found
"""
