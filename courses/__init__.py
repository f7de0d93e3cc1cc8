"""Courses: people, links, attempts, drafts and grades, policies over time, statistics, and their storage.

Knows nothing of HTTP or LTI. A clock is handed in wherever time matters; policies are pure functions of what
was handed in and of that clock.
"""
