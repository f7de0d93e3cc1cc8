"""Whether a service keeps µEd 0.1.0: this checkout's, or the one at the address in `MUED_URL`."""
