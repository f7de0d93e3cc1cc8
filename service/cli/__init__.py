"""The command `framewise`: one module for each subcommand, listed in `commands.COMMANDS`.

A subcommand module has `add(subparsers)`, which declares its options and sets `run`: a function from the
parsed options to the exit status. What is wrong is raised as an error that carries faults, and `commands`
tells it.
"""
