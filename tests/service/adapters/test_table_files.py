"""Tables in the files that courses use."""

import io
import json
import struct
import zipfile
from pathlib import Path
from xml.sax.saxutils import escape

import pytest

from kinematics.cells.tables import NoCell, as_cell
from service.adapters.hand_ins import count_files, hand_ins, identifier_of, student_of
from service.adapters.table_files import LARGEST_FILE, TableSettings, read_tables
from service.http.problems import RequestError

DEG = TableSettings(angle_unit="deg")
COURSE = {
    "scara": {"theta offset": [0, 0, 0], "d": [0, 0, 0.1], "a": [0.4, 0.3, 0], "alpha": [0, 3.14159, 0]},
    "two": {"theta offset": [0], "d": [0], "a": [1], "alpha": [0]},
}


def rows(name: str, content: bytes, settings: TableSettings = DEG) -> list[dict[str, object]]:
    (found,) = read_tables(name, content, settings)
    return list(found.table["rows"])


def spreadsheet(sheets: dict[str, list[list[object]]]) -> bytes:
    """The least that is a workbook: Office Open XML with inline strings."""
    stream = io.BytesIO()
    main = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'
    relations = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006"
    with zipfile.ZipFile(stream, "w") as book:
        kinds = "".join(
            f'<Override PartName="/xl/worksheets/sheet{i}.xml" ContentType="application/vnd.openxmlformats-'
            'officedocument.spreadsheetml.worksheet+xml"/>'
            for i in range(1, len(sheets) + 1)
        )
        book.writestr(
            "[Content_Types].xml",
            f'<Types xmlns="{package}/content-types"><Default Extension="rels" ContentType="application/vnd.'
            'openxmlformats-package.relationships+xml"/><Override PartName="/xl/workbook.xml" ContentType='
            f'"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/>{kinds}</Types>',
        )
        book.writestr(
            "_rels/.rels",
            f'<Relationships xmlns="{package}/relationships"><Relationship Id="r" Type="{relations}/'
            'officeDocument" Target="xl/workbook.xml"/></Relationships>',
        )
        listed = "".join(
            f'<sheet name="{name}" sheetId="{i}" r:id="r{i}"/>' for i, name in enumerate(sheets, 1)
        )
        book.writestr(
            "xl/workbook.xml", f'<workbook {main} xmlns:r="{relations}"><sheets>{listed}</sheets></workbook>'
        )
        links = "".join(
            f'<Relationship Id="r{i}" Type="{relations}/worksheet" Target="worksheets/sheet{i}.xml"/>'
            for i in range(1, len(sheets) + 1)
        )
        book.writestr(
            "xl/_rels/workbook.xml.rels",
            f'<Relationships xmlns="{package}/relationships">{links}</Relationships>',
        )
        for i, grid in enumerate(sheets.values(), 1):
            lines = "".join(f"<row>{''.join(map(cell, row))}</row>" for row in grid)
            book.writestr(
                f"xl/worksheets/sheet{i}.xml", f"<worksheet {main}><sheetData>{lines}</sheetData></worksheet>"
            )
    return stream.getvalue()


def cell(value: object) -> str:
    if isinstance(value, int | float):
        return f"<c><v>{value}</v></c>"
    return f'<c t="inlineStr"><is><t>{escape(str(value))}</t></is></c>'


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("t.csv", b"theta,d,a,alpha\nq1,0,L1,90\nq2,0,L2,0\n"),
        ("t.csv", "﻿Link;θ [deg];d (m);a_i;α_i\n1;q1;0;L1;90\n2;q2;0;L2;0\n".encode()),
        ("t.txt", "θ\td\ta\tα\r\nq1\t0\tL1\t90\r\nq2\t0\tL2\t0\r\n".encode("utf-16")),
        ("t.csv", "\ufeffθ;d;a;α\nq1;0;L1;90\nq2;0;L2;0\n".encode("utf-16-be")),
        ("t.tsv", b"i\tTheta_i\td_i\tr_i\ttwist\n1\tq1\t0\tL1\t90\n2\tq2\t0\tL2\t0\n"),
        ("t.txt", b"my answer\n\n| theta | d | a | alpha |\n| q1 | 0 | L1 | 90 |\n| q2 | 0 | L2 | 0 |\n"),
        ("t.csv", b'"theta";"d";"a";"alpha"\n"q1";0;"L1";90\n"q2";0;"L2";0\n'),
        ("t.txt", b"|theta|d|a|alpha|\n|:---|---|---|---:|\n| q1 | 0 | L1 | 90 |\n| q2 | 0 | L2 | 0 |\n"),
        ("t.json", b'{"theta": ["q1", "q2"], "d": [0, 0], "a": ["L1", "L2"], "alpha": [90, 0]}'),
    ],
)  # fmt: skip
def test_one_table_in_many_files(name: str, content: bytes) -> None:
    found = rows(name, content)
    assert [str(row["theta"]) for row in found] == ["q1", "q2"]
    assert [str(row["a"]) for row in found] == ["L1", "L2"]
    assert [float(str(row["alpha"])) for row in found] == [90, 0]


