"""Is the server on this machine alive? For a container: standard library only, exit code 0 or 1."""

import os
import sys
import urllib.error
import urllib.request

_TIMEOUT_SECONDS = 3.0  # Seconds after which a service that does not answer counts as down.


def main() -> int:
    """Ask the server on the configured port for its health."""
    port = int(os.environ.get("FRAMEWISE_PORT", "8000"))
    prefix = os.environ.get("FRAMEWISE_PREFIX", "").strip("/")
    address = f"http://127.0.0.1:{port}/{prefix}{'/' if prefix else ''}healthz"
    try:
        with urllib.request.urlopen(address, timeout=_TIMEOUT_SECONDS) as response:
            return 0 if response.status == 200 else 1
    except (urllib.error.URLError, OSError):
        return 1


if __name__ == "__main__":
    sys.exit(main())
