"""Receipts are signed, and nothing but what was signed is believed."""

import json
import random
import stat
from base64 import urlsafe_b64decode, urlsafe_b64encode
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest
from joserfc import jws
from joserfc.jwk import OctKey, OKPKey

from service.http.problems import RequestError, UnavailableError
from service.receipts.checking import receipts_in
from service.receipts.keys import ReceiptKeys, keys_of_secret, read_keys, rotate
from service.receipts.receipt import TYPE, PartScore, Receipt, answer_hash, issue, verify

KEYS = keys_of_secret(b"an installation's secret of 32 byte")
RECEIPT = Receipt(
    exercise="puma560",
    version=3,
    seed="s-17",
    name="Оксана Ș. <b>",
    points=52.5,
    max_points=100.0,
    parts={"table": PartScore(points=35.0, max_points=35.0, correct=True)},
    settings={"help": "row", "parts": ["table"]},
    answer=answer_hash({"table": {"rows": []}}),
    time=datetime(2026, 11, 22, 10, 30, tzinfo=UTC),
    service="https://dh.example.org",
)
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.=+/ "


def encoded(value: object) -> str:
    return urlsafe_b64encode(json.dumps(value).encode()).rstrip(b"=").decode()


def refused(token: str, keys: ReceiptKeys = KEYS) -> str:
    with pytest.raises(RequestError) as error:
        verify(token, keys)
    return error.value.faults[0].code


def test_a_receipt_says_what_was_signed() -> None:
    assert verify(issue(RECEIPT, KEYS), KEYS) == RECEIPT


def test_every_process_with_the_secret_verifies() -> None:
    same = keys_of_secret(b"an installation's secret of 32 byte")
    assert verify(issue(RECEIPT, KEYS), same) == RECEIPT
    assert refused(issue(RECEIPT, KEYS), keys_of_secret(b"another secret")) == "receipt_key_unknown"


def test_no_altered_receipt_is_believed() -> None:
    """Every one of 10 000 altered texts is refused, down to bits that base64 would pass over."""
    token = issue(RECEIPT, KEYS)
    rng = random.Random(8037)
    altered = 0
    while altered < 10_000:
        i = rng.randrange(len(token))
        kind = rng.randrange(4)
        if kind == 0:
            text = token[:i] + rng.choice(LETTERS) + token[i + 1 :]
        elif kind == 1:
            text = token[:i]
        elif kind == 2:
            text = token[:i] + rng.choice(LETTERS) + token[i:]
        else:
            text = token[:i] + token[i + 1 :]
        if text == token:
            continue
        altered += 1
        assert refused(text) in ("receipt_malformed", "receipt_altered", "receipt_key_unknown")


def test_forgeries_by_header_are_refused() -> None:
    head, payload, signature = issue(RECEIPT, KEYS).split(".")
    header = json.loads(urlsafe_b64decode(head + "=="))
    public = KEYS.signing.as_dict(private=False)
    stranger = OKPKey.generate_key("Ed25519")
    for change in (
        {"alg": "none"},
        {"alg": "HS256"},
        {"alg": "Ed25519"},
        {"typ": "JWT"},
        {"crit": ["exp"]},
        {"jwk": stranger.as_dict(private=False)},
        {"jku": "https://evil.example/keys"},
        {"kid": None},
        {"kid": "0"},
    ):
        assert refused(f"{encoded({**header, **change})}.{payload}.{signature}").startswith("receipt_")
    assert refused(f"{encoded({**header, 'alg': 'none'})}.{payload}.") == "receipt_malformed"
    symmetric = OctKey.import_key(json.dumps(public))
    forged = jws.serialize_compact({**header, "alg": "HS256"}, urlsafe_b64decode(payload + "=="), symmetric)
    assert refused(forged) == "receipt_malformed"
    # Another service's key under our key's name.
    other = ReceiptKeys(
        keys=(OKPKey.import_key({**stranger.as_dict(private=True), "kid": KEYS.signing.kid}),)
    )
    assert refused(issue(replace(RECEIPT, points=100.0), other)) == "receipt_altered"
    assert header["typ"] == TYPE


def test_keys_rotate_and_retire(tmp_path: Path) -> None:
    file = tmp_path / "receipt-keys.json"
    first = rotate(file)
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    old = issue(RECEIPT, first)
    second = rotate(file)
    assert second.signing.kid != first.signing.kid
    assert verify(old, read_keys(file)) == RECEIPT
    retired = rotate(file, retire=[str(first.signing.kid)])
    assert refused(old, retired) == "receipt_key_unknown"
    assert all("d" not in key for key in retired.public()["keys"])


def test_a_file_without_private_keys_is_no_key_file(tmp_path: Path) -> None:
    file = tmp_path / "keys.json"
    for text in ("{}", '{"keys": []}', json.dumps({"keys": [KEYS.signing.as_dict(private=False)]})):
        file.write_text(text)
        with pytest.raises(UnavailableError, match="key_file_unreadable"):
            read_keys(file)


def test_receipts_are_found_in_mails_and_lists() -> None:
    first, second = issue(RECEIPT, KEYS), issue(replace(RECEIPT, name="Bob"), KEYS)
    broken = "\n> ".join(first[i : i + 60] for i in range(0, len(first), 60)).replace("> ", "")
    mail = f"Dear professor,\n\n{broken}\n\nBest regards, Ann\n{second}\n"
    assert receipts_in(mail) == [first, second]
    assert receipts_in(f"{first}\n{second}") == [first, second]
    assert receipts_in("nothing here") == ["nothing here"]


@pytest.mark.parametrize("line_break", ["\n", "=\r\n", "\n> "])
def test_a_receipt_is_found_wherever_a_mail_program_broke_it(line_break: str) -> None:
    """The first letters of a receipt, too, may stand on the line before."""
    receipt = issue(RECEIPT, KEYS)
    broken = line_break.join((receipt[:9], receipt[9:70], receipt[70:]))
    assert receipts_in(f"My receipt: {broken}{line_break}Ann") == [receipt]
