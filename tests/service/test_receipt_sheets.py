"""The receipt as a page to print: read back with PDFium, as text and as a picture."""

import re
from math import cos, hypot, radians, sin

import httpx
import pypdfium2
import pytest
import segno

from exercises.drawings import figure_drawing
from exercises.figures.svg import document
from exercises.instance import Instance, generate
from exercises.library import packaged
from service.receipts.figure_on_paper import outline
from service.receipts.paper import WIDTH
from service.receipts.sheet import Sheet, pdf_of
from tests.service.test_receipts import API, RIGHT

LANGUAGES = ("en", "es", "fr", "pt", "ro", "uk")
TOKEN = "eyJhbGciOiJFZERTQSJ9." * 40


def svg_of(instance: Instance) -> str:
    return document(figure_drawing(instance), title="", description="", language="en")


FIGURE = svg_of(generate(packaged().exercise("puma560"), "s"))


def read(pdf: bytes) -> str:
    document = pypdfium2.PdfDocument(pdf)
    return "\n".join(str(page.get_textpage().get_text_range()) for page in document)


def written(rows: list[list[str]], **other: str) -> bytes:
    sheet = Sheet(
        title=other.get("title", "PUMA 560"), language="uk", facts=[("Ім’я", other.get("name", "Ада"))],
        answer="Відповідь", columns=["i", "θ", "d", "a", "α"], rows=rows, signature="example.org",
        receipt=TOKEN,
    )  # fmt: skip
    return pdf_of(sheet, figure=FIGURE, code=segno.make(TOKEN, micro=False, error="l").matrix)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_sheet_says_everything_in_its_language(client: httpx.Client, language: str) -> None:
    typed = {**RIGHT, "name": "Ґалаґан Ștefan Núñez"}
    told = {"Accept-Language": language}
    response = client.post(f"{API}/exercises/twolink/receipts.pdf", json=typed, headers=told)
    assert response.status_code == 200
    text = read(response.content)
    assert packaged().exercise("twolink").title(language).replace("\xa0", " ") in text
    assert typed["name"] in text
    assert {"θ", "α", "q1", "q2", "L1", "L2"} <= set(text.split())


def test_everything_that_was_typed_can_be_read() -> None:
    text = read(written([["1", "q1−90°", "½·√2", "L₁ʹ" * 3, "⁰α"]], name="Łukasz Ångström-Œuvré ґєії №7"))
    assert "Łukasz Ångström-Œuvré ґєії №7" in text
    assert "q1−90°" in text
    assert re.sub(r"\s", "", TOKEN) in re.sub(r"\s", "", text)


def test_a_long_answer_goes_on_with_a_new_page_and_loses_nothing() -> None:
    rows = [[str(i), f"q{i}", "d" * 200, f"cell{i} " + "L1*cos(x) + " * 15, "0"] for i in range(1, 65)]
    pdf = written(rows, title="A title that is longer than any line of a page could ever be " * 3)
    assert len(pypdfium2.PdfDocument(pdf)) > 5
    text = read(pdf)
    assert all(f"cell{i}" in text for i in range(1, 65))
    assert text.count("d" * 20) >= 64


def test_the_code_is_drawn_module_by_module() -> None:
    page = pypdfium2.PdfDocument(written([]))[0]
    scale = 8
    picture = page.render(scale=scale, grayscale=True).to_numpy()
    code = segno.make(TOKEN, micro=False, error="l").matrix
    corner = next(
        obj for obj in page.get_objects() if abs(obj.get_bounds()[2] - obj.get_bounds()[0]) > 100
        and obj.get_bounds()[2] > WIDTH / 2 + 100 and abs(aspect(obj) - 1) < 1e-3
    )  # fmt: skip
    left, _, right, high = corner.get_bounds()
    module = (right - left) / len(code)
    for i, row in enumerate(code):
        for j, dark in enumerate(row):
            x, y = left + (j + 0.5) * module, page.get_height() - high + (i + 0.5) * module
            assert (picture[int(y * scale), int(x * scale)] < 128) == bool(dark), (i, j)


def aspect(drawn: pypdfium2.PdfObject) -> float:
    left, low, right, high = drawn.get_bounds()
    return float((right - left) / (high - low))


@pytest.mark.parametrize("large", [0, 1])
@pytest.mark.parametrize("sweep", [0, 1])
def test_arcs_stay_on_their_ellipse(large: int, sweep: int) -> None:
    rx, ry, turn, cx, cy = 15.5, 11.8, -125.1, 40.0, 60.0
    c, s = cos(radians(turn)), sin(radians(turn))

    def on(angle: float) -> tuple[float, float]:
        a, b = rx * cos(radians(angle)), ry * sin(radians(angle))
        return cx + c * a - s * b, cy + s * a + c * b

    span = (260.0 if large else 100.0) * (1 if sweep else -1)
    (x, y), (u, v) = on(20.0), on(20.0 + span)
    steps = list(outline(f"M{x!r} {y!r}A{rx} {ry} {turn} {large} {sweep} {u!r} {v!r}Z"))
    assert [name for name, _ in steps] == ["M", *"C" * (3 if large else 2), "Z"]
    at = (x, y)
    for _, numbers in steps[1:-1]:
        near, far, end = (numbers[0], numbers[1]), (numbers[2], numbers[3]), (numbers[4], numbers[5])
        middle = [(a + 3 * b + 3 * d + e) / 8 for a, b, d, e in zip(at, near, far, end, strict=True)]
        for px, py in (middle, end):
            du, dv = px - cx, py - cy
            assert hypot((c * du + s * dv) / rx, (-s * du + c * dv) / ry) == pytest.approx(1, abs=5e-4)
        at = end
    assert at == pytest.approx((u, v))


def test_every_exercise_has_a_figure_that_can_be_put_on_paper() -> None:
    library = packaged()
    drawn = 0
    for name in library.ids[::6]:
        instance = generate(library.exercise(name), "s")
        figure = svg_of(instance)
        sheet = Sheet(
            title=name, language="en", facts=[], answer="", columns=[], rows=[], signature="", receipt=""
        )
        page = pypdfium2.PdfDocument(pdf_of(sheet, figure=figure, code=[]))[0]
        drawn += len(list(page.get_objects())) > figure.count("<path")
    assert drawn
