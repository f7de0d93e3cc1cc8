"""The shapes of the calls `/check-…`."""
