"""What a student hands in and a lecturer verifies, in the browser; links that carry signed settings."""

import io
import zipfile
from collections.abc import Callable
from pathlib import Path

from playwright.sync_api import Page, Route, expect

from tests.web.conftest import OpenPage, Watch
from tests.web.driving import PUMA, SCARA, put_table, submit, wrong


def taken(page: Page, name: str) -> str:
    """The receipt of the verdict that is shown, as text."""
    page.get_by_role("button", name="Get a receipt").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("Your name").fill(name)
    dialog.get_by_role("button", name="Get a receipt").click()
    text = dialog.get_by_label("Receipt as text")
    expect(text).to_be_visible()
    expect(dialog.get_by_alt_text("Receipt as a QR code")).to_be_visible()
    return text.input_value()


def test_a_receipt_is_taken_printed_and_verified_in_a_folder(
    open_page: OpenPage, assert_accessible: Callable[[Page], None], tmp_path: Path
) -> None:
    page = open_page("/exercises/scara")
    put_table(page, SCARA)
    submit(page)
    ann = taken(page, "Ann #let x = [0]")
    assert_accessible(page)
    with page.expect_download() as caught:
        page.get_by_role("button", name="Page to print (PDF)").click()
    printed = tmp_path / "ann.pdf"
    caught.value.save_as(printed)
    assert printed.read_bytes().startswith(b"%PDF-")
    page.get_by_role("dialog").get_by_role("button", name="Close").click()
    put_table(page, wrong(SCARA, 2, a="a2"))
    submit(page)
    bob = taken(page, "Bob")
    page = open_page("/receipts")
    (tmp_path / "ann.txt").write_text(
        "My receipt:\r\n" + "\r\n".join(ann[i : i + 70] for i in range(0, len(ann), 70))
    )
    (tmp_path / "both.txt").write_text(f"{bob}\n{bob[:-6]}abcdef\n")
    page.get_by_label("Files with receipts").set_input_files([tmp_path / "ann.txt", tmp_path / "both.txt"])
    result = page.locator("#folder-result")
    expect(result).to_contain_text("Genuine: 2 of 3 receipts.")
    expect(result.locator("tbody tr").nth(0)).to_contain_text("Ann #let x = [0]")
    expect(result.locator("tbody tr").nth(0)).to_contain_text("35 of 100 points")
    expect(result.locator("tbody tr").nth(1)).to_contain_text("17.5 of 100 points")
    expect(result.locator(".receipt-refused")).to_have_count(1)
    assert_accessible(page)
    for name in ("CSV for Moodle", "CSV for Canvas"):
        with page.expect_download() as caught:
            result.get_by_role("button", name=name).click()
        assert "Bob" in Path(caught.value.path()).read_text(encoding="utf-8")
    (tmp_path / "cyd.txt").write_text("hello")
    page = open_page("/receipts")
    result = page.locator("#folder-result")
    for _ in range(2):
        page.get_by_label("Files with receipts").set_input_files([printed, tmp_path / "cyd.txt"])
    expect(result.locator("tbody tr")).to_have_count(2)
    expect(result.locator("tbody tr").nth(0)).to_contain_text("35 of 100 points")
    expect(result.locator("tbody tr").nth(0)).to_contain_text("genuine")
    expect(result.locator("tbody tr").nth(1)).to_contain_text("cyd.txt")
    expect(result.locator("tbody tr").nth(1)).to_contain_text("This is not a receipt")


def test_a_receipt_on_a_slow_network_is_one_dialog(open_page: OpenPage, watch: Watch) -> None:
    """A second press opened a second dialog behind the first; without a network nothing was said."""
    page = open_page("/exercises/scara")
    put_table(page, SCARA)
    submit(page)
    button = page.get_by_role("button", name="Get a receipt")
    watch.allow("ERR_FAILED")
    page.route("**/receipt-dialog.js", lambda route: route.abort())
    button.click()
    expect(page.locator("#verdict .notice-problem")).to_be_visible()
    page.unroute_all()
    button.evaluate("button => { button.click(); button.click(); }")
    expect(page.get_by_role("dialog").get_by_label("Your name")).to_be_visible()
    expect(page.locator("dialog")).to_have_count(1)
    expect(page.locator("#verdict .notice-problem")).to_have_count(0)


def test_a_lecturers_link_switches_off_what_it_says(
    open_page: OpenPage, assert_accessible: Callable[[Page], None], watch: Watch
) -> None:
    page = open_page("/exercises/scara")
    sharing = page.locator("#sharing")
    sharing.locator("summary").click()
    for name in ("the playground", "the matrices of their own table", "the catalogue"):
        sharing.get_by_label(name).uncheck()
    sharing.get_by_label("What they are told about a wrong answer").select_option("row")
    sharing.get_by_label("Attempts").fill("2")
    assert_accessible(page)
    sharing.get_by_role("button", name="Make a link").click()
    url = sharing.get_by_label("Make a link").input_value()
    page = open_page(url[url.index("/exercises/") :])
    expect(page.locator(".bar-nav a")).to_have_text(["First lesson"])
    expect(page.locator("#sharing")).to_be_hidden()
    expect(page.locator("#own .own-matrices")).to_be_hidden()
    expect(page.get_by_label("If my answer is wrong, tell me").locator("option")).to_have_count(2)
    for a in ("a2", "0"):
        put_table(page, wrong(SCARA, 2, a=a))
        expect(page.locator("#own .own-status")).to_contain_text("4 joints")
        verdict = submit(page)
    assert page.evaluate("document.querySelector('#own robot-scene').model.frames.length") == 5
    expect(verdict.locator(".repairs, robot-scene")).to_have_count(0)
    watch.allow("status of 403")
    put_table(page, SCARA)
    page.locator("button[type=submit].primary").click()
    expect(page.locator("#answer")).to_contain_text("You have used all 2 attempts.")


def test_a_links_attempts_left_open_are_those_of_the_exercise(open_page: OpenPage) -> None:
    """The field said ∞, also of an exercise that allows five."""

    def limited(route: Route) -> None:
        told = route.fetch().json()
        route.fulfill(json={**told, "access": {**told["access"], "attempts": 5}})

    page = open_page(
        "/exercises/scara", before=lambda page: page.route("**/api/v1/exercises/scara*", limited)
    )
    page.locator("#sharing summary").click()
    expect(page.locator("#sharing").get_by_label("Attempts")).to_have_attribute("placeholder", "5")


def test_matrices_wait_for_the_parts_that_ask_for_them(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    put_table(page, PUMA)
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    page.locator(".own-matrices summary").click()
    expect(page.locator(".own-matrices")).to_contain_text("once the parts that ask for them are right")
    expect(page.locator("matrix-panel")).to_be_hidden()


def test_a_package_is_one_click_away(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    page.locator("#sharing summary").click()
    page.locator("#sharing").get_by_label("the playground").uncheck()
    for version in ("SCORM 1.2", "SCORM 2004"):
        with page.expect_download() as caught:
            page.locator("#sharing").get_by_role("button", name=version).click()
        package = zipfile.ZipFile(io.BytesIO(Path(caught.value.path()).read_bytes()))
        assert "imsmanifest.xml" in package.namelist()
        assert b"context=" in package.read("index.html")
