"""Fast evaluation: a table's computation is recorded once and replayed for thousands of configurations."""
