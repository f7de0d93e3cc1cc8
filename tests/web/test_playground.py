"""The playground in a real browser: ways to a table, answers, links, languages, sizes, accessibility."""

import base64
import json
import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, Request, Response, expect

from tests.web.conftest import WITHOUT_FRAGMENT, OpenPage, Watch, wait_ready
from tests.web.driving import Held, put_table, rows
from tests.web.test_accessibility import assert_accessible_at_any_width

STANFORD_ALPHAS = ["0", "-90", "90", "0", "-90", "90"]


def shown_robot(page: Page) -> None:
    """Wait until the table's robot stands in the scene."""
    expect(page.locator(".own-status")).to_contain_text(re.compile(r"\d"))
    expect(page.locator("joint-sliders input[type=range]").first).to_be_visible()


def column(page: Page, cell: str) -> list[str]:
    return page.locator("dh-table-editor").evaluate(
        "(editor, cell) => editor.table.rows.map((row) => String(row[cell]))", cell
    )


def opened(page: Page, heading: str) -> None:
    page.locator("summary", has_text=re.compile(f"^{heading}$")).click()


def test_pose_and_jacobian_follow_the_joints(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Pose of the end frame")
    opened(page, "Jacobian")
    position = page.locator(".tool", has_text="Pose of the end frame").locator("dd").first
    expect(position).to_contain_text("0.4521")
    singular = page.locator(".tool", has_text="Jacobian").locator("dd").nth(1)
    expect(singular).to_have_text("yes")
    page.locator("joint-sliders .joint-number input").nth(4).fill("45")
    page.locator("joint-sliders .joint-number input").nth(2).fill("-30")
    expect(singular).to_have_text("no")
    expect(position).not_to_contain_text("0.4521")


def test_a_catalogue_robot_with_its_configurations(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    page.get_by_label("Robot from the catalogue").select_option("stanford")
    page.wait_for_function("() => document.querySelector('dh-table-editor').table.rows[1].alpha == -90")
    assert column(page, "alpha") == STANFORD_ALPHAS
    page.get_by_text("Where its numbers come from").click()
    expect(page.locator("#table-body details")).to_contain_text("Nascimento")
    page.get_by_role("button", name="the arm lies along x0").first.click()
    expect(page.locator("joint-sliders .joint-number input").nth(2)).to_have_value("0.5")


def asked_of(request: Request) -> tuple[int, int, set[str], set[str]]:
    """A request's joints and those that its table has, its values and the parameters that its table names."""
    body = json.loads(request.post_data or "{}")
    rows = body["table"]["rows"]
    cells = " ".join(str(row[name]) for row in rows for name in ("alpha", "a", "d", "theta"))
    named = set(re.findall(r"(?<![A-Za-z])[A-Z]\w*|(?<!\w)[ad]\d", cells))
    return len(body["joints"]), sum(row["joint"] != "fixed" for row in rows), set(body["parameters"]), named


@pytest.mark.parametrize("newest_first", [False, True], ids=["in order", "in reverse"])
def test_no_request_mixes_two_robots(open_page: OpenPage, newest_first: bool) -> None:
    """Robots are chosen while poses of the ones before are asked for and wait to be asked for."""
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Pose of the end frame")
    opened(page, "Workspace")
    position = page.locator(".tool", has_text="Pose of the end frame").locator("dd").first
    expect(position).to_contain_text("0.4521")
    page.wait_for_load_state("networkidle")
    asked: list[Request] = []
    refused: list[Response] = []
    page.on("request", lambda request: asked.append(request))
    page.on("response", lambda answer: refused.append(answer) if answer.status >= 400 else None)
    poses, tables = Held(page, "**/forward-kinematics"), Held(page, "**/understand")
    for robot, joints in (("stanford", 6), ("scara", 4), ("twolink", 2)):
        for angle in ("10", "20", "30"):
            page.get_by_label("Joint angle q1").fill(angle)
        poses.until(1)
        with page.expect_request("**/understand"):
            page.get_by_label("Robot from the catalogue").select_option(robot)
        tables.until(1)
        poses.let_go(-1 if newest_first else 0)
        tables.let_go()
        expect(page.locator(f"joint-sliders:has(.joint-line:nth-child({joints}))")).to_be_attached()
        while poses.waiting:
            poses.let_go(-1 if newest_first else 0)
            page.wait_for_timeout(150)
        expect(page.locator("joint-sliders .joint-line")).to_have_count(joints)
    poses.stop()
    tables.stop()
    expect(position).to_have_text(re.compile(r"^2\s+0\s+0 m$|^\S+\s+0\s+0 m$"))
    page.wait_for_load_state("networkidle")
    sent = [asked_of(request) for request in asked if request.url.endswith("/forward-kinematics")]
    assert len(sent) >= 3
    assert [(joints, values) for joints, _, values, _ in sent] == [
        (rows, named) for _, rows, _, named in sent
    ]
    assert [(answer.request.post_data, answer.text()) for answer in refused] == []


@pytest.mark.parametrize("first", [0, 1], ids=["in order", "in reverse"])
def test_of_two_robots_that_were_chosen_the_last_one_comes(open_page: OpenPage, first: int) -> None:
    page = open_page("/playground")
    shown_robot(page)
    held = Held(page, re.compile(r"/robots/(stanford|scara)$"))
    choice = page.get_by_label("Robot from the catalogue")
    choice.select_option("stanford")
    held.until(1)
    choice.select_option("scara")
    held.until(2)
    held.let_go(first)
    held.stop()
    expect(page.locator("joint-sliders .joint-name")).to_have_count(4)
    page.wait_for_load_state("networkidle")
    assert len(column(page, "a")) == 4


def test_a_robot_that_comes_late_does_not_overwrite_what_was_typed(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    held = Held(page, re.compile(r"/robots/stanford$"))
    page.get_by_label("Robot from the catalogue").select_option("stanford")
    held.until(1)
    page.get_by_label(re.compile(r"^Row 2, a")).fill("0.5")
    held.stop()
    page.wait_for_load_state("networkidle")
    assert column(page, "a")[1] == "0.5"


def test_a_slide_without_limits_is_asked_for_its_range(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    page.get_by_label("Robot from the catalogue").select_option("stanford")
    opened(page, "Workspace")
    expect(page.locator(".tool", has_text="Workspace").last).to_contain_text("Give each prismatic joint")
    opened(page, "Joint limits")
    reach = page.locator(".tool", has_text="Outer radius").locator("dd").nth(1)
    page.get_by_label("Least value of q3 in m").fill("0")
    page.get_by_label("Greatest value of q3 in m").fill("1")
    # The hand reaches 1 m + 0.263 m from the shoulder, 0.154 m beside the first axis.
    expect(reach).to_have_text(re.compile(r"^1\.27"))
    slider = page.get_by_label(re.compile("Joint displacement q3"))
    expect(slider).to_have_attribute("max", "1")
    page.get_by_label("Greatest value of q3 in m").fill("")
    expect(page.locator(".tool", has_text="Workspace").last).to_contain_text("Give each prismatic joint")


def test_the_workspace_is_asked_for_once_however_the_joints_move(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url.rsplit("/", 1)[1]))
    opened(page, "Workspace")
    opened(page, "Pose of the end frame")
    expect(page.locator(".tool", has_text="Workspace").locator("dd").first).to_be_visible()
    position = page.locator(".tool", has_text="Pose of the end frame").locator("dd").first
    page.get_by_label("Joint angle q1").fill("90")
    expect(position).to_have_text(re.compile(r"^0\.15(01)?\s+0\.4521"))
    page.wait_for_load_state("networkidle")
    assert asked.count("workspace") == 1


def test_a_pose_to_reach_without_a_number_is_told_at_its_cell(open_page: OpenPage, watch: Watch) -> None:
    """It was “target[0][3]” must be a number; the present pose, or a number, takes it away."""
    watch.allow("422")
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Inverse kinematics")
    tool = page.locator("details.tool", has_text="Inverse kinematics")
    cell = tool.get_by_label("row 1, position")
    expect(cell).not_to_have_value("0")
    cell.fill("a half")
    tool.get_by_label("row 3, z axis").fill("")
    page.get_by_role("button", name="Solve").click()
    expect(tool.get_by_role("alert").get_by_role("listitem")).to_have_text(
        [
            f"{place}: Write a number, such as 0.5, 1/2 or √2/2."
            for place in ("row 1, position", "row 3, z axis")
        ]
    )
    expect(cell).to_have_attribute("aria-invalid", "true")
    page.get_by_role("button", name="Use the current pose").click()
    page.get_by_role("button", name="Solve").click()
    expect(page.locator(".solutions")).to_be_visible()
    expect(tool.locator("[aria-invalid=true]")).to_have_count(0)
    cell.fill("√2/4")
    page.get_by_role("button", name="Solve").click()
    expect(page.locator(".solutions")).to_be_visible()
    tool.get_by_label("row 1, x axis").fill("2")
    page.get_by_role("button", name="Solve").click()
    expect(tool.get_by_role("alert")).to_contain_text("each must have the length 1")


def test_limits_and_durations_that_do_not_hold_are_explained(open_page: OpenPage) -> None:
    """A red border was all, and the curves of the trajectory went."""
    page = open_page("/playground")
    page.get_by_label("Robot from the catalogue").select_option("scara")
    # With the robot come new fields, in place of those that stand there.
    expect(page.locator("joint-sliders .joint-name")).to_have_count(4)
    opened(page, "Joint limits")
    tool = page.locator("details.tool", has_text="Joint limits")
    least = tool.locator("tbody input").first
    for text, told in {
        "180°": "q1: Write a number, such as 0.5.",
        "1e9": "q1: The least value is above the greatest.",
    }.items():
        least.fill(text)
        expect(least).to_have_accessible_description(told)
        expect(tool.locator(".notice-problem")).to_be_visible()
    greatest = tool.locator("tbody input").nth(1)
    least.fill("180°")
    greatest.fill("-80")  # the mark of one field is not taken away by the other
    expect(least).to_have_accessible_description("q1: Write a number, such as 0.5.")
    expect(greatest).not_to_have_attribute("aria-invalid", "true")
    least.fill("-70")
    expect(greatest).to_have_accessible_description("q1: The least value is above the greatest.")
    greatest.fill("80")
    expect(tool.locator(".notice-problem")).to_have_count(0)
    expect(least).not_to_have_attribute("aria-invalid", "true")
    opened(page, "Joint trajectory")
    duration = page.get_by_label("Duration")
    duration.fill("0")
    expect(duration).to_have_accessible_description("Write a duration from 0.001 to 1000000 seconds.")
    duration.fill("2")
    expect(page.locator(".plot-drawing text").first).to_be_visible()


def test_what_was_found_for_another_table_goes(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Inverse kinematics")
    page.get_by_role("button", name="Solve").click()
    expect(page.locator(".solutions")).to_be_visible()
    page.get_by_label(re.compile(r"^Row 2, a")).fill("0.5")
    expect(page.locator(".solutions")).to_have_count(0)
    held = Held(page, "**/inverse-kinematics")
    page.get_by_role("button", name="Solve").click()
    held.until(1)
    page.get_by_label(re.compile(r"^Row 2, a")).fill("0.6")
    shown_robot(page)
    held.stop()
    page.wait_for_load_state("networkidle")
    expect(page.locator(".solutions")).to_have_count(0)


def test_the_playground_on_paper_says_what_its_numbers_are_of(open_page: OpenPage) -> None:
    """On wide paper the robot stood beside the middle of the text; convention and values were left out."""
    page = open_page("/playground")
    shown_robot(page)
    page.emulate_media(media="print")
    robot, table = page.locator("#robot-card"), page.locator("#table-card")
    expect(table.locator("label", has_text="standard")).to_be_visible()
    expect(table.locator("label", has_text="modified")).to_be_hidden()
    expect(robot.locator(".parameter-fields")).to_be_visible()
    expect(page.locator("#sources-card")).to_be_hidden()
    boxes = [place.bounding_box() for place in (table, robot)]
    assert boxes[0]
    assert boxes[1]
    assert boxes[0]["y"] + boxes[0]["height"] <= boxes[1]["y"]


def test_a_link_holds_the_whole_robot(open_page: OpenPage) -> None:
    page = open_page("/playground", permissions=["clipboard-read", "clipboard-write"])
    shown_robot(page)
    page.locator("joint-sliders .joint-number input").first.fill("30")
    page.get_by_role("button", name="Copy a link").click()
    expect(page.locator("#announcer")).to_contain_text("Link copied")
    address = page.evaluate("navigator.clipboard.readText()")
    assert "#robot=" in address
    other = open_page("/playground")
    other.goto(address)
    other.reload()
    shown_robot(other)
    expect(other.locator("joint-sliders .joint-number input").first).to_have_value("30")
    assert column(other, "d") == column(page, "d")
    field = other.locator("dh-table-editor tbody tr:nth-child(2) input[id$='-a']")
    field.fill("9.5")
    expect(other).to_have_url(WITHOUT_FRAGMENT)  # by which a reload would bring back what was shared
    other.reload()
    expect(field).to_have_value("9.5")


def test_a_broken_link_opens_the_usual_robot(open_page: OpenPage, web: str) -> None:
    page = open_page("/version", lang=None, ready=False)
    for robot in ("not json", '{"table":{"rows":[{}]}}', '{"table":{"rows":[{"a":{}}]}}'):
        packed = base64.urlsafe_b64encode(robot.encode()).decode().rstrip("=")
        page.evaluate("localStorage.clear()")
        page.goto("about:blank")
        page.goto(f"{web}/playground?lang=en#robot={packed}")
        wait_ready(page)
        expect(page.locator("dh-table-editor tbody tr").first, robot).to_be_visible()


def test_inverse_kinematics_shows_all_solutions_and_moves_there(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    for i, value in enumerate(["10", "40", "-120", "20", "30", "5"]):
        page.locator("joint-sliders .joint-number input").nth(i).fill(value)
    position = page.locator(".tool", has_text="Pose of the end frame").locator("dd").first
    opened(page, "Pose of the end frame")
    expect(position).not_to_contain_text("0.4521")
    before = position.inner_text()
    opened(page, "Inverse kinematics")
    page.get_by_role("button", name="Use the current pose").click()
    opened(page, "Joint limits")
    for field in page.locator(".limits input").all():
        field.fill("")
    page.get_by_role("button", name="Solve").click()
    rows = page.locator(".solutions tbody tr")
    expect(rows).to_have_count(8)
    page.get_by_role("button", name="Show solution 5").click()
    expect(page.locator("joint-sliders .joint-number input").first).to_have_value(
        re.compile(r"^-?\d+(\.\d+)?$")
    )
    expect(position).to_have_text(before)


def test_solving_waits_for_the_pose_that_was_asked_for(open_page: OpenPage) -> None:
    """It solved for what stood in the fields before, and the pose came into them afterwards."""
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Inverse kinematics")
    target = page.get_by_label("row 1, position", exact=True)
    expect(target).to_have_value("0.4521")
    page.get_by_label("Joint angle q1").fill("90")
    poses = Held(page, "**/forward-kinematics")
    page.get_by_role("button", name="Use the current pose").click()
    poses.until(1)
    with page.expect_request("**/inverse-kinematics") as asked:
        page.get_by_role("button", name="Solve").click()
        poses.let_go()
    assert asked.value.post_data_json["target"][0][3] == pytest.approx(0.1501, abs=1e-4)
    expect(target).to_have_value(re.compile(r"^0\.150"))
    expect(page.locator(".solutions")).to_be_visible()


def test_the_other_convention_can_be_taken_over(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Write it in another form")
    page.locator("#tools").get_by_role("button", name="Modified table").click()
    page.get_by_role("button", name="Use this table").click()
    expect(page.get_by_role("radio", name="modified")).to_be_checked()
    shown_robot(page)
    assert column(page, "alpha")[:3] == ["0", "90", "0"]


def test_other_forms(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Write it in another form")
    for button, text in {"Product of exponentials": "S6", "URDF": "<robot"}.items():
        page.locator("#tools").get_by_role("button", name=button, exact=True).click()
        expect(page.locator(".tool", has_text="Write it in another form").last).to_contain_text(text)


def test_a_table_from_joint_axes_with_the_rules(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "From joint axes")
    page.locator("#sources").get_by_role("button", name="Standard table").first.click()
    expect(page.locator(".frame-rules li")).to_have_count(4)
    shown_robot(page)
    assert len(column(page, "a")) == 3


def test_a_table_from_an_scm_chain(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "From an SCM chain")
    page.locator("#sources details[open]").get_by_role("button", name="Modified table").click()
    expect(page.locator("#sources details[open] .tool-answer")).to_contain_text("now in the editor")
    assert column(page, "alpha") == STANFORD_ALPHAS


def test_a_chain_that_is_none_is_refused_in_words(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("status of 422")
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "From an SCM chain")
    page.locator("#sources details[open]").get_by_label("row 1, A", exact=True).first.fill("2*a1")
    page.locator("#sources details[open]").get_by_role("button", name="Modified table").click()
    expect(page.locator("#sources details[open] [role=alert]")).to_contain_text("q1")
    page.locator("#sources details[open]").get_by_label("row 2, X", exact=True).first.fill("L1 %")
    page.locator("#sources details[open]").get_by_role("button", name="Modified table").click()
    expect(page.locator("#sources details[open] [role=alert]")).to_contain_text("row 2, X: At character")


def test_urdf_there_and_back(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Write it in another form")
    page.locator("#tools").get_by_role("button", name="URDF", exact=True).click()
    source = page.locator("pre.source-text").inner_text()
    opened(page, "From URDF")
    page.locator("textarea").fill(source)
    page.locator("#sources details[open]").get_by_role("button", name="Standard table").click()
    expect(page.locator("#sources details[open] .tool-answer")).to_contain_text("now in the editor")
    shown_robot(page)


def test_what_was_typed_is_there_after_reload(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    page.get_by_label(re.compile(r"^Row 2, a")).fill("0.5")
    page.get_by_label(re.compile(r"^Row 3, d")).fill("2*(")
    page.reload()
    expect(page.get_by_label(re.compile(r"^Row 2, a"))).to_have_value("0.5")
    expect(page.get_by_label(re.compile(r"^Row 3, d"))).to_have_value("2*(")


def test_accessible_with_everything_open(
    open_page: OpenPage,
    assert_accessible: Callable[[Page], None],
    assert_accessible_at_both_sizes: Callable[[Page], None],
) -> None:
    page = open_page("/playground")
    shown_robot(page)
    page.evaluate("for (const each of document.querySelectorAll('details')) each.open = true")
    expect(page.locator(".named dd").first).to_be_visible()
    for plot in ("Section of the workspace through the first axis", "Joint angles over time"):
        expect(page.get_by_role("img", name=plot)).to_be_visible()
    expect(page.locator(".more-tools details").first).to_be_visible()
    assert_accessible_at_both_sizes(page)
    assert_accessible_at_any_width(page, assert_accessible, {1280: ("active",)})


def test_an_answer_that_was_overtaken_is_not_shown(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Pose of the end frame")
    first = page.locator("joint-sliders .joint-number input").first
    for angle in (10, 20, 30, 90):
        first.fill(str(angle))
    position = page.locator(".tool", has_text="Pose of the end frame").locator("dd").first
    expect(position).to_have_text(re.compile(r"^0\.15(01)?\s+0\.4521"))
    kept = page.evaluate("JSON.parse(localStorage.getItem('framewise:playground')).joints[0]")
    assert json.dumps(round(kept, 4)) == "1.5708"


def test_what_the_catalogue_knows_goes_with_its_table(open_page: OpenPage) -> None:
    """Another table of as many joints has neither the robot's name nor its postures nor its limits."""
    page = open_page("/playground")
    shown_robot(page)
    expect(page.get_by_label("Robot from the catalogue")).to_have_value("puma560")
    expect(page.locator(".configurations")).to_be_visible()
    opened(page, "Workspace")
    page.wait_for_load_state("networkidle")

    def is_changed(sent: Request) -> bool:
        rows = sent.post_data_json["table"]["rows"] if sent.url.endswith("/workspace") else []
        return any(str(value) == "0.1" for row in rows for value in row.values())

    with page.expect_request(is_changed) as asked:
        page.locator("dh-table-editor tbody tr").nth(1).locator("input").nth(2).fill("0.1")
    assert set(asked.value.post_data_json["limits"]) == {None}
    expect(page.get_by_label("Robot from the catalogue")).to_have_value("")
    expect(page.locator(".configurations")).to_be_hidden()


def test_a_list_of_robots_that_comes_late_shows_the_robot_in_question(open_page: OpenPage) -> None:
    lists: list[Held] = []
    page = open_page("/playground", before=lambda page: lists.append(Held(page, "**/api/v1/robots")))
    shown_robot(page)
    lists[0].until(1)
    lists[0].stop()
    expect(page.get_by_label("Robot from the catalogue")).to_have_value("puma560")


def test_the_limits_of_a_urdf_come_with_its_table(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    urdf = """<robot name="arm"><link name="a"/><link name="b"/><joint name="j" type="revolute">
      <parent link="a"/><child link="b"/><origin xyz="0.3 0 0.2" rpy="1.4707963 0 0"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>"""
    page.locator("#sources summary", has_text="From URDF").click()
    page.locator("#sources textarea").fill(urdf)
    page.locator("#sources details[open]").get_by_role("button", name="Modified table").click()
    expect(page.locator("dh-table-editor tbody tr")).not_to_have_count(6)
    assert page.evaluate("document.querySelector('dh-table-editor').table.angle_unit") == "deg"
    with page.expect_request("**/workspace") as asked:
        opened(page, "Workspace")
    assert [57.295779513] in [[round(limit[1], 9)] for limit in asked.value.post_data_json["limits"] if limit]
    expect(page.locator(".plot-drawing svg")).to_be_visible()


NARROW = {
    "a tip on the first axis": "θ1 0.2 0 0",
    "a tip at one height": "θ1 0 0.3 0\nθ2 0 0.2 0",
    "a narrow column": "θ1 0 0.001 0\nP 0 d2 0 0",
}


def test_a_section_is_drawn_however_narrow_it_is(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Workspace")
    section = page.get_by_role("img", name="Section")
    for name, written in NARROW.items():
        drawn = section.element_handle()
        put_table(page, {"convention": "standard", "rows": rows("standard", written)})
        joints = len(written.splitlines())
        expect(page.locator("joint-sliders .joint-line")).to_have_count(joints)
        if "P" in written:
            opened(page, "Joint limits")
            page.get_by_label("Least value of q2 in m").fill("0")
            page.get_by_label("Greatest value of q2 in m").fill("2")
        drawn.wait_for_element_state("hidden")  # that of the table before
        # it may be drawn again at any moment: looked for and measured in one step
        shape = page.wait_for_function(
            """() => {
              const drawn = document.querySelector(".plot-drawing svg[aria-label^='Section']");
              const box = drawn?.getBoundingClientRect();
              return box?.width ? { ratio: box.height / box.width } : null;
            }"""
        ).json_value()
        assert 0.3 < shape["ratio"] < 2.5, name


def expect_drawn(page: Page, tone: str, *, drawn: bool = True) -> None:
    shapes = page.locator(f"#robot svg.scene-svg .{tone}")
    expect(shapes).not_to_have_count(0) if drawn else expect(shapes).to_have_count(0)


def test_limits_of_the_catalogue_are_shown_and_used(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    slider = page.locator("joint-sliders input[type=range]").nth(1)
    assert [slider.get_attribute("min"), slider.get_attribute("max")] == ["-45", "225"]
    opened(page, "Joint limits")
    expect(page.get_by_label("Least value of q2 in °")).to_have_value("-45")
    expect(page.locator(".limits")).to_contain_text("Wang and Chen")
    page.get_by_label("Greatest value of q2 in °").fill("90")
    expect(slider).to_have_attribute("max", "90")
    opened(page, "Inverse kinematics")
    with page.expect_request("**/inverse-kinematics") as asked:
        page.get_by_role("button", name="Solve").click()
    assert asked.value.post_data_json["limits"][1] == [-45, 90]
    page.get_by_label("Greatest value of q2 in °").fill("-90")
    expect(page.get_by_label("Greatest value of q2 in °")).to_have_attribute("aria-invalid", "true")
    expect(slider).to_have_attribute("max", "90")


def test_solutions_stand_side_by_side(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    page.get_by_role("button", name="upper arm raised by 45°").click()
    opened(page, "Inverse kinematics")
    page.get_by_role("button", name="Use the current pose").click()
    page.get_by_role("button", name="Solve").click()
    rows = page.locator("#tools .solutions tbody tr")
    expect(rows).to_have_count(3)
    for button in rows.get_by_role("button").all():
        box = button.bounding_box()
        assert box is not None
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= 1280
    expect(page.locator(".tool", has_text="side by side")).to_contain_text(
        "5 more lie outside the joint limits"
    )
    expect_drawn(page, "stroke-shade")
    page.get_by_label("Show all solutions side by side").uncheck()
    expect_drawn(page, "stroke-shade", drawn=False)


def test_the_workspace_as_a_cloud_and_as_a_section_with_its_numbers(
    open_page: OpenPage,
) -> None:
    asked: list[str] = []
    page = open_page(
        "/playground", before=lambda page: page.on("request", lambda request: asked.append(request.url))
    )
    shown_robot(page)
    assert not any("vendor/plot" in address for address in asked)
    opened(page, "Workspace")
    section = page.get_by_role("img", name="Section of the workspace through the first axis")
    expect(section).to_be_visible()
    assert section.locator("circle").count() == 4000
    expect_drawn(page, "cloud")
    tool = page.locator(".tool", has_text="Outer radius")
    tool.locator("summary", has_text="The same in numbers").click()
    assert tool.locator(".plot-numbers tbody tr").count() == 12
    greatest = [float(text.replace("−", "-")) for text in tool.locator("td:nth-child(3)").all_inner_texts()]
    assert max(greatest) == pytest.approx(0.877, abs=0.01)
    opened(page, "Workspace")
    expect_drawn(page, "cloud", drawn=False)


def test_a_trajectory_with_its_plot_its_path_and_its_numbers(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Joint trajectory")
    plot = page.get_by_role("img", name="Joint angles over time")
    expect(plot).to_be_visible()
    assert plot.locator("[data-mark=line]").count() == 6
    before = page.locator("joint-sliders .joint-number input").nth(2).input_value()
    page.get_by_role("slider", name="Instant", exact=True).fill("60")
    # the last posture of the catalogue's PUMA bends joint 3 to -180°
    expect(page.locator("joint-sliders .joint-number input").nth(2)).to_have_value("-180")
    expect(page.locator("[data-end=end] .hint")).to_contain_text("away from singularities")
    assert before != "-180"
    tool = page.locator(".tool", has_text="Polynomial").or_(page.locator(".tool", has_text="quintic")).first
    tool.locator("summary", has_text="The same in numbers").click()
    assert tool.locator(".plot-numbers tbody tr").count() == 11
    expect(tool.locator(".plot-numbers tbody tr").last).to_contain_text("−180")
    page.get_by_role("radio", name="velocity", exact=True).check()
    expect(page.get_by_role("img", name="Angular velocities of the joints over time")).to_be_visible()
    expect_drawn(page, "stroke-lit")


def test_the_jacobian_in_symbols_and_its_ellipsoid(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    opened(page, "Jacobian")
    tool = page.locator(".tool", has_text="Radii of the velocity ellipsoid")
    expect(tool).to_contain_text("ω = (1; 0; 0) rad/s")
    expect_drawn(page, "stroke-pick")
    page.locator(".tool", has_text="Jacobian").first.get_by_label("Symbols").check()
    expect(page.locator("#tools .formula .katex").first).to_be_visible()


def test_a_new_table_and_the_way_back(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    page.get_by_role("button", name="New", exact=True).click()
    expect(page.locator("dh-table-editor tbody tr")).to_have_count(1)
    expect(page.get_by_label("Robot from the catalogue")).to_have_value("")
    expect(page.locator("dh-table-editor input:focus")).to_have_count(1)
    page.locator(".editor-notice").get_by_role("button", name="Undo").click()
    expect(page.locator("dh-table-editor tbody tr")).to_have_count(6)


def more(page: Page, heading: str) -> Locator:
    """Open one of the tools that are loaded when they are asked for."""
    group = page.locator("#tools > details.tool", has_text="More about this robot")
    if group.get_attribute("open") is None:
        assert not page.evaluate(
            "performance.getEntriesByType('resource').some((e) => /more\\.js/.test(e.name))"
        )
        opened(page, "More about this robot")
    opened(page, re.escape(heading))
    return group.locator("details.tool", has=page.locator("summary", has_text=heading))


def test_more_about_a_robot(open_page: OpenPage) -> None:
    """Each tool of the group is asked about the SCARA and shows an answer."""
    page = open_page("/playground")
    shown_robot(page)
    page.get_by_label("Robot from the catalogue").select_option("scara")
    expect(page.locator("joint-sliders .joint-name")).to_have_count(4)
    shown_robot(page)
    expect(more(page, "Inverse kinematics in symbols").locator(".katex").nth(3)).to_be_visible()
    singular = more(page, "Singularities")
    expect(singular.get_by_role("button", name=re.compile("^Family"))).not_to_have_count(0)
    singular.get_by_label("Conditions").fill("sin(q2)")
    singular.get_by_label("Conditions").blur()
    expect(singular).to_contain_text("singular exactly where these hold")
    rotations = more(page, "Orientation in every notation")
    expect(rotations.locator("tbody tr")).to_have_count(24)
    motion = more(page, "Equations of motion")
    expect(motion.locator(".matrix-block")).to_have_count(3)
    motion.get_by_label("Symbols").check()
    expect(motion.locator(".matrix-block .katex").first).to_be_visible()


def test_a_planted_mistake_is_found_and_mended(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    with page.expect_response("**/plant-mistake") as answered:
        tool = more(page, "Find the mistake")
    row = answered.value.json()["row"]
    tool.get_by_role("button", name=f"Row {row % 6 + 1}", exact=True).click()
    expect(tool.get_by_role("status")).to_contain_text("look again")
    tool.get_by_role("button", name=f"Row {row}", exact=True).click()
    expect(tool.get_by_role("status")).to_contain_text(answered.value.json()["label"])


@pytest.mark.parametrize("robot", ["puma560", "kr125"])
def test_a_wrong_frame_is_found_in_the_picture(open_page: OpenPage, robot: str) -> None:
    """Also of a modified table with a fixed row: there is a frame for each joint, and one more."""
    page = open_page("/playground")
    shown_robot(page)
    with page.expect_response("**/understand"):
        page.get_by_label("Robot from the catalogue").select_option(robot)
    expect(page.locator("#robot robot-scene")).not_to_have_attribute("aria-busy", "true")
    with page.expect_response("**/plant-frame-mistake") as answered:
        tool = more(page, "Find the wrong frame")
    planted = answered.value.json()
    wrong, count = planted["frame"], len(planted["frames"])
    expect(tool.locator("robot-scene svg").first).to_be_visible()
    tool.get_by_role("button", name=f"Frame {(wrong + 1) % count}", exact=True).click()
    expect(tool.get_by_role("status")).to_contain_text("look again")
    tool.get_by_role("button", name=f"Frame {wrong}", exact=True).click()
    expect(tool.get_by_role("status")).to_contain_text(planted["label"])
    with page.expect_response("**/plant-frame-mistake") as answered:
        tool.get_by_role("button", name="Another mistake").click()
    expect(tool.get_by_role("status")).to_be_empty()


def test_a_kept_table_is_compared_with_what_is_typed(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    tool = more(page, "Do two tables describe one robot?")
    tool.get_by_role("button", name="Keep this table").click()
    expect(tool).to_contain_text("describe the same robot")
    page.get_by_label(re.compile(r"^Row 1, d")).fill("0.3")
    page.get_by_label(re.compile(r"^Row 2, a")).fill("0.6")
    expect(tool).to_contain_text("describe different robots")


def comparing_puma(page: Page) -> Locator:
    """The comparison of two tables, that of a PUMA kept as the one and shown as the other."""
    shown_robot(page)
    page.get_by_label("Robot from the catalogue").select_option("puma560")
    expect(page.locator("joint-sliders .joint-name")).to_have_count(6)
    shown_robot(page)
    tool = more(page, "Do two tables describe one robot?")
    tool.get_by_role("button", name="Keep this table").click()
    expect(tool).to_contain_text("describe the same robot")
    return tool


def test_a_table_of_too_few_digits_is_not_said_to_be_another_robot(open_page: OpenPage) -> None:
    page = open_page("/playground")
    tool = comparing_puma(page)
    page.get_by_label(re.compile(r"^Row 2, a")).fill("0.4")
    expect(tool).to_contain_text("too few digits")
    expect(tool).not_to_contain_text("different robots")
    expect(tool).not_to_contain_text("does not describe this robot")


def test_tables_whose_names_have_different_values_are_not_compared(open_page: OpenPage) -> None:
    page = open_page("/playground")
    tool = comparing_puma(page)
    page.get_by_label("Robot from the catalogue").select_option("scara")
    expect(tool).to_contain_text("different values for a2")


def test_more_about_a_robot_is_accessible(
    open_page: OpenPage, assert_accessible_at_both_sizes: Callable[[Page], None]
) -> None:
    page = open_page("/playground")
    shown_robot(page)
    page.get_by_label("Robot from the catalogue").select_option("scara")
    expect(page.locator("joint-sliders .joint-name")).to_have_count(4)
    shown_robot(page)
    for heading in ("Orientation in every notation", "Equations of motion", "Find the mistake"):
        expect(more(page, heading).locator(".scroller").last).to_be_visible()
    expect(more(page, "Inverse kinematics in symbols").locator(".katex").first).to_be_visible()
    assert_accessible_at_both_sizes(page)


def test_inverse_kinematics_in_symbols_says_what_is_free_in_a_singular_case(open_page: OpenPage) -> None:
    page = open_page("/playground")
    shown_robot(page)
    page.get_by_label("Robot from the catalogue").select_option("ur5")
    expect(page.locator("joint-sliders .joint-name")).to_have_count(6)
    shown_robot(page)
    choices = more(page, "Inverse kinematics in symbols").get_by_text("q6 may be chosen")
    expect(choices).to_have_count(2)
    expect(choices.first.locator(".katex")).to_be_visible()
