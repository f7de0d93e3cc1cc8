"""The latest answers by what was asked, bounded by the bytes of both."""

from collections import OrderedDict

TOTAL_BYTES = 32 * 1024 * 1024
"""What all answers and questions may take together: some thousand closed forms of usual robots."""
LARGEST_BYTES = 1024 * 1024
"""An answer with its question above this is not cached: one of them would evict a thousand usual ones."""


class AnswerCache:
    """The latest answers, by what was asked."""

    def __init__(self) -> None:
        self._answers: OrderedDict[bytes, bytes] = OrderedDict()
        self._bytes = 0

    def get(self, question: bytes) -> bytes | None:
        """Return the answer to a question that was asked before."""
        answer = self._answers.get(question)
        if answer is not None:
            self._answers.move_to_end(question)
        return answer

    def put(self, question: bytes, answer: bytes) -> None:
        """Store an answer; the oldest ones are evicted for it."""
        size = len(question) + len(answer)
        if size > LARGEST_BYTES or question in self._answers:
            return
        self._answers[question] = answer
        self._bytes += size
        while self._bytes > TOTAL_BYTES:
            old_question, old_answer = self._answers.popitem(last=False)
            self._bytes -= len(old_question) + len(old_answer)
