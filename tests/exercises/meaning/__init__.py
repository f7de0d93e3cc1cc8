"""Answers whose truth is known by other means, judged as they are handed in (`make campaign-answers`)."""
