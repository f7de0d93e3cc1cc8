"""Many receipts verified: what each says, and as entries of a gradebook."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from kinematics.errors import Fault
from service.adapters.gradebook import GradebookEntry
from service.http.problems import RequestError
from service.receipts.keys import ReceiptKeys
from service.receipts.receipt import Receipt, verify

_START = "eyJhbGciOiJFZERTQSI"  # How every receipt begins: `{"alg":"EdDSA"` in base64url.
_RECEIPT = re.compile(r"[\w-]+\.[\w-]+\.[\w-]{86}", re.ASCII)
"""Header, payload, and an Ed25519 signature of 64 bytes."""
_BREAK = re.compile(r"=?\r?\n[> ]*")
"""A line break of a mail: also a soft one (RFC 2045 §6.7) and one of a mail that is quoted."""
_SHOWN = 200  # Characters of what is no receipt that are shown.


@dataclass(frozen=True, kw_only=True, slots=True)
class CheckedReceipt:
    """One text that was handed in as a receipt.

    It is repeated if the same answer stands in another receipt beside it.
    """

    text: str
    receipt: Receipt | None = None
    fault: Fault | None = None
    repeated: bool = False


def receipts_in(text: str) -> list[str]:
    """Return the receipts in a text, such as a mail that broke them into lines; else the text itself."""
    found = [_START + piece for piece in "".join(_BREAK.sub("", text).split()).split(_START)[1:]]
    whole = [_RECEIPT.match(piece) for piece in found]
    pieces = [match[0] if match else piece[:_SHOWN] for match, piece in zip(whole, found, strict=True)]
    return pieces or [text.strip()[:_SHOWN]]


def check_receipts(texts: Sequence[str], keys: ReceiptKeys) -> list[CheckedReceipt]:
    """Verify receipts; line breaks and spaces that a mail program put in do no harm."""
    checked = [_check("".join(text.split()), keys) for text in texts]
    answers = Counter(_answer(entry.receipt) for entry in checked if entry.receipt)
    return [
        replace(entry, repeated=entry.receipt is not None and answers[_answer(entry.receipt)] > 1)
        for entry in checked
    ]


def entries_of(checked: Iterable[CheckedReceipt]) -> Iterator[GradebookEntry]:
    """Yield an entry for each receipt; one that is not ours has no points."""
    for entry in checked:
        receipt = entry.receipt
        if receipt is None:
            assert entry.fault is not None
            yield GradebookEntry(student="", exercise="", codes=(entry.fault.code,), source=entry.text[:40])
        else:
            yield GradebookEntry(
                student=receipt.name,
                exercise=receipt.exercise,
                points=receipt.points,
                max_points=receipt.max_points,
                correct=receipt.points >= receipt.max_points,
                codes=("answer_repeated",) if entry.repeated else (),
                feedback=receipt.time.isoformat(),
                source=entry.text[-12:],
            )


def _check(text: str, keys: ReceiptKeys) -> CheckedReceipt:
    try:
        return CheckedReceipt(text=text, receipt=verify(text, keys))
    except RequestError as error:
        return CheckedReceipt(text=text, fault=error.faults[0])


def _answer(receipt: Receipt) -> tuple[str, str, str | None]:
    return receipt.exercise, receipt.answer, receipt.seed
