"""What is done with bytes of each kind; a refusal is what the reader promises, all else is a finding.

Warnings of numpy are findings, and so are explanations that fail: they are logged as errors, and the verdict
stands. So is what costs more than a second of processor time.
"""

import gc
import json
import logging
import time
import warnings
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from typing import Any

from joserfc import jwt
from joserfc.jwk import RSAKey

from courses.model import Platform
from exercises.answers import parse
from exercises.authoring.archive import draft_of_archive
from exercises.authoring.draft import exercise_of_draft
from exercises.errors import ExerciseError
from exercises.grader import grade
from exercises.instance import Instance, generate
from exercises.library import packaged
from exercises.written_table import written_table
from kinematics.cells import Limits, ParameterKind, read_cell
from kinematics.errors import KinematicsError
from kinematics.scm.chain_reading import read_chain
from kinematics.table import CELLS, Convention
from kinematics.urdf.table_reading import chain_from_urdf, table_from_urdf
from service.adapters.scorm import ScormPackage, ScormVersion, manifest, package
from service.adapters.table_files import TableSettings, read_tables
from service.course_resources import now
from service.http.decoding import decode_json
from service.http.npy import read_npy
from service.http.problems import ServiceError
from service.http.validation import validated
from service.lti.launch import Expected, read_launch
from service.receipts.keys import keys_of_secret
from service.receipts.receipt import verify
from service.schemas.exercises.exercises import ExerciseAnswer
from service.schemas.kinematics.scm import ScmChainModel

REFUSALS = (KinematicsError, ExerciseError, ServiceError)
SLOW_SECONDS = 1.0
LARGEST = 64 * 1024
"""Longer inputs are cut: limits are tested elsewhere, and short ones find more in the same time."""
ISSUER, CLIENT, NONCE, KID = "https://lms.example", "client", "nonce", "k1"


class FindingError(AssertionError):
    """Something that no reader may do."""


class _Collecting(logging.Handler):
    """Keeps what is logged as an error."""

    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.found: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.found.append(logging.Formatter().format(record))


_LOGGED = _Collecting()


