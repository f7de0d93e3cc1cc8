"""The shapes of exercises, answers to them, and verdicts."""