def test_headers_name_convention_and_units() -> None:
    content = "θ (deg);d [mm];a_{i-1};α_{i−1}\nq1;12,5;0;90\n".encode()
    (found,) = read_tables("t.csv", content, TableSettings())
    assert found.table["convention"] == "modified"
    assert (found.table["angle_unit"], found.table["length_unit"]) == ("deg", "mm")
    assert found.table["rows"][0]["d"] == "12.5"


@pytest.mark.parametrize("header", ["θᵢ;dᵢ;aᵢ₋₁;αᵢ₋₁", "ϑ_i;d_i;a_{i-1};α_{i-1}", "тета;d;aᵢ₋₁;альфа"])
def test_indices_below_the_line_are_indices(header: str) -> None:
    (found,) = read_tables("t.csv", f"{header}\nq1;1;2;90\n".encode(), TableSettings())
    assert found.table["convention"] == "modified"
    assert found.table["rows"] == [{"theta": "q1", "d": "1", "a": "2", "alpha": "90"}]


def test_several_robots_in_a_file() -> None:
    found = read_tables("answers.json", json.dumps(COURSE).encode(), TableSettings())
    assert [table.exercise for table in found] == ["scara", "two"]
    assert [len(table.table["rows"]) for table in found] == [3, 1]


def test_several_students_in_a_file() -> None:
    content = b"student,theta,d,a,alpha\nann,q1,0,1,0\nbob,q1,0,1,0\nbob,q2,0,2,0\n"
    found = read_tables("class.csv", content, TableSettings())
    assert [(table.student, len(table.table["rows"])) for table in found] == [("ann", 1), ("bob", 2)]


def test_rows_below_a_name_are_the_same_students() -> None:
    """Of merged cells only the first has the name: the other rows were one table of nobody's."""
    content = (
        b"student,exercise,theta,d,a,alpha\nann,one,q1,0,1,0\n,,q2,0,2,0\nbob,two,q1,0,3,0\n,,q2,0,4,0\n"
    )
    found = read_tables("class.csv", content, TableSettings())
    assert [(table.student, table.exercise) for table in found] == [("ann", "one"), ("bob", "two")]
    assert [[row["a"] for row in table.table["rows"]] for table in found] == [["1", "2"], ["3", "4"]]


def test_numbers_of_a_workbook_are_names_and_types_of_joints() -> None:
    """A workbook has no whole numbers: student 12345.0 was nobody, and joint 1.0 of no type."""
    head = ["student", "sigma", "theta", "d", "a", "alpha"]
    content = spreadsheet({"a": [head, [12345, 0, 0, 0, 1, 90], [12345, 1, 0, 0, 1, 90]]})
    (found,) = read_tables("class.xlsx", content, DEG)
    assert found.student == "12345"
    assert [row["joint"] for row in found.table["rows"]] == ["revolute", "prismatic"]


def test_a_name_is_one_name_however_its_accents_are_encoded() -> None:
    content = "student,theta,d,a,alpha\nZo\u00eb,q1,0,1,0\nZoe\u0308,q2,0,2,0\n".encode()
    (found,) = read_tables("class.csv", content, TableSettings())
    assert found.student == "Zo\u00eb"


def test_a_comma_between_two_arguments_is_no_decimal_comma() -> None:
    (row,) = rows("t.csv", b'theta,d,a,alpha\nq1,"1,5",0,"atan2(3,4)"\n')
    assert (row["d"], row["alpha"]) == ("1.5", "atan2(3,4)")


