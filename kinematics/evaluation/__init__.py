"""Fast evaluation: a table's computation is recorded once and replayed for thousands of configurations.

recurrences    along a serial chain, for any kind of number
tape           what was done to the numbers, recorded
straight_line  a tape as a Python function, for one configuration
blocks         a tape run on arrays
plan           what is kept of a table
"""
