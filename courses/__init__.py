"""A course: people, links, attempts, drafts, grades and their policies, and where they are stored.

Knows what an exercise is and how it is judged (`exercises`); knows nothing of HTTP or LTI.
"""
