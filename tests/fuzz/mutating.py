"""Inputs from the corpus, changed at random: cut, doubled, mixed, with bytes and words put in."""

import random
from collections.abc import Iterator
from pathlib import Path

CORPUS = Path(__file__).resolve().parent / "corpus"
WORDS = tuple(
    word.encode()
    for word in (
        "0", "-1", "1e308", "-1e-308", "1e400", "NaN", "null", "true", "[]", "{}", '""', "\\u0000", "π", "²",
        "√", "sin(", ")", "**", "/", "//", "-", "q1", "θ1", "L1", "a2", "90", "pi/2", "deg", "alpha", "theta",
        ";", ",", "\t", "\r\n", "|", "&", "\\\\", "<joint", "/>", "<!ENTITY x 'y'>", "&x;", "xyz=", "rpy=",
        "2147483648", "99999999999999999999", "../", "\ufeff", "\ud7ff", "\u202e",
    )
)  # fmt: skip
MOST_CHANGES = 6


def corpus(target: str) -> dict[str, bytes]:
    """The inputs that are kept for a target, by the names of their files."""
    return {path.name: path.read_bytes() for path in sorted((CORPUS / target).iterdir())}


def mutations(target: str, seed: int) -> Iterator[bytes]:
    """Inputs without end; the same for the same seed."""
    chance = random.Random(f"{target} {seed}")
    seeds = list(corpus(target).values())
    while True:
        data = bytearray(chance.choice(seeds))
        for _ in range(chance.randint(1, MOST_CHANGES)):
            mutate(data, seeds, chance)
        yield bytes(data)


def mutate(data: bytearray, seeds: list[bytes], chance: random.Random) -> None:
    """One change in place."""
    at = chance.randint(0, len(data))
    to = min(len(data), at + chance.choice((1, 1, 2, 4, 16, 200)))
    match chance.randrange(7):
        case 0:
            del data[at:to]
        case 1:
            data[at:at] = chance.choice(WORDS)
        case 2:
            data[at:to] = chance.choice(WORDS)
        case 3:
            data[at:at] = data[at:to] * chance.choice((1, 2, 10))
        case 4:
            other = chance.choice(seeds)
            start = chance.randint(0, len(other))
            data[at:to] = other[start : start + chance.randint(0, 60)]
        case 5 if data:
            data[at % len(data)] ^= 1 << chance.randrange(8)
        case _:
            data[at:to] = bytes(chance.randrange(256) for _ in range(chance.choice((1, 2, 8))))
