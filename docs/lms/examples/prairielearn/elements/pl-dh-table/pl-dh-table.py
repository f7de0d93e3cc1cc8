"""<pl-dh-table answers-name="table" exercise="twolink" rows="2"></pl-dh-table>: a DH table, graded by Framewise.

Attributes: `answers-name`, `exercise`, `rows`, `convention` (standard or modified; both may be chosen if left out),
`angle-unit`, `length-unit`, `weight`, `language`, `seed` (the variant's seed draws the student's values if it is
"variant"). The wheel has to be in the course's image.
"""

import html

import lxml.html

from framewise import check

COLUMNS = ("theta", "d", "a", "alpha")
SHOWN = {"theta": "θ", "d": "d", "a": "a", "alpha": "α"}
MOST_ROWS = 20


def prepare(element_html, data):
    element = lxml.html.fragment_fromstring(element_html)
    for needed in ("answers-name", "exercise"):
        if needed not in element.attrib:
            raise ValueError(f"pl-dh-table needs the attribute {needed}")
    if element.get("answers-name") == "table":  # what the external grader reads
        data["params"]["framewise"] = {"exercise": element.get("exercise"), "seed": _seed(element, data)}


def render(element_html, data):
    element = lxml.html.fragment_fromstring(element_html)
    name = element.get("answers-name")
    if data["panel"] == "question":
        return _form(element, name, data["raw_submitted_answers"], data["editable"])
    if data["panel"] == "submission":
        faults = data["format_errors"].get(name)
        told = data["partial_scores"].get(name, {}).get("feedback", []) if faults is None else faults
        return "".join(f"<p>{html.escape(line)}</p>" for line in told)
    return ""


def parse(element_html, data):
    element = lxml.html.fragment_fromstring(element_html)
    name = element.get("answers-name")
    raw = data["raw_submitted_answers"]
    rows = [
        {column: raw.get(_field(name, i, column), "").strip() for column in COLUMNS}
        for i in range(_rows(element))
    ]
    table = {
        "convention": raw.get(f"{name}-convention", element.get("convention", "standard")),
        "angle_unit": element.get("angle-unit", "deg"),
        "length_unit": element.get("length-unit", "m"),
        "rows": [row for row in rows if any(row.values())],
    }
    data["submitted_answers"][name] = table
    checked = _checked(element, table, data)
    if not checked.gradable:
        data["format_errors"][name] = list(checked.feedback)


def grade(element_html, data):
    element = lxml.html.fragment_fromstring(element_html)
    name = element.get("answers-name")
    checked = _checked(element, data["submitted_answers"][name], data)
    data["partial_scores"][name] = {
        "score": checked.score,
        "weight": int(element.get("weight", "1")),
        "feedback": list(checked.feedback),
    }


def _checked(element, table, data):
    language = element.get("language", "en")
    return check(table, element.get("exercise"), seed=_seed(element, data), language=language)


def _seed(element, data):
    return str(data["variant_seed"]) if element.get("seed") == "variant" else None


def _rows(element):
    return min(int(element.get("rows", "6")), MOST_ROWS)


def _field(name, row, column):
    return f"{name}-{row}-{column}"


def _form(element, name, typed, editable):
    disabled = "" if editable else " disabled"
    head = "".join(f'<th scope="col">{SHOWN[column]}</th>' for column in COLUMNS)
    body = "".join(
        f'<tr><th scope="row">{i + 1}</th>'
        + "".join(
            f'<td><input name="{html.escape(_field(name, i, column))}" aria-label="{SHOWN[column]} {i + 1}" '
            f'value="{html.escape(str(typed.get(_field(name, i, column), "")))}"{disabled}></td>'
            for column in COLUMNS
        )
        + "</tr>"
        for i in range(_rows(element))
    )
    choice = ""
    if "convention" not in element.attrib:
        chosen = typed.get(f"{name}-convention", "standard")
        options = "".join(
            f'<option value="{value}"{" selected" if value == chosen else ""}>{value}</option>'
            for value in ("standard", "modified")
        )
        choice = f'<label>Convention <select name="{html.escape(name)}-convention"{disabled}>{options}</select></label>'
    return f'<div class="pl-dh-table">{choice}<table><thead><tr><th scope="col">i</th>{head}</tr></thead><tbody>{body}</tbody></table></div>'
