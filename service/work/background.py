"""A thread of a process that does something again and again, until the process ends."""

from __future__ import annotations

import threading
from abc import ABC, abstractmethod

_LONGEST_END = 30.0
"""Time that what is under way has to come to its end [s]: longer than any call to a platform."""


class BackgroundThread(ABC):
    """Something that goes on beside the requests.

    Attributes:
        stopping: set when it is to end; to be waited for between two turns.
    """

    def __init__(self, name: str) -> None:
        self.stopping = threading.Event()
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def stop(self) -> None:
        """Finish what is under way, and end."""
        self.stopping.set()
        if self._thread.is_alive():
            self._thread.join(timeout=_LONGEST_END)

    @abstractmethod
    def _run(self) -> None:
        """Go on until `stopping` is set."""