def test_a_date_that_a_spreadsheet_made_is_refused_and_not_subtracted() -> None:
    """1/2 becomes 1 February 2026, which was read as 2026 - 2 - 1."""
    texts = "".join(
        f'<table:table-cell office:value-type="string"><text:p>{text}</text:p></table:table-cell>'
        for text in ("theta", "d", "a", "alpha")
    )
    day = '<table:table-cell office:value-type="date" office:date-value="2026-02-01"/>'
    content = document(
        f"<table:table-row>{texts}</table:table-row><table:table-row>{FULL.format(3)}{day}</table:table-row>"
    )
    (row,) = rows("t.ods", content)
    assert as_cell(row["alpha"]) == NoCell("date")


def test_a_sheet_of_notes_beside_a_table_costs_nothing() -> None:
    table = [["theta", "d", "a", "alpha"], ["q1", 0, 0.4, 0]]
    notes = {"Notes": [["I measured", 0.4]], "t": table}
    assert len(read_tables("ann.xlsx", spreadsheet(notes), DEG)) == 1
    with pytest.raises(RequestError):
        read_tables("ann.xlsx", spreadsheet({"t": table, "u": [["angle", "d", "a", "alpha"]]}), DEG)


def test_a_workbook_with_a_sheet_for_each_robot() -> None:
    head = ["theta", "d", "a", "alpha"]
    content = spreadsheet({"scara": [head, ["q1", 0, 0.4, 0]], "twolink": [head, ["q1", 0, "L1", 90]]})
    found = read_tables("class.xlsx", content, DEG)
    assert [table.exercise for table in found] == ["scara", "twolink"]
    assert found[0].table["rows"][0]["a"] == 0.4


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("t.json", b"{", "json_invalid"),
        ("t.json", b"[" * 500 + b"]" * 500, "json_too_deep"),
        ("t.json", b'{"a": 1}', "file_without_table"),
        ("t.json", b'{"theta": [0], "d": [0, 1], "a": [0], "alpha": [0]}', "columns_differ_in_length"),
        ("t.json", b'{"theta": [0], "d": [5], "a": [0], "alpha": [0], "offset": [0]}', "columns_repeated"),
        ("t.csv", b"j,theta,d,a,alpha,offset\n1,q1,5,0,90,0\n", "columns_repeated"),
        ("t.csv", b"", "file_unreadable"),
        ("t.csv", b"\xff\xfet\x00h\x00e", "file_unreadable"),
        ("t.csv", b"1,2,3,4\n", "columns_unknown"),
        ("t.csv", b"theta,d,a,alpha\n", "file_without_table"),
        ("t.xlsx", b"PK\x03\x04 not a workbook", "file_unreadable"),
        ("t.pdf", b"%PDF", "file_type_unknown"),
        ("t.csv", b"x" * (LARGEST_FILE + 1), "file_too_large"),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_code(name: str, content: bytes, code: str) -> None:
    with pytest.raises(RequestError) as refused:
        read_tables(name, content, TableSettings())
    assert refused.value.faults[0].code == code
    assert refused.value.faults[0].where[0] == name


@pytest.mark.parametrize(
    ("name", "student"),
    [
        ("Jane Doe_12345_assignsubmission_file_/table.csv", "Jane Doe"),
        ("doejane_LATE_123_456_table-1.csv", "doejane"),
        ("doejane_123_456_table.csv", "doejane"),
        ("HW3_jdoe_attempt_2026-01-02-10-11-12_t.csv", "jdoe"),
        ("ann/table.csv", "ann"),
        ("Jane Doe_12345_assignsubmission_file_/robot_1_2_final.csv", "Jane Doe"),
        ("bob.csv", "bob"),
    ],
)
def test_students_are_named_by_the_schemes_of_lms_archives(name: str, student: str) -> None:
    assert student_of(name) == student


def test_an_archive_is_read_in_memory_and_bounded(tmp_path: Path) -> None:
    archive = tmp_path / "class.zip"
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as written:
        written.writestr("../../evil_1_2_x.csv", b"theta,d,a,alpha\nq1,0,1,0\n")
        written.writestr("bomb_3_4_x.csv", b"0" * (4 * LARGEST_FILE))
        written.writestr("__MACOSX/._x.csv", b"junk")
        written.writestr("photo.png", b"junk")
    before = sorted(tmp_path.rglob("*"))
    found = list(hand_ins(archive, TableSettings()))
    assert [hand_in.student for hand_in in found] == ["evil", "bomb"]
    assert found[0].found is not None
    assert [fault.code for fault in found[1].faults] == ["file_too_large"]
    assert sorted(tmp_path.rglob("*")) == before


GOOD = b"theta,d,a,alpha\nq1,0,L1,0\nq2,0,L2,0\n" + b"\n" * 300


