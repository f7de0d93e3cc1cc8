"""The autograders of other systems, each spoken to by its own protocol.

Every module has `run`, which reads what its host puts into the container or onto standard input, and writes
what the host reads back. None needs a server or a network.
"""

from service.adapters.hosts import coderunner, gradescope, nbgrader, otter, prairielearn

HOSTS = {
    "gradescope": gradescope.run,
    "prairielearn": prairielearn.run,
    "coderunner": coderunner.run,
    "nbgrader": nbgrader.run,
    "otter": otter.run,
}
"""What `framewise grade --for` offers."""

__all__ = ["HOSTS"]
