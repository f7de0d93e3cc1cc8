"""A lecturer's own robot, in the browser alone: drawn, from a table, from URDF; by mouse and by keyboard."""

import io
import json
import re
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Locator, Page, Route, expect

from exercises.authoring.archive import draft_of_archive
from exercises.authoring.draft import exercise_of_draft
from exercises.selftest.checks import check_values
from service.settings import Settings
from tests.examples import DRAFT
from tests.live_service import running
from tests.web.axe import EVERYTHING
from tests.web.conftest import LANGUAGES, UNHURRIED, WITHOUT_FRAGMENT, OpenPage, Watch
from tests.web.driving import cell, put_table

PATIENCE = 120_000
UR5 = {"d1": "0.0892", "a2": "0.425", "a3": "0.392", "d4": "0.1093", "d5": "0.0948"}
URDF = """<robot name="arm">
  <link name="base"/><link name="upper"/><link name="lower"/><link name="hand"/>
  <joint name="waist" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.3"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="shoulder" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="0.1 0 0.2"/>
    <axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
  <joint name="elbow" type="revolute"><parent link="lower"/><child link="hand"/><origin xyz="0.4 0 0"/>
    <axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
</robot>"""


@pytest.fixture(scope="module")
def stored(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A service that can publish."""
    folder = tmp_path_factory.mktemp("data")
    with running(Settings(storage="on", data_folder=folder, **UNHURRIED)) as origin:
        yield origin


def start_with(page: Page, way: str) -> None:
    page.locator(f"#author-start input[value={way}]").check(force=True)


def place(page: Page, name: str) -> Locator:
    return page.locator(f"[data-field='{name}']")


def green(page: Page) -> None:
    """The self-test runs by itself and is green."""
    expect(page.locator(".author-selftest")).to_have_attribute("data-state", "passed", timeout=PATIENCE)


def downloaded(page: Page) -> bytes:
    with page.expect_download(timeout=PATIENCE) as caught:
        page.get_by_role("button", name="Download the folder").click()
    return Path(caught.value.path()).read_bytes()


def holds(archive: bytes, name: str, joints: int) -> None:
    """What was downloaded is an exercise, and passes its own tests outside of the browser, too."""
    draft = draft_of_archive(archive)
    assert draft.id == name
    exercise = exercise_of_draft(draft)
    assert exercise.reference.table.n_joints == joints
    assert not check_values((None, 1), exercise, 3).failures


def add_axis(page: Page) -> None:
    page.get_by_role("button", name="Add an axis").click()


def test_an_arm_of_six_axes_is_drawn(open_page: OpenPage) -> None:
    page = open_page("/author")
    start_with(page, "axes")
    expect(page.locator("robot-scene")).to_have_attribute("data-drawn", re.compile(r"\d+"))
    add_axis(page)
    place(page, "point").select_option("on")
    place(page, "at").fill("d1")
    place(page, "direction").select_option("perpendicular 1")
    add_axis(page)
    place(page, "by-x").fill("a2")
    add_axis(page)
    place(page, "by-x").fill("a3")
    place(page, "by-y").fill("-d4")
    add_axis(page)
    place(page, "direction").select_option("opposite 1")
    add_axis(page)
    place(page, "point").select_option("on")
    place(page, "on-axis").select_option("5")
    place(page, "at").fill("d5")
    place(page, "direction").select_option("parallel 2")
    for name, value in UR5.items():
        place(page, f"length-{name}").fill(value)
    table = page.locator("#author-start table")
    expect(table).to_contain_text("a3")
    expect(table.locator("tbody tr")).to_have_count(6)
    page.locator("[data-path='definition/title/en']").fill("The arm of chapter 3")
    page.locator("[data-path=id]").fill("chapter-3")
    # The drawing's last answer is in the draft, beside what was typed meanwhile.
    page.wait_for_function(f"() => localStorage.getItem('framewise:author').includes({UR5['d5']!r})")
    green(page)
    expect(page.locator("#author-policy")).to_contain_text("Of the 32 ways")
    archive = downloaded(page)
    holds(archive, "chapter-3", 6)
    rows = draft_of_archive(archive).definition["reference"]["rows"]
    assert [(row["a"], row["d"]) for row in rows] == [
        (0, "d1"),
        (0, 0),
        ("a2", 0),
        ("a3", "d4"),
        (0, "d5"),
        (0, 0),
    ]


POINT_OF = """(wanted) => {
  const { viewport } = document.querySelector("robot-scene"), box = viewport.getBoundingClientRect();
  for (let y = 2; y < box.height; y += 2)
    for (let x = 2; x < box.width; x += 2)
      if (viewport.closest("robot-scene").pickedAt(x, y) === wanted) return [box.left + x, box.top + y];
  return null;
}"""


def click_in_the_picture(page: Page, wanted: str) -> None:
    """Click what is called so, wherever the size of the picture and of its letters lets it stand."""
    page.locator("robot-scene").scroll_into_view_if_needed()
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    place = page.wait_for_function(POINT_OF, arg=wanted).json_value()
    # With its answer the picture is another one, in which the next point may stand elsewhere.
    with page.expect_event("requestfinished", lambda sent: sent.url.endswith("/author/start")):
        page.mouse.click(*place)


def test_an_axis_is_placed_with_the_mouse(open_page: OpenPage) -> None:
    """A click on an arrow turns the chosen axis, a click on a point moves it there."""
    page = open_page("/author")
    start_with(page, "axes")
    expect(page.locator("robot-scene")).to_have_attribute("data-drawn", re.compile(r"\d+"))
    expect(page.locator("#author-start table")).to_be_visible(timeout=PATIENCE)
    before = place(page, "direction").input_value()
    click_in_the_picture(page, "along 1")
    click_in_the_picture(page, "along 3")  # one of the two is none that it has
    expect(place(page, "direction")).not_to_have_value(before)
    expect(place(page, "point-x")).to_have_value("0")
    click_in_the_picture(page, "grid 1 1")
    expect(place(page, "point-x")).not_to_have_value("0")


def test_a_scara_from_a_table(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("422")  # the names' values are asked for
    page = open_page("/author")
    start_with(page, "table")
    expect(page.locator("dh-table-editor table")).to_be_visible()
    rows = [
        {"joint": "revolute", "theta": "q1", "d": "L0", "a": "L1", "alpha": "0"},
        {"joint": "revolute", "theta": "q2", "d": "0", "a": "L2", "alpha": "180"},
        {"joint": "prismatic", "theta": "0", "d": "d3", "a": "0", "alpha": "0"},
        {"joint": "revolute", "theta": "q4", "d": "0", "a": "0", "alpha": "0"},
    ]
    put_table(page, {"convention": "standard", "rows": rows})
    page.get_by_role("button", name="Start with this robot").click()
    for name, value in {"L0": "0.4", "L1": "0.35", "L2": "0.25"}.items():
        page.locator(f"[data-path='definition/parameters/{name}/value']").fill(value)
    page.locator("[data-path='definition/policy/tool']").select_option("free")
    green(page)
    holds(downloaded(page), "my-robot", 4)


def test_the_key_is_corrected_in_one_cell(open_page: OpenPage, watch: Watch) -> None:
    """The table of the draft is there to go on with, and what stood in the draft stays."""
    watch.allow("422")
    page = open_page("/author")
    start_with(page, "table")
    rows = [
        {"joint": "revolute", "theta": "q1", "d": "L1", "a": "0", "alpha": "β"},
        {"joint": "revolute", "theta": "q2", "d": "0", "a": "L2", "alpha": "0"},
    ]
    put_table(page, {"convention": "standard", "length_unit": "mm", "rows": rows})
    page.get_by_role("button", name="Start with this robot").click()
    value = {
        name: page.locator(f"[data-path='definition/parameters/{name}/value']")
        for name in ("L1", "L2", "beta")
    }
    expect(value["L1"]).to_have_value("300")  # millimetres
    expect(value["beta"]).to_have_value("30")  # degrees
    value["L1"].fill("450")
    page.locator("[data-path='definition/parameters/L1/draw/to']").fill("600")
    page.reload()
    page.locator("html[data-ready=true]").wait_for()
    expect(cell(page, 0, "d")).to_have_value("L1")
    cell(page, 1, "d").fill("L3")
    page.get_by_role("button", name="Start with this robot").click()
    expect(page.locator("[data-path='definition/parameters/L3/value']")).to_have_value("300")
    expect(value["L1"]).to_have_value("450")
    expect(page.locator("[data-path='definition/parameters/L1/draw/to']")).to_have_value("600")
    start_with(page, "scm")
    start_with(page, "table")
    expect(cell(page, 1, "d")).to_have_value("L3")


def test_what_is_wrong_with_a_typed_table_is_said_at_its_cells(open_page: OpenPage, watch: Watch) -> None:
    """Three times "This cell is empty" stood below the button, and nothing said which cells."""
    watch.allow("422")
    page = open_page("/author")
    start_with(page, "table")
    cell(page, 0, "a").fill("L1(")
    page.get_by_role("button", name="Start with this robot").click()
    summary = page.locator("dh-table-editor .editor-summary")
    expect(summary).to_contain_text("3 cells need your attention")
    expect(summary).to_be_focused()
    expect(page.locator("#author-start [role=alert]")).to_have_count(0)


def test_a_catalogue_robot_starts_with_its_own_name(open_page: OpenPage) -> None:
    """It was called "Robot my-robot"; a title that somebody wrote stays."""
    page = open_page("/author")
    title = page.locator("[data-path='definition/title/en']")
    for robot, name in {"puma560": "PUMA 560", "scorbot": "Scorbot"}.items():
        page.locator("#author-start select").select_option(robot)
        page.get_by_role("button", name="Start with this robot").click()
        expect(title).to_have_value(name)
        page.reload()
    title.fill("Exam")
    page.locator("#author-start select").select_option("cloos")
    page.get_by_role("button", name="Start with this robot").click()
    expect(page.locator("[data-path='definition/title/uk']")).to_have_count(0)
    expect(title).to_have_value("Exam")


def test_whoever_places_axes_by_keyboard_stays_where_they_are(open_page: OpenPage) -> None:
    """What was pressed was built anew, and the focus fell to the top of the page."""
    page = open_page("/author")
    start_with(page, "axes")
    axes = page.get_by_role("group", name="Joint axes")

    def press(control: Locator, key: str, then: Locator) -> None:
        control.focus()
        control.press(key)
        expect(then).to_be_focused()

    add = axes.get_by_role("button", name="Add an axis")
    press(add, "Enter", add)
    first = axes.get_by_role("button", name="1 · revolute")
    press(first, "Enter", first)
    prismatic = page.locator("[name=author-joint][value=prismatic]")
    press(page.locator("[name=author-joint]:checked"), "ArrowRight", prismatic)
    press(axes.get_by_role("button", name="Remove axis 2"), "Enter", add)
    start_with(page, "scm")
    first, second = (page.get_by_role("button", name=f"Remove row {row}") for row in (1, 2))
    press(second, "Enter", first)
    press(first, "Enter", page.get_by_role("button", name="Add a row"))


def test_an_arm_from_urdf(open_page: OpenPage) -> None:
    page = open_page("/author")
    start_with(page, "urdf")
    page.get_by_role("textbox", name="URDF").fill(URDF)
    page.get_by_role("button", name="Start with this robot").click()
    green(page)
    page.get_by_role("button", name="Show ten right answers").click()
    expect(page.locator("#author-right table")).to_have_count(10, timeout=PATIENCE)
    page.get_by_role("button", name="Show the commonest wrong").click()
    expect(page.locator(".author-mistake").first).to_be_visible(timeout=PATIENCE)
    holds(downloaded(page), "my-robot", 3)


def kept(page: Page) -> None:
    """Have two links in the browser as if they had been written there before."""
    work = json.dumps({"draft": DRAFT, "source": None})
    page.add_init_script(
        f"""if (location.protocol !== "about:" && !sessionStorage.getItem("kept")) {{
          sessionStorage.setItem("kept", "once");
          localStorage.setItem("framewise:author", {json.dumps(work)});
        }}"""
    )


def test_a_draft_stays_in_the_browser_and_in_its_link(open_page: OpenPage) -> None:
    page = open_page("/author", before=kept)
    title = page.locator("[data-path='definition/title/en']")
    title.fill("Two links, written over")
    page.get_by_role("button", name="Copy a link to the draft").click()
    page.wait_for_url(re.compile("#draft="))
    link = page.url
    page.evaluate("localStorage.clear()")
    page.goto("about:blank")
    page.goto(link)
    page.locator("html[data-ready=true]").wait_for()
    expect(title).to_have_value("Two links, written over")
    title.fill("Two links, and over again")
    expect(page).to_have_url(WITHOUT_FRAGMENT)  # by which a reload would bring back what was shared
    page.reload()
    page.locator("html[data-ready=true]").wait_for()
    expect(title).to_have_value("Two links, and over again")


def test_a_draft_that_somebody_shared_replaces_ones_own_in_a_step(open_page: OpenPage) -> None:
    """One that was opened where the page stood already was not looked at."""
    page = open_page("/author", before=kept)
    title = page.locator("[data-path='definition/title/en']")
    title.fill("The other draft")
    page.get_by_role("button", name="Copy a link to the draft").click()
    page.wait_for_url(re.compile("#draft="))
    link = page.url
    title.fill("One's own")
    page.goto(link)
    expect(title).to_have_value("The other draft")
    page.locator("#author-tools").get_by_role("button", name="Undo").click()
    expect(title).to_have_value("One's own")


def test_values_are_written_as_students_will_read_them(open_page: OpenPage) -> None:
    """The preview had a decimal point in every language."""
    page = open_page("/author", lang="fr", before=kept)
    expect(page.locator("#author-dimensions li").first).to_have_text(re.compile(r"= \d+,\d+ m$"))


def test_undo_takes_back_and_redo_brings_again(open_page: OpenPage) -> None:
    page = open_page("/author", before=kept)
    points = page.locator("[data-path='definition/parts/0/points']")
    points.fill("25")
    expect(page.locator("#author-parts")).to_contain_text("25 points")
    page.locator("#author-tools").get_by_role("button", name="Undo").click()
    expect(points).to_have_value("10")
    page.locator("#author-tools").get_by_role("button", name="Redo").click()
    expect(points).to_have_value("25")


def test_a_fault_is_told_at_its_field(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("422")
    page = open_page("/author", before=kept)
    title = page.locator("[data-path='definition/title/en']")
    title.fill("<svg onload=alert(1)>")
    expect(title).to_have_attribute("aria-invalid", "true")
    expect(page.locator("#author-problem")).to_contain_text("markup")
    title.fill("Two links")
    expect(title).not_to_have_attribute("aria-invalid", "true")


def test_a_fault_of_a_group_names_it_and_leads_to_it(open_page: OpenPage, watch: Watch) -> None:
    """Which of the dimensions has "no value to draw from" was not said, nor any field marked."""
    watch.allow("422")
    page = open_page("/author")
    start_with(page, "robot")
    page.get_by_label("Robot", exact=True).select_option("scara")
    page.get_by_role("button", name="Start with this robot").click()
    begin = page.locator("[data-path='definition/parameters/a3/draw/from']")
    begin.fill("9")
    link = page.locator("#author-problem a")
    expect(link).to_contain_text("a3: There is no value to draw from")
    expect(begin).to_have_attribute("aria-invalid", "true")
    link.click()
    expect(begin).to_be_focused()


def test_a_fault_of_a_list_or_of_a_length_leads_to_its_field(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("422")
    page = open_page("/author", before=kept)
    for path, text in {
        "definition/parameters/L1/aliases": "0",
        "definition/figure/marks": "nowhere",
        "definition/parameters/L2/value": "0",
    }.items():
        field = page.locator(f"[data-path='{path}']")
        before = field.input_value()
        field.fill(text)
        expect(field).to_have_attribute("aria-invalid", "true")
        page.locator("#author-problem a").click()
        expect(field).to_be_focused()
        field.fill(before)
        expect(field).not_to_have_attribute("aria-invalid", "true")


def test_the_exercise_is_tried_as_a_student(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("422")
    page = open_page("/author", before=kept)
    green(page)
    page.get_by_role("button", name="Show the commonest wrong").click()
    first = page.locator(".author-mistake textarea").first
    page.locator(".author-mistake:has(textarea) summary").first.click()
    code = first.get_attribute("data-remark")
    first.fill("My own words.")
    page.get_by_role("button", name="Try it as a student").click()
    page.locator("#author-try dh-table-editor table").wait_for()
    rows = [
        {"joint": "revolute", "theta": "q1", "d": "0", "a": "L1", "alpha": "0"},
        {"joint": "revolute", "theta": "q2", "d": "0", "a": "L2", "alpha": "0"},
    ]
    refused = [rows[0], {**rows[1], "a": "L2 + ellbow"}]
    put_table(page, {"convention": "standard", "rows": refused}, "#author-try dh-table-editor")
    page.locator("#author-try button[type=submit]").click()
    expect(page.locator("#author-try .editor-summary:focus")).to_contain_text("ellbow", timeout=PATIENCE)
    put_table(page, {"convention": "standard", "rows": rows}, "#author-try dh-table-editor")
    page.locator("#author-try button[type=submit]").click()
    expect(page.locator("#verdict .score-ring")).to_have_attribute(
        "aria-label", "10 of 10 points", timeout=PATIENCE
    )
    assert code


def test_an_imported_folder_opens(open_page: OpenPage, watch: Watch) -> None:
    """Before there is a draft, too; what is wrong in a folder is told with its file and key."""
    watch.allow("422")
    page = open_page("/author")
    scara = Path(__file__).parents[2] / "exercises" / "definitions" / "scara"
    files = {file.name: file.read_bytes() for file in scara.iterdir()}

    def choose(changed: dict[str, bytes]) -> None:
        stream = io.BytesIO()
        with zipfile.ZipFile(stream, "w") as archive:
            for name, content in {**files, **changed}.items():
                archive.writestr(f"scara/{name}", content)
        chosen = {"name": "scara.zip", "mimeType": "application/zip", "buffer": stream.getvalue()}
        page.get_by_label("Open a folder (zip)").set_input_files(chosen)  # type: ignore[arg-type]

    choose({"exercise.toml": files["exercise.toml"].replace(b"[figure]", b"[figure]\nwidht = 480", 1)})
    told = page.locator("#author-start .notice-problem")
    expect(told).to_contain_text("exercise.toml, figure.widht: ", timeout=PATIENCE)
    choose({})
    expect(page.locator("[data-path=id]")).to_have_value("scara", timeout=PATIENCE)
    with zipfile.ZipFile(io.BytesIO(downloaded(page))) as again:
        for name, content in files.items():
            assert again.read(f"scara/{name}") == content


def test_a_draft_is_published_and_opens_as_an_exercise(open_page: OpenPage, stored: str) -> None:
    page = open_page("/author", origin=stored, before=kept)
    page.get_by_role("button", name="Publish on this service").click()
    page.locator(".author-published").get_by_role("link", name="Open the exercise").click(timeout=PATIENCE)
    page.wait_for_url(re.compile("/exercises/two-links-[0-9a-f]{12}"))
    expect(page.locator("#exercise-title")).to_have_text("Two links")


def test_the_whole_flow_by_keyboard(open_page: OpenPage, watch: Watch) -> None:
    """Start, draw two axes with a named length, name the exercise and take it along, with keys alone."""
    watch.allow("422")  # a name that ends with a hyphen, while it is being typed
    page = open_page("/author")
    page.locator("#author-start input[value=robot]").focus()
    page.keyboard.press("ArrowRight")
    expect(place(page, "point")).to_be_visible()
    page.get_by_role("button", name="Add an axis").focus()
    page.keyboard.press("Enter")
    expect(page.locator(".author-axes [aria-pressed=true]")).to_contain_text("2")
    place(page, "by-x").focus()
    page.keyboard.press("Control+a")
    page.keyboard.type("L1")
    expect(place(page, "length-L1")).to_be_visible()
    place(page, "direction").focus()
    page.keyboard.press("ArrowDown")  # from parallel to opposite
    page.locator("[data-path=id]").focus()
    page.keyboard.press("Control+a")
    page.keyboard.type("by-keys")
    green(page)
    page.get_by_role("button", name="Download the folder").focus()
    with page.expect_download(timeout=PATIENCE) as caught:
        page.keyboard.press("Enter")
    holds(Path(caught.value.path()).read_bytes(), "by-keys", 2)


def test_nothing_keeps_anybody_out(
    open_page: OpenPage, assert_accessible_at_both_sizes: Callable[[Page], None]
) -> None:
    page = open_page("/author")
    assert_accessible_at_both_sizes(page)
    start_with(page, "axes")
    expect(page.locator("#author-start table")).to_be_visible(timeout=PATIENCE)
    add_axis(page)
    green(page)
    page.get_by_role("button", name="Show the commonest wrong").click()
    page.locator(".author-mistake").first.wait_for()
    page.evaluate("document.querySelectorAll('main details').forEach((details) => (details.open = true))")
    assert_accessible_at_both_sizes(page)


@pytest.mark.parametrize("language", LANGUAGES if EVERYTHING else ("fr", "uk"))
def test_the_page_speaks_every_language(open_page: OpenPage, language: str) -> None:
    page = open_page("/author", lang=language)
    start_with(page, "axes")
    expect(page.locator("#author-start table")).to_be_visible(timeout=PATIENCE)
    green(page)
    assert not re.findall(r"\bauthor-[a-z-]+|\bform-[a-z-]+", page.locator("main").inner_text())


def test_the_axis_whose_fields_are_shown_looks_chosen(open_page: OpenPage) -> None:
    page = open_page("/author")
    start_with(page, "axes")
    add_axis(page)
    look = "button => getComputedStyle(button).backgroundColor"
    axes = page.locator(".author-axes button[aria-pressed]")
    assert axes.nth(0).evaluate(look) != axes.nth(1).evaluate(look)
    axes.nth(0).click()
    expect(axes.nth(0)).to_have_attribute("aria-pressed", "true")
    assert axes.nth(0).evaluate(look) != axes.nth(1).evaluate(look)


def test_what_waits_is_said(open_page: OpenPage, watch: Watch) -> None:
    """Without a preview a text is not said to be missing, and no tests run in a moment."""
    watch.allow("ERR_FAILED")

    def without_preview(page: Page) -> None:
        kept(page)
        page.route("**/api/v1/author/preview", lambda route: route.abort())

    page = open_page("/author", before=without_preview)
    expect(page.locator(".author-reading")).to_have_text("A moment …")
    expect(page.locator(".author-selftest")).to_have_text(
        "The tests run as soon as the faults above are corrected."
    )


def test_a_busy_service_is_asked_again(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("503")
    answers = iter([503, 503])

    def busy(route: Route) -> None:
        if next(answers, None):
            route.fulfill(status=503, headers={"Retry-After": "1"}, json={"detail": "The server is busy."})
        else:
            route.continue_()

    def at_a_busy_service(page: Page) -> None:
        kept(page)
        page.route("**/api/v1/author/preview", busy)

    page = open_page("/author", before=at_a_busy_service)
    expect(page.locator("#author-name")).not_to_be_empty(timeout=PATIENCE)
    expect(page.locator("#author-problem")).to_be_empty()
