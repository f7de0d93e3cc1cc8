"""A connection to PostgreSQL that gives up where the server keeps silent: it is frozen, or the network cut.

The driver waits for an answer without end. The options of TCP would not do: the machine of a frozen server
still acknowledges what is sent. Nor does silence alone say that it is frozen: the statistics of a large class
take a while. So a second connection asks the server what it is doing.
"""

import contextlib
import time
from typing import Any, TypeVar

import psycopg
from psycopg import capabilities
from psycopg.abc import PQGen
from psycopg.conninfo import make_conninfo

_AT_WORK = """
    SELECT state = 'active' AND coalesce(wait_event_type, '') NOT IN ('Client', 'Lock')
    FROM pg_stat_activity WHERE pid = %s
"""
"""Who waits for us has answered, and the network is cut; who waits for a lock may do so without end."""

_Result = TypeVar("_Result")


class _Bounded(psycopg.Connection[Any]):
    """Ends itself when the server has said nothing for a time.

    The limits are those of a kind of connection, so that one of them can be changed without the other: the
    connection that asks whether the server works must not be the more impatient one.

    Attributes:
        answer_seconds: how long PostgreSQL may keep silent on a statement before it is asked whether it works
            on it.
        longest_seconds: how long it may work on a statement.
        cancel_seconds: how long it may take to hear that nobody waits for the statement any more.
    """

    answer_seconds = 10.0
    longest_seconds = 120.0
    cancel_seconds = 1.0

    def wait(self, gen: PQGen[_Result], *args: Any, **kwargs: Any) -> _Result:
        """Have the driver exchange messages with the server.

        Raises:
            OperationalError: it keeps silent; what was not committed is undone when it is back.
        """
        return super().wait(self._while_it_answers(gen), *args, **kwargs)

    def _while_it_answers(self, gen: PQGen[_Result]) -> PQGen[_Result]:
        """Pass on what the driver waits for; it says several times a second whether anything has come."""
        asked = heard = time.monotonic()
        try:
            wanted = next(gen)
            while True:
                ready = yield wanted
                if ready:
                    asked = heard = time.monotonic()
                elif time.monotonic() - asked > self.answer_seconds:
                    if time.monotonic() - heard > self.longest_seconds or not self._is_at_work():
                        self._end()
                        silence = time.monotonic() - heard
                        raise psycopg.OperationalError(f"the server said nothing for {silence:.0f} s")
                    asked = time.monotonic()
                wanted = gen.send(ready)
        except StopIteration as end:
            found: _Result = end.value
            return found

    def _is_at_work(self) -> bool:
        """Whether the server is known to work on what this connection waits for."""
        return False

    def _end(self) -> None:
        """Close the connection; a server that is only slow need not finish what nobody waits for."""
        if capabilities.has_cancel_safe():
            with contextlib.suppress(psycopg.Error):
                self.cancel_safe(timeout=self.cancel_seconds)
        self.pgconn.finish()


class PostgresqlConnection(_Bounded):
    """Ends itself when the server no longer works on what it was asked."""

    def _is_at_work(self) -> bool:
        """Ask the server by another connection."""
        address = make_conninfo(self.info.dsn, password=self.info.password or None)
        try:
            with _Bounded.connect(address) as another:
                found = another.execute(_AT_WORK, [self.info.backend_pid]).fetchone()
        except psycopg.Error:
            return False
        return found is not None and bool(found[0])
