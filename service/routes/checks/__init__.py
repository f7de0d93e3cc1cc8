"""Is somebody's answer right? The calls `/check-…`, one noun a file."""
