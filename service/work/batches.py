"""Batches: computed block by block in a thread, and sent while they are computed."""

from __future__ import annotations

from collections.abc import AsyncIterator, Iterator, Mapping

from starlette.responses import StreamingResponse
from starlette.types import Receive, Scope, Send

from service.work.limiters import ThreadSlot


class BatchResponse(StreamingResponse):
    """Sends blocks as they are computed; the slot is released when all is sent, or the caller has gone."""

    def __init__(
        self,
        blocks: Iterator[bytes | memoryview],
        slot: ThreadSlot,
        media_type: str,
        headers: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(_computed(blocks, slot), media_type=media_type, headers=headers)
        self._slot = slot

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send."""
        try:
            await super().__call__(scope, receive, send)
        finally:
            self._slot.release()


async def _computed(
    blocks: Iterator[bytes | memoryview], slot: ThreadSlot
) -> AsyncIterator[bytes | memoryview]:
    while True:
        block = await slot.run(lambda: next(blocks, None))
        if block is None:
            return
        yield block
