"""Receipts over HTTP."""

import csv
import io

import httpx
from joserfc import jws
from joserfc.jwk import KeySet

from service.receipts.checking import receipts_in
from service.receipts.keys import REGISTRY

RIGHT = {
    "table": {
        "convention": "standard",
        "angle_unit": "deg",
        "rows": [
            {"theta": "q1", "d": 0, "a": "L1", "alpha": 0},
            {"theta": "q2", "d": 0, "a": "L2", "alpha": 0},
        ],
    }
}
API = "/api/v1"


def issued(client: httpx.Client, name: str = "Ann", **answer: object) -> str:
    response = client.post(f"{API}/exercises/twolink/receipts", json={**RIGHT, "name": name, **answer})
    assert response.status_code == 200, response.text
    body = response.json()
    assert body["qr"].startswith("<svg")
    assert 0 < body["points"] <= body["max_points"]
    return str(body["receipt"])


def test_a_receipt_is_given_and_verified(client: httpx.Client) -> None:
    token = issued(client, help="verdict", seed="s1")
    response = client.post(f"{API}/receipts/verify", json={"receipts": [token, token[:-4], "hello"]})
    assert response.status_code == 200
    first, second, third = response.json()["receipts"]
    assert first["valid"]
    assert first["exercise"] == "twolink"
    assert first["name"] == "Ann"
    assert first["seed"] == "s1"
    assert first["settings"]["help"] == "verdict"
    assert first["parts"]["table"]["correct"]
    assert [second["valid"], third["valid"]] == [False, False]
    assert third["code"] == "receipt_malformed"
    assert third["message"].startswith("This is not a receipt")


def test_breaks_of_a_mail_program_do_no_harm_and_copies_are_seen(client: httpx.Client) -> None:
    ann, bob = issued(client, "Ann"), issued(client, "Bob")
    broken = "\r\n ".join(ann[i : i + 76] for i in range(0, len(ann), 76))
    checked = client.post(f"{API}/receipts/verify", json={"receipts": [broken, bob]}).json()["receipts"]
    assert [entry["valid"] for entry in checked] == [True, True]
    assert [entry["repeated"] for entry in checked] == [True, True]


def test_a_page_that_was_printed_to_a_file_is_a_receipt(client: httpx.Client) -> None:
    """A student handed in the PDF, and the lecturer was told that it is no receipt."""
    page = client.post(f"{API}/exercises/twolink/receipts.pdf", json={**RIGHT, "name": "Ann"})
    (found,) = receipts_in(page.content.decode("utf-8", errors="replace"))
    (said,) = client.post(f"{API}/receipts/verify", json={"receipts": [found]}).json()["receipts"]
    assert said["name"] == "Ann"


def test_a_receipt_too_long_for_a_code_is_given_without_one(client: httpx.Client) -> None:
    """A long name and a long seed of signs beyond ASCII, each within its limit, were answered with 500."""
    exercise, long = f"{API}/exercises/twolink", "\N{ROBOT FACE}" * 200
    link = client.post(f"{exercise}/links", json={"seed": long}).json()
    body, headers = {**RIGHT, "name": long}, {"X-Framewise-Context": link["context"]}
    answer = client.post(f"{exercise}/receipts", json=body, headers=headers)
    assert (answer.status_code, answer.json()["qr"]) == (200, "")
    page = client.post(f"{exercise}/receipts.pdf", json=body, headers=headers)
    assert page.content.startswith(b"%PDF")


def test_a_gradebook_file(client: httpx.Client) -> None:
    body = {"receipts": [issued(client)]}
    for form in ("csv", "moodle", "canvas"):
        response = client.post(f"{API}/receipts/verify", params={"format": form}, json=body)
        assert response.headers["content-type"].startswith("text/csv")
        assert any("Ann" in row for row in csv.reader(io.StringIO(response.text)))


def test_the_public_keys_verify_elsewhere(client: httpx.Client) -> None:
    token = issued(client)
    document = client.get(f"{API}/receipts/keys").json()
    assert all("d" not in key for key in document["keys"])
    keys = KeySet.import_key_set(document)
    assert b"twolink" in (jws.deserialize_compact(token, keys, registry=REGISTRY).payload or b"")


def test_what_cannot_be_graded_gets_no_receipt(client: httpx.Client) -> None:
    empty = {"table": {"convention": "standard", "rows": []}, "name": "Ann"}
    response = client.post(f"{API}/exercises/twolink/receipts", json=empty)
    assert response.status_code == 422
    assert response.json()["attempt_counted"] is False
    assert client.post(f"{API}/exercises/nowhere/receipts", json={**RIGHT, "name": "x"}).status_code == 404
    assert client.post(f"{API}/exercises/twolink/receipts", json=RIGHT).status_code == 422