def test_a_damaged_member_is_one_students_and_not_the_classs(tmp_path: Path) -> None:
    names = ["Ann Lee_11_assignsubmission_file_/t.csv", "Bob_12_assignsubmission_file_/t.csv"]
    for damage in (0, 3):
        archive = tmp_path / f"class{damage}.zip"
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as written:
            for name in (
                *names,
                "Cy_13_assignsubmission_file_/scan.pdf",
                "Bob_12_assignsubmission_file_/x.png",
            ):
                written.writestr(name, GOOD)
        content = bytearray(archive.read_bytes())
        begin = content.find(b"t.csv") + len("t.csv") + damage
        content[begin : begin + 6] = bytes(255 - byte for byte in content[begin : begin + 6])
        archive.write_bytes(content)
        found = {hand_in.student: hand_in for hand_in in hand_ins(archive, TableSettings())}
        codes = {name: [fault.code for fault in hand_in.faults] for name, hand_in in found.items()}
        assert codes == {"Ann Lee": ["file_unreadable"], "Bob": [], "Cy": ["file_type_unknown"]}
        assert [hand_in.identifier for hand_in in found.values()] == [
            f"Participant {number}" for number in (11, 12, 13)
        ]
        assert count_files(archive) == 3


def test_students_of_one_name_are_two(tmp_path: Path) -> None:
    """The one whose file nobody can read had no line, because the other had handed in a table."""
    archive = tmp_path / "class.zip"
    with zipfile.ZipFile(archive, "w") as written:
        written.writestr("Ann Lee_11_assignsubmission_file_/t.csv", GOOD)
        written.writestr("Ann Lee_12_assignsubmission_file_/scan.pdf", b"%PDF")
    found = list(hand_ins(archive, TableSettings()))
    assert [hand_in.identifier for hand_in in found] == ["Participant 11", "Participant 12"]
    assert count_files(archive) == 2


def test_students_whom_moodle_hides_are_told_apart_by_their_numbers(tmp_path: Path) -> None:
    """In blind marking all bear one name, in the language of the site: with it, one set of values for all."""
    for name, students in (
        ("Teilnehmerin", ["Participant 11", "Participant 12"]),
        ("Ann Lee", ["Ann Lee", "Ann Lee", "Bob"]),
    ):
        archive = tmp_path / f"{name}.zip"
        with zipfile.ZipFile(archive, "w") as written:
            written.writestr(f"{name}_11_assignsubmission_file_/t.csv", GOOD)
            written.writestr(f"{name}_12_assignsubmission_file_/t.csv", GOOD)
            if "Bob" in students:
                written.writestr("Bob_13_assignsubmission_file_/t.csv", GOOD)
        assert [hand_in.student for hand_in in hand_ins(archive, TableSettings())] == students


def test_names_in_an_archive_made_on_a_mac_are_read_as_written(tmp_path: Path) -> None:
    """It writes UTF-8 without the flag that says so, accents apart from their letters."""
    archive, name = tmp_path / "class.zip", "Zoe\u0308_11_assignsubmission_file_/t.csv"
    with zipfile.ZipFile(archive, "w") as written:
        written.writestr(name.encode().decode("cp437"), GOOD)
    content = archive.read_bytes()
    with zipfile.ZipFile(archive) as read:
        (entry,) = read.infolist()
        raw = entry.filename.encode("utf-8")
    plain = name.encode().replace(b"/t", b"/t".ljust(2 + len(raw) - len(name.encode()), b"t"))
    content = content.replace(raw, plain)
    flagged = ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8))
    for mark, offset in flagged:
        at = content.find(mark) + offset
        content = content[:at] + b"\0\0" + content[at + 2 :]
    archive.write_bytes(content)
    (hand_in,) = hand_ins(archive, TableSettings())
    assert hand_in.student == "Zo\u00eb"
    assert hand_in.found is not None


def test_half_an_archive_is_said_to_be_none(tmp_path: Path) -> None:
    archive = tmp_path / "class.zip"
    with zipfile.ZipFile(archive, "w") as written:
        written.writestr("ann.csv", GOOD)
    archive.write_bytes(archive.read_bytes()[:60])
    with pytest.raises(RequestError) as refused:
        list(hand_ins(archive, TableSettings()))
    assert refused.value.faults[0].code == "file_unreadable"


