"""`python -m service`, or `framewise` where it is installed: see `service.cli`."""

import sys
from collections.abc import Sequence

from service.cli import commands


def main(arguments: Sequence[str] | None = None) -> None:
    """Run a subcommand, and end with its exit status unless that is 0."""
    status = commands.main(arguments)
    if status:
        sys.exit(status)


if __name__ == "__main__":
    main()
