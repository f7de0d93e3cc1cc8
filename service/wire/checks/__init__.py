"""What the calls `/check-…` read, and what they say."""
