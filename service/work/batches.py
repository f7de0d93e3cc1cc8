"""Batches: computed block by block in a thread, and sent while they are computed.

A caller who reads slowly gives the slot back, and waits in line again for the next block: otherwise as many
slow callers as there are slots would keep everybody else from theirs.
"""

import asyncio
from collections.abc import AsyncIterator, Iterator, Mapping

from starlette.requests import ClientDisconnect
from starlette.responses import StreamingResponse
from starlette.types import Message, Receive, Scope, Send

from service.http.problems import BusyError
from service.work.limiters import ThreadSlot

PATIENCE = 1.0
"""How long a caller may take over a block before the slot is given back [s]: long for any line, and short
beside the time that others may wait for theirs."""


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
        """Send.

        Raises:
            ClientDisconnect: the caller reads slowly, and there was no slot again for what is left.
        """
        loop = asyncio.get_running_loop()

        async def send_patiently(message: Message) -> None:
            patience = loop.call_later(PATIENCE, self._slot.release)
            try:
                await send(message)
            finally:
                patience.cancel()

        try:
            await super().__call__(scope, receive, send_patiently)
        except BusyError:
            raise ClientDisconnect from None
        finally:
            self._slot.release()


async def _computed(
    blocks: Iterator[bytes | memoryview], slot: ThreadSlot
) -> AsyncIterator[bytes | memoryview]:
    while True:
        await slot.regain()
        block = await slot.run(lambda: next(blocks, None))
        if block is None:
            return
        yield block
