"""Open edX's LTI consumer block in a process of its own."""
