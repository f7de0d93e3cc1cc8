"""A connection to PostgreSQL that gives up where the server keeps silent: it is frozen, or the network cut.

The driver waits for an answer without end. The options of TCP would not do: the machine of a frozen server
still acknowledges what is sent.
"""

from __future__ import annotations

import contextlib
import time
from typing import Any, TypeVar

import psycopg
from psycopg import capabilities
from psycopg.abc import PQGen

ANSWER_SECONDS = 10.0
"""How long PostgreSQL may keep silent on a statement."""
_CANCEL_SECONDS = 1.0
"""How long it may take to hear that nobody waits for the statement any more."""

_Result = TypeVar("_Result")


class PostgresqlConnection(psycopg.Connection[Any]):
    """Ends itself when the server has said nothing for a time."""

    def wait(self, gen: PQGen[_Result], *args: Any, **kwargs: Any) -> _Result:
        """Have the driver exchange messages with the server.

        Raises:
            OperationalError: it keeps silent; what was not committed is undone when it is back.
        """
        return super().wait(self._while_it_answers(gen), *args, **kwargs)

    def _while_it_answers(self, gen: PQGen[_Result]) -> PQGen[_Result]:
        """Pass on what the driver waits for; it says several times a second whether anything has come."""
        heard = time.monotonic()
        try:
            wanted = next(gen)
            while True:
                ready = yield wanted
                if ready:
                    heard = time.monotonic()
                elif time.monotonic() - heard > ANSWER_SECONDS:
                    self._end()
                    raise psycopg.OperationalError(f"the server said nothing for {ANSWER_SECONDS:g} s")
                wanted = gen.send(ready)
        except StopIteration as end:
            found: _Result = end.value
            return found

    def _end(self) -> None:
        """Close the connection; a server that is only slow need not finish what nobody waits for."""
        if capabilities.has_cancel_safe():
            with contextlib.suppress(psycopg.Error):
                self.cancel_safe(timeout=_CANCEL_SECONDS)
        self.pgconn.finish()
