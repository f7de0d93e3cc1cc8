"""Figures as files under addresses made from what they show.

Two students with the same values, in whatever process, have the same address; another value, another language
or another version of exercise or program has another one. What an address shows therefore never changes.
What is drawn is shared more widely than that: by all whose figures differ in words alone.
"""

import hashlib
import struct
import zlib
from functools import lru_cache
from urllib.parse import urlencode

import orjson

from exercises.definition import Exercise
from exercises.drawings import drawn_values, figure_drawing
from exercises.figures.svg import document, opening, rest
from exercises.instance import Instance
from exercises.parts.mistakes.frame_mistake import frames_shown
from service.messages import sentence
from service.revision import revision
from service.wire.exercises.exercise_views import figure_description
from service.work.shared_answers import SharedAnswers, address_of

CACHED_DIGESTS = 256  # Exercises whose digest is in the cache.
CACHED_ADDRESSES = 2048
"""Addresses of figures in the cache: the page, the exercise and the figure itself each ask for it."""
LEVEL = 4  # Level of compression: the higher ones take twice as long and save three bytes in a hundred.
_RAW = -zlib.MAX_WBITS  # Has zlib write neither header nor checksum.
_GZIP = b"\x1f\x8b\x08\0\0\0\0\0\0\xff"
"""The header of a gzip file (RFC 1952 §2.3): deflated, without a name and a time."""


def figure_address(figures: SharedAnswers, instance: Instance, language: str) -> str:
    """Return the address of a figure: a digest of all that it follows from."""
    return _address(figures.kind, instance, language)


@lru_cache(maxsize=CACHED_ADDRESSES)
def _address(kind: str, instance: Instance, language: str) -> str:
    title = instance.exercise.title(language)
    told = repr((dict(instance.exact), frames_shown(instance)))
    return address_of(kind, _drawn_alike(instance.exercise), language, title, told)


def drawing_address(figures: SharedAnswers, instance: Instance, note: str) -> str:
    """Return the address of what is drawn: of all figures that differ in words alone, the same."""
    told = repr((drawn_values(instance), frames_shown(instance)))
    return figures.address(_drawn_alike(instance.exercise), "drawing", note, told)


@lru_cache(maxsize=CACHED_DIGESTS)
def _drawn_alike(exercise: Exercise) -> bytes:
    """A digest of what all figures of an exercise follow from, whatever a student's values are."""
    policy = exercise.policy
    told = (
        revision(),
        repr(exercise.figure),
        repr(exercise.reference),
        repr((policy, exercise.length_unit, exercise.angle_unit)),
    )
    return hashlib.sha256("\n".join(told).encode()).digest()


def figure_path(figures: SharedAnswers, instance: Instance, language: str, asked: str | None = None) -> str:
    """Return the path of a figure below the API's root, by which any process can draw it.

    Its query is the one that was asked with, or else tells language and seed alone.
    """
    address = figure_address(figures, instance, language)
    seed = {} if instance.seed is None else {"seed": instance.seed}
    query = asked if asked is not None else urlencode({"lang": language, **seed})
    return f"exercises/{instance.exercise.id}/figures/{address}.svg?{query}"


def known_figure(figures: SharedAnswers, instance: Instance, language: str) -> bytes | None:
    """Return a figure, gzipped, if this process has its drawing in memory; else None."""
    address = figure_address(figures, instance, language)
    packed = figures.known(address)
    if packed is None:
        drawn = figures.known(drawing_address(figures, instance, _note(language)))
        if drawn is not None:
            packed = _told(figures, address, drawn, instance, language)
    return packed


def packed_figure(figures: SharedAnswers, instance: Instance, language: str) -> bytes:
    """Return a figure, gzipped: from memory, as another process stored it, or drawn now."""
    known = known_figure(figures, instance, language)
    if known is not None:
        return known
    drawn = _drawn(figures, drawing_address(figures, instance, _note(language)), instance, language)
    return _told(figures, figure_address(figures, instance, language), drawn, instance, language)


def draw_ahead(figures: SharedAnswers, instance: Instance, language: str) -> bool:
    """Bring a drawing into memory, stored by another process or drawn now; False if it was there."""
    address = drawing_address(figures, instance, _note(language))
    if figures.known(address) is not None:
        return False
    _drawn(figures, address, instance, language)
    return True


def _drawn(figures: SharedAnswers, address: str, instance: Instance, language: str) -> bytes:
    """Return what is drawn: a line with its box, and all that follows on a file's opening, deflated.

    It is as some process has drawn it, else drawn now.
    """
    drawn = figures.stored(address)
    if drawn is None:
        drawing = figure_drawing(instance, _note(language), frames_shown(instance))
        drawn = orjson.dumps(drawing.box) + b"\n" + _deflated(rest(drawing).encode(), zlib.Z_FINISH)
        figures.keep(address, drawn)
    return drawn


def figure_file(instance: Instance, language: str) -> bytes:
    """Draw the figure as an SVG file."""
    drawing = figure_drawing(instance, _note(language), frames_shown(instance))
    return document(drawing, **_words(instance, language)).encode()


def _told(figures: SharedAnswers, address: str, drawn: bytes, instance: Instance, language: str) -> bytes:
    """What is drawn, as a file with its words, gzipped; this process keeps it."""
    box, _, deflated = drawn.partition(b"\n")
    packed = _gzipped(opening(tuple(orjson.loads(box)), **_words(instance, language)).encode(), deflated)
    figures.remember(address, packed)
    return packed


def _words(instance: Instance, language: str) -> dict[str, str]:
    title = sentence(language, "figure-title", {"title": instance.exercise.title(language)}) or ""
    return {"title": title, "description": figure_description(instance, language), "language": language}


def _deflated(data: bytes, flush: int) -> bytes:
    packing = zlib.compressobj(LEVEL, zlib.DEFLATED, _RAW)
    return packing.compress(data) + packing.flush(flush)


def _gzipped(begin: bytes, deflated: bytes) -> bytes:
    """One gzip file of what begins it and what has been deflated before: that is not done again."""
    end = zlib.decompress(deflated, _RAW)
    checks = struct.pack("<II", zlib.crc32(end, zlib.crc32(begin)), len(begin) + len(end))
    return _GZIP + _deflated(begin, zlib.Z_SYNC_FLUSH) + deflated + checks


def _note(language: str) -> str:
    return sentence(language, "figure-note") or ""