@contextmanager
def _uncollected() -> Iterator[None]:
    """Put collections off: what other tests of the process have left is no work of a reader."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


@contextmanager
def watched() -> Iterator[None]:
    """Let refusals pass, and raise whatever else happens.

    Raises:
        FindingError: a warning, an error in the log, or too much work.
    """
    _LOGGED.found.clear()
    logging.getLogger().addHandler(_LOGGED)  # each time: a service that starts configures the log anew
    with warnings.catch_warnings(), _uncollected():
        warnings.simplefilter("error")
        begun = time.thread_time()
        with suppress(REFUSALS):
            yield
        spent = time.thread_time() - begun
    if _LOGGED.found:
        raise FindingError(_LOGGED.found[0])
    if spent > SLOW_SECONDS:
        raise FindingError(f"{spent:.1f} s of processor time")


def run(name: str, data: bytes) -> None:
    """Give bytes to a target."""
    with watched():
        TARGETS[name](data[:LARGEST])


def _cells(data: bytes) -> None:
    for line in data.decode("utf-8", "replace").splitlines()[:20]:
        for kind in ParameterKind:
            try:
                read_cell(line, kind)
            except KinematicsError:
                continue


def _tables(data: bytes) -> None:
    """An answer to an exercise, from the JSON to the verdict with everything that is told."""
    instance = _instance()
    raw = validated(ExerciseAnswer, decode_json(data)).raw()
    grade(instance, parse(instance, raw, Limits()))


def _answers(data: bytes) -> None:
    """A right table in which each three bytes change a cell: every input is an answer that is judged."""
    exercise = packaged().exercise("puma560")
    rows = [{cell: getattr(row, cell) for cell in CELLS} for row in written_table(exercise.reference).rows]
    for row, cell, value in zip(data[0:24:3], data[1:24:3], data[2:24:3], strict=False):
        if cell % 8 == 7:
            rows.insert(row % len(rows), dict.fromkeys(CELLS, "0"))
        else:
            rows[row % len(rows)][CELLS[cell % 4]] = VALUES[value % len(VALUES)]
    unit = "rad" if len(data) % 2 else "deg"
    table = {"convention": "modified", "angle_unit": unit, "length_unit": "mm", "rows": rows}
    grade(_instance(), parse(_instance(), validated(ExerciseAnswer, {"table": table}).raw(), Limits()))


VALUES = (
    "0", "1", "90", "-90", "180", "pi/2", "45.0000001", "1e-9", "1e-300", "5e-324", "1e15", "-1e15",
    "a2", "a3", "d3", "d4", "-a3", "-d4", "a2+a3", "a2/3", "a2*1e15", "a2*1e-300", "a2^8", "d4^16", "1/d4^16",
    "a3^16/d3^15", "sqrt(a2^16)", "a2+1e-12", "q1", "q2", "-q3", "q4+90", "q5-1e15", "q6+1e-300",
    "999999999999999", "1e15*sin(1e15)", "(a2*1e15)^16",
)  # fmt: skip
"""What stands in cells: what students write, and numbers of every size."""


@cache
def _instance() -> Instance:
    return generate(packaged().exercise("puma560"), "fuzz")


def _npy(data: bytes) -> None:
    read_npy(data)


def _urdf(data: bytes) -> None:
    text = data.decode("utf-8", "replace")
    chain_from_urdf(text)
    table_from_urdf(text, Convention.STANDARD)
    table_from_urdf(text, Convention.MODIFIED)


def _scm(data: bytes) -> None:
    read_chain(validated(ScmChainModel, decode_json(data)).raw(), Limits())


def _pasted(data: bytes) -> None:
    name, _, content = data.partition(b"\n")
    suffix = name.decode("ascii", "replace").strip() or ".csv"
    read_tables(f"table{suffix[:6]}", content, TableSettings())


@dataclass(frozen=True)
class _OneKey:
    """The keys of a platform that has one."""

    known: RSAKey

    def key(self, platform: Any, kid: str) -> RSAKey:
        return self.known


@cache
def _platform_key() -> RSAKey:
    return RSAKey.generate_key(2048, {"kid": KID})


def _tokens(data: bytes) -> None:
    """Bytes as a token; and, where they are JSON, as claims that the platform has signed."""
    texts = [data.decode("utf-8", "replace")]
    try:
        claims = json.loads(data)
    except (ValueError, RecursionError):
        claims = None
    if isinstance(claims, dict):
        at = int(now().timestamp())
        usual = {"iss": ISSUER, "aud": CLIENT, "nonce": NONCE, "iat": at, "exp": at + 300}
        texts.append(jwt.encode({"alg": "RS256", "kid": KID}, {**usual, **claims}, _platform_key()))
    platform = Platform(
        issuer=ISSUER, client_id=CLIENT, authorization_endpoint="", token_endpoint="", jwks_uri=""
    )
    expected = Expected(
        platform=platform,
        nonce=NONCE,
        target="https://tool.example/",
        use_nonce=lambda nonce, begun, life: True,
        knows_deployment=lambda _: True,
    )
    for text in texts:
        try:
            read_launch(text, expected, _OneKey(_platform_key()), now())  # type: ignore[arg-type]
        except REFUSALS:
            continue


def _receipts(data: bytes) -> None:
    verify(data.decode("utf-8", "replace"), keys_of_secret(b"fuzz"))


def _zips(data: bytes) -> None:
    exercise_of_draft(draft_of_archive(data))


def _scorm(data: bytes) -> None:
    """A package of whatever title and address: its manifest is XML, and says the title."""
    lines = [*data.decode("utf-8", "ignore").split("\n"), "", "", ""]
    what = ScormPackage(
        version=ScormVersion.V1_2 if len(data) % 2 else ScormVersion.V2004,
        identifier="puma560",
        title=lines[0],
        language="en",
        url=f"https://framewise.example/{lines[1]}",
        per_student=True,
        pass_mark=0.5,
        sentences={"no_script": lines[2], "no_lms": lines[2]},
    )
    try:
        root = ElementTree.fromstring(manifest(what))
    except ElementTree.ParseError as error:
        raise FindingError(f"the manifest is no XML: {error}") from error
    if not any(element.tag.endswith("title") for element in root.iter()):
        raise FindingError("the manifest names nothing")
    package(what)


def _json(data: bytes) -> None:
    decode_json(data)


TARGETS: Mapping[str, Callable[[bytes], None]] = {
    "cells": _cells,
    "tables": _tables,
    "answers": _answers,
    "npy": _npy,
    "urdf": _urdf,
    "scm": _scm,
    "pasted": _pasted,
    "tokens": _tokens,
    "receipts": _receipts,
    "zips": _zips,
    "scorm": _scorm,
    "json": _json,
}
"""Every kind of input."""
