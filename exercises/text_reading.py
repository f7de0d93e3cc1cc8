"""What a lecturer writes for students: titles, statements and remarks, in one language or more."""

import re
from collections.abc import Mapping
from types import MappingProxyType

from exercises.definition import LANGUAGES
from exercises.definition_files import STATEMENT, statement_file
from exercises.grading.edits.misconceptions import repair_codes
from exercises.reading import Reader
from exercises.statements import LONGEST_STATEMENT, LONGEST_TITLE, text_faults
from kinematics.errors import Fault

_LANGUAGE = re.compile(r"[a-z]{2}")


def checked_statements(statements: Mapping[str, str], faults: list[Fault]) -> Mapping[str, str]:
    """Return the statements by language; one is enough."""
    for language, text in statements.items():
        name = statement_file(language)
        if not STATEMENT.fullmatch(name):
            faults.append(Fault.at("exercise_key_unknown", name, key=language, known=", ".join(LANGUAGES)))
        elif not text.strip():
            faults.append(Fault.at("statement_missing", name, language=language))
        else:
            faults += (fault.within(name) for fault in text_faults(text, LONGEST_STATEMENT))
    if not statements:
        first = LANGUAGES[0]
        where = (statement_file(first),)
        faults.append(Fault.at("statement_missing", *where, language=first))
    return MappingProxyType(dict(statements))


def read_titles(reader: Reader, statements: Mapping[str, str]) -> Mapping[str, str]:
    """Return the titles by language; one is needed of which there is a statement, too."""
    titles = _by_language(reader.table("title", needed=True), LONGEST_TITLE)
    if reader.given("title") and statements and not titles.keys() & statements.keys():
        reader.fault("title_missing", "title")
    return titles


def read_remarks(reader: Reader) -> Mapping[str, Mapping[str, str]]:
    """Return the lecturer's own words on misconceptions."""
    remarks: dict[str, Mapping[str, str]] = {}
    for code, inner in reader.tables("remarks"):
        if code not in repair_codes():
            inner.fault("misconception_unknown", name=code, known=", ".join(sorted(repair_codes())))
        if not inner.values:
            inner.missing(LANGUAGES[0])
        remarks[code] = _by_language(inner, LONGEST_STATEMENT)
    return MappingProxyType(remarks)


def _by_language(reader: Reader, longest: int) -> Mapping[str, str]:
    """Return the texts of a table whose keys are languages."""
    texts = {language: reader.text(language) for language in reader.values}
    for language, text in texts.items():
        reader.faults.extend(fault.within(*reader.where, language) for fault in text_faults(text, longest))
        if _LANGUAGE.fullmatch(language) is None:
            reader.fault("exercise_key_unknown", language, key=language, known=", ".join(LANGUAGES))
    return MappingProxyType(texts)
