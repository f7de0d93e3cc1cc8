"""Exercises: making them, answering them, and what is handed to a course."""
