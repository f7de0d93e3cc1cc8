"""The model exercises, from an empty form to full marks."""

from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.conftest import EXPLORE
from tests.web.answers import ANSWERS, link_matrices, pose, transform
from tests.web.conftest import OpenPage
from tests.web.driving import all_right, fill_matrix, fill_table, open_part, submit


def fill_everything(page: Page, answer: dict[str, Any]) -> None:
    table = answer["table"]
    fill_table(page, table)
    part = open_part(page, "schematic")
    joints, relations = answer["schematic"]
    for i, kind in enumerate(joints):
        part.get_by_label(f"Joint {i + 1}", exact=True).select_option(kind)
    for i, relation in enumerate(relations):
        part.get_by_label(f"Axis {i + 1} to axis {i + 2}").select_option(relation)
    for i, matrix in enumerate(link_matrices(table)):
        fill_matrix(open_part(page, "link_matrices").locator(".matrix-field").nth(i), matrix)
    fill_matrix(open_part(page, "transform"), transform(table))
    fill_matrix(open_part(page, "pose"), pose(table, answer["values"], answer["joints"]))
    inner, outer = answer["radii"]
    part = open_part(page, "workspace")
    part.get_by_label("Inner radius").fill(f"{inner:.5f}")
    part.get_by_label("Outer radius").fill(f"{outer:.5f}")


@pytest.mark.parametrize("exercise", ANSWERS if EXPLORE else ["scara"])
def test_from_an_empty_form_to_full_marks(open_page: OpenPage, exercise: str) -> None:
    page = open_page(f"/exercises/{exercise}", webgl=exercise == "scara")
    fill_everything(page, ANSWERS[exercise])
    submit(page)
    failed = page.locator("#verdict .part-report:has(.badge.bad), #verdict .part-report:has(.badge.warn)")
    assert failed.all_inner_texts() == []
    assert all_right(page)
    expect(page.locator("#verdict")).to_contain_text("Your table describes this robot.")
    expect(page.locator("#verdict")).to_contain_text("100 of 100 points")
    expect(page.locator("#verdict robot-scene")).to_be_visible()
    expect(page.locator("#history .badge.good")).to_have_text("100 of 100 points")


def test_the_list_leads_to_its_subjects(open_page: OpenPage) -> None:
    page = open_page("/")
    subjects = page.get_by_role("navigation", name="Subjects").get_by_role("link")
    names = subjects.all_inner_texts()
    assert (names[0].split()[:2], len(names)) == (["DH", "table"], page.locator("#exercises section").count())
    counts = [int(name.split()[-1]) for name in names]
    assert counts == [section.locator("li").count() for section in page.locator("#exercises section").all()]
    subjects.filter(has_text="Singularities").click()
    expect(page.get_by_role("heading", name="Singularities", exact=True)).to_be_in_viewport()
    page.reload()
    expect(page.get_by_role("heading", name="Singularities", exact=True)).to_be_in_viewport()
