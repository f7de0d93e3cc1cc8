"""What a verdict says, in short."""

from exercises.grading import Verdict


def codes(verdict: Verdict) -> list[str]:
    """The codes of its feedback."""
    return [entry.code for entry in verdict.feedback]


def repairs(verdict: Verdict) -> list[list[tuple[str, int | None]]]:
    """Code and row of each edit, repair by repair."""
    return [[(edit.code, edit.row) for edit in repair.edits] for repair in verdict.repairs]