def test_marks_bear_what_the_gradebook_imports_by() -> None:
    names = ("Ann Lee_11_assignsubmission_file_/t.csv", "lee_LATE_1234_5678_t.csv", "t.csv")
    assert [identifier_of(name) for name in names] == ["Participant 11", "1234", None]


OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
PACKAGE = "http://schemas.openxmlformats.org/package/2006"
SHEET = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"


def workbook(rows: bytes) -> bytes:
    """A workbook of one sheet, as small as a reader takes it."""
    link = f'<Relationships xmlns="{PACKAGE}/relationships"><Relationship Id="r1" Type="{OFFICE}/'
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("[Content_Types].xml", f'<Types xmlns="{PACKAGE}/content-types"/>')
        archive.writestr("_rels/.rels", f'{link}officeDocument" Target="xl/workbook.xml"/></Relationships>')
        archive.writestr(
            "xl/_rels/workbook.xml.rels", f'{link}worksheet" Target="worksheets/sheet1.xml"/></Relationships>'
        )
        archive.writestr(
            "xl/workbook.xml",
            f'<workbook xmlns="{SHEET}" xmlns:r="{OFFICE}"><sheets><sheet name="a" sheetId="1" r:id="r1"/>'
            "</sheets></workbook>",
        )
        text = f'<worksheet xmlns="{SHEET}"><sheetData>'.encode() + rows + b"</sheetData></worksheet>"
        archive.writestr("xl/worksheets/sheet1.xml", text)
    return stream.getvalue()


def cells(number: int, *places: str) -> bytes:
    found = "".join(f'<c r="{place}"><v>1</v></c>' for place in places)
    return f'<row r="{number}">{found}</row>'.encode()


@pytest.mark.parametrize(
    ("rows", "code"),
    [
        (cells(1, "A1") + cells(1_048_576, "XFD1048576"), "file_unreadable"),
        (cells(1, "A1", "XFD1") + cells(1000, "A1000"), "file_unreadable"),
        (b" " * (65 * 1024 * 1024), "file_unreadable"),
        (cells(1, "A1") + b'<row r="1048576"><c r="XFD1048576" s="1"/></row>', "columns_unknown"),
        (b'<row r="900000"><c><v>1</v></c><c><v>1</v></c></row>', "file_unreadable"),
        (b'<row><c x=">" r="XFD1048576" y="/>"><v>1</v></c></row>', "file_unreadable"),
        (b"<c " * 1_000_000, "file_unreadable"),
        (b"<row>" + b"<c/>" * 2_000_000 + b"</row>", "file_unreadable"),
        (cells(1, "A1") + cells(90_000, "H90000"), "columns_unknown"),
    ],
)
def test_a_cell_far_out_is_refused_before_its_sheet_is_made(rows: bytes, code: str) -> None:
    """The reader made all cells up to it, and ended the program where it got no memory for them."""
    with pytest.raises(RequestError) as refused:
        read_tables("ann.xlsx", workbook(rows), TableSettings())
    assert [fault.code for fault in refused.value.faults] == [code]


OASIS = "urn:oasis:names:tc:opendocument:xmlns"
FULL = '<table:table-cell office:value-type="float" office:value="1" table:number-columns-repeated="{}"/>'
EMPTY = '<table:table-cell table:number-columns-repeated="16384"/>'


def document(*sheets: str) -> bytes:
    """An OpenDocument workbook, as small as a reader takes it."""
    names = "".join(f' xmlns:{name}="{OASIS}:{name}:1.0"' for name in ("office", "table", "text"))
    tables = "".join(f'<table:table table:name="t{i}">{rows}</table:table>' for i, rows in enumerate(sheets))
    body = f"<office:body><office:spreadsheet>{tables}</office:spreadsheet></office:body>"
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("mimetype", "application/vnd.oasis.opendocument.spreadsheet")
        manifest = f'<m:manifest xmlns:m="{OASIS}:manifest:1.0"/>'
        archive.writestr("META-INF/manifest.xml", manifest)
        archive.writestr("content.xml", f"<office:document-content{names}>{body}</office:document-content>")
    return stream.getvalue()


def repeated(count: str, columns: str) -> str:
    """A row of full cells."""
    return f'<table:table-row table:number-rows-repeated="{count}">{FULL.format(columns)}</table:table-row>'


EMPTY_ROWS = f'<table:table-row table:number-rows-repeated="1048576">{EMPTY}</table:table-row>'


