"""What the machine lacks just now: memory, threads or files. That is no error of a request, and may pass."""

import errno
import logging

from service.http.problems import BusyError, busy

_SHORT = (errno.ENOMEM, errno.EAGAIN, errno.EMFILE, errno.ENFILE, errno.ENOSPC)
_NO_THREAD = "can't start new thread"
"""What CPython says where the system gives it none, by an error that has no kind of its own."""
_log = logging.getLogger("framewise")


def shortage(error: Exception, request_id: str) -> BusyError | None:
    """Return the refusal of a request that met a shortage, and log it; None if the error is another one."""
    if isinstance(error, OSError):
        is_short = error.errno in _SHORT
    else:
        is_short = isinstance(error, MemoryError) or _NO_THREAD in str(error)
    if not is_short:
        return None
    _log.error("request %s: the machine is short of something: %s", request_id, str(error) or "memory")
    return busy()
