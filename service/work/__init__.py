"""Where work is done: limiters in front of threads, worker processes, batches sent while computed."""
