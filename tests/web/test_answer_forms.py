"""Parts whose page is made from their own description: one exercise of each kind, filled in on a phone."""

import re
from collections.abc import Callable
from enum import Enum
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from exercises.definition import Part
from exercises.instance import generate
from exercises.parts.context import Context
from exercises.parts.protocol import Answer
from exercises.parts.registry import part_type
from exercises.parts.task import FieldShape, FormField
from service.messages import sentence
from tests.exercises.packaged import exercise, exercise_ids
from tests.web.axe import EVERYTHING
from tests.web.conftest import OpenPage, Watch
from tests.web.driving import all_right, submit, write


def context(exercise_id: str) -> tuple[Part, Context]:
    """Return the only part of an exercise with its usual values, and what it is judged by."""
    found = exercise(exercise_id)
    (part,) = found.parts
    answer = Answer(parts={}, angle_unit=found.angle_unit, length_unit=found.length_unit)
    return part, Context(instance=generate(found), answer=answer, verdict=None)


def one_of_each_kind() -> dict[str, str]:
    """Return by kind the first exercise that asks for it alone, in a form of its own description."""
    found: dict[str, str] = {}
    for exercise_id in exercise_ids:
        parts = exercise(exercise_id).parts
        if len(parts) == 1 and parts[0].kind not in found:
            part, known = context(exercise_id)
            if part_type(part.kind).task(part, known.instance).form:
                found[part.kind] = exercise_id
    return found


KINDS = one_of_each_kind()


def first_shape(kind: str) -> FieldShape:
    part, known = context(KINDS[kind])
    return part_type(kind).task(part, known.instance).form[0].shape


RELOADED = KINDS if EVERYTHING else set({first_shape(kind): kind for kind in sorted(KINDS)}.values())
"""What is stored is stored alike for every kind: one kind of each shape of a first field is opened again."""


def label(field: FormField) -> str:
    """Return what a field is called on the English page."""
    return sentence("en", f"field-{field.caption or field.name}", {}) or field.name


def typed(value: Any) -> str:
    """Return a cell as it is typed."""
    return str(value.value if isinstance(value, Enum) else value)


def fill(page: Page, fields: tuple[FormField, ...], answer: Any) -> None:
    """Write an answer into the form; what it leaves out stays empty."""
    for field in fields:
        value = getattr(answer, field.name)
        if value is None:
            continue
        if field.shape is FieldShape.CHOICE:
            page.get_by_label(label(field), exact=True).select_option(typed(value))
        elif field.shape is FieldShape.CELL:
            page.locator(".field", has_text=label(field)).locator("input").fill(typed(value))
        else:
            table = page.locator(f"fieldset.matrix-field:has(legend:text-is({label(field)!r}))")
            fill_rows(table, [value] if field.shape is FieldShape.VECTOR else value)


def fill_rows(table: Locator, rows: Any) -> None:
    """Write rows of cells, with as many rows as are needed."""
    for i, row in enumerate(rows):
        while table.locator("tbody tr").count() <= i:
            table.locator("button").click()
        write(table.locator("tbody tr").nth(i).locator("input"), [typed(value) for value in row])


def test_every_kind_with_such_a_form_is_tried() -> None:
    assert {
        "compare_tables",
        "find_mistake",
        "frame_mistake",
        "frame_chain",
        "inverse_kinematics",
        "jacobian",
        "jacobian_form",
        "matrix_mistake",
        "orientation",
        "screws",
        "singularities",
    } <= set(KINDS)


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_a_form_is_filled_in_and_judged(
    open_page: OpenPage, assert_accessible: Callable[[Page], None], kind: str
) -> None:
    part, known = context(KINDS[kind])
    page = open_page(f"/exercises/{KINDS[kind]}", width=390, height=844)
    fields = part_type(kind).task(part, known.instance).form
    fill(page, fields, part_type(kind).right(part, known))
    submit(page)
    expect(page.locator("#verdict")).to_contain_text("100 of 100 points")
    assert all_right(page)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert_accessible(page)
    if kind not in RELOADED:
        return
    before = page.locator(".matrix-field input, .field select").first.input_value()
    page.reload()
    expect(page.locator(".matrix-field input, .field select").first).to_have_value(before)


def test_places_to_look_at_again_are_named_once(open_page: OpenPage) -> None:
    """Each matrix by its name, its entries after it; what has no field of its own is no place to go to."""
    page = open_page("/exercises/twolink-dynamics")
    entries = page.locator("#part-equations_of_motion input")
    write(entries, ["m1*L1"] * entries.count())
    submit(page)
    report = page.locator(".part-report[data-kind=equations_of_motion]")
    places = report.locator("p.hint")
    expect(places).to_contain_text("Mass matrix M (1, 1) (1, 2)")
    expect(places).not_to_contain_text("skew")
    places.get_by_role("link", name="Mass matrix M (1, 2)").click()
    expect(page.get_by_role("textbox", name="Mass matrix M").nth(1)).to_be_focused()


def test_a_missing_order_is_asked_for_as_it_is_chosen(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("422")
    page = open_page("/exercises/scara-jacobian")
    page.locator("#part-jacobian input").first.fill("1")
    page.locator("button.primary").first.click()
    expect(page.locator("#part-jacobian")).to_contain_text("(v, ω) or (ω, v)")


def test_an_empty_answer_is_told_what_is_asked_by_its_name(open_page: OpenPage, watch: Watch) -> None:
    """It was told the name that the part has in requests: find_mistake."""
    watch.allow("status of 422")
    page = open_page("/exercises/puma560-find-mistake", lang="es")
    page.locator("form button[type=submit]").first.click()
    told = page.locator("#submit-problem [role=alert]")
    expect(told).to_have_text(re.compile("El ejercicio pide: [A-ZÁÉÍÓÚ]"))
    expect(told).not_to_contain_text("_")
