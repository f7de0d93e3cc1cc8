"""Is somebody's answer right? The calls `/check-…`, one kind of answer a file."""
