"""Exercises, and answers of students.

exercise_views, figure_files       exercises and their figures
drafts                             what authors are shown
verdicts, ungraded                 what is said of answers, and what is refused
"""