@pytest.mark.parametrize(
    ("sheets", "code"),
    [
        ((repeated("100000", "1000"),), "file_unreadable"),
        ((repeated("+100000", "+1000"),), "file_unreadable"),
        ((repeated("99999999999", "1"),), "file_unreadable"),
        ((repeated("1", "1") + EMPTY_ROWS + repeated("1", "9"),), "file_unreadable"),
        ((repeated("10000", "100"),) * 100, "file_unreadable"),
        ((repeated("1", "9") + EMPTY_ROWS,), "columns_unknown"),
    ],
)
def test_cells_that_repeat_are_counted_before_their_sheet_is_made(sheets: tuple[str, ...], code: str) -> None:
    """Seven hundred bytes ended the grading of a class."""
    with pytest.raises(RequestError) as refused:
        read_tables("ann.ods", document(*sheets), TableSettings())
    assert [fault.code for fault in refused.value.faults] == [code]


def binary_workbook(*cells: tuple[int, int, float | str], sheets: int = 1) -> bytes:
    """An Excel 97 workbook ([MS-XLS] in [MS-CFB]) of equal sheets, as small as a reader takes it."""

    def record(kind: int, content: bytes) -> bytes:
        return struct.pack("<HH", kind, len(content)) + content

    def cell(row: int, column: int, value: float | str) -> bytes:
        place = struct.pack("<HHH", row, column, 0)
        if isinstance(value, str):
            return record(0x204, place + struct.pack("<HB", len(value), 0) + value.encode())
        return record(0x203, place + struct.pack("<d", value))

    end = record(0x0A, b"")
    book = record(0x809, struct.pack("<HHHHII", 0x600, 5, 0, 0, 0, 6))
    first = len(book) + sheets * 14 + len(end)
    sheet = record(0x809, struct.pack("<HHHHII", 0x600, 0x10, 0, 0, 0, 6))
    sheet += b"".join(cell(*each) for each in cells) + end
    for number in range(sheets):
        book += record(0x85, struct.pack("<IHBB", first + number * len(sheet), 0, 2, 0) + b"%02d" % number)
    stream = (book + end + sheet * sheets).ljust(4096, b"\0")
    stream += b"\0" * (-len(stream) % 512)
    count = len(stream) // 512
    free, last, table = 0xFFFFFFFF, 0xFFFFFFFE, 0xFFFFFFFD
    chains = [table, last, *range(3, count + 2), last]

    def entry(name: str, kind: int, child: int, start: int, size: int) -> bytes:
        text = name.encode("utf-16-le")
        links = struct.pack("<HBBIII", len(text) + 2, kind, 1, free, free, child)
        return text.ljust(64, b"\0") + links + bytes(36) + struct.pack("<IQ", start, size)

    entries = entry("Root Entry", 5, 1, last, 0) + entry("Workbook", 2, free, 2, len(stream))
    head = bytes.fromhex("d0cf11e0a1b11ae1") + bytes(16) + struct.pack("<HHHHH", 0x3E, 3, 0xFFFE, 9, 6)
    head += bytes(10) + struct.pack("<IIIIIIIII", 1, 1, 0, 4096, last, 0, last, 0, 0)
    head += struct.pack("<I", free) * 108
    fat = struct.pack(f"<{len(chains)}I", *chains).ljust(512, b"\xff")
    return head + fat + entries.ljust(512, b"\0") + stream


HEADER = tuple((0, i, title) for i, title in enumerate(("theta", "d", "a", "alpha")))


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (binary_workbook(*HEADER, (65535, 255, 1.0), sheets=12), "> 1 GiB, > 20 s"),
        (binary_workbook(*HEADER, (65535, 255, 1.0)), "> 1 GiB, > 20 s"),
        (binary_workbook(*HEADER, *((60_000, i, 1.0) for i in range(4)), sheets=30), "60000 × 3"),
    ],
    ids=["more than there is memory", "more than are read", "many sheets"],
)
def test_a_workbook_that_takes_too_much_ends_nothing_but_its_reader(content: bytes, reason: str) -> None:
    """Five kilobytes in the format of Excel 97 ended the grading of a class."""
    with pytest.raises(RequestError) as refused:
        read_tables("eve.xls", content, TableSettings())
    (fault,) = refused.value.faults
    assert (fault.code, fault.params["reason"]) == ("file_unreadable", reason)
    rows = ((i, j, float(i + j)) for i in range(1, 3) for j in range(4))
    (found,) = read_tables("ann.xls", binary_workbook(*HEADER, *rows), TableSettings())
    assert [row["alpha"] for row in found.table["rows"]] == [4, 5]
