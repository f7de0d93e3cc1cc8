"""The shapes of what is computed of a robot."""
