"""Closed forms of SCM chains as the wire shows them: what a worker process computes."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from kinematics.printing import Format, Notation, Purpose
from kinematics.scm import (
    ReadChain,
    ScmChain,
    closed_form_scm,
    inverse_closed_form_scm,
    jacobian_closed_form_scm,
    verify,
)
from kinematics.scm.products import jacobian_of_product
from kinematics.symbolic import Matrix
from service.schemas.tables import units_of
from service.wire.kinematics.symbolic_forms import JACOBIANS, Writing

DEFAULT_FORMATS = (Format.TEXT, Format.LATEX)
_QUICK_JOINTS = 8
_QUICK_DERIVATIVES = 4
"""Joints of a chain whose closed forms are answered at once, without a process of their own; of one whose
matrix is differentiated, too."""


class Wanted(StrEnum):
    """Which closed forms are wanted."""

    FORWARD_KINEMATICS = "forward_kinematics"
    INVERSE_TRANSFORM = "inverse_transform"
    INSPECTED_JACOBIANS = "inspected_jacobians"
    DIFFERENTIATED_JACOBIANS = "differentiated_jacobians"


@dataclass(frozen=True, kw_only=True, slots=True)
class ChainTask:
    """A closed form to be written."""

    chain: ScmChain
    parameters: tuple[str, ...]
    variables: tuple[str, ...]
    wanted: Wanted
    formats: tuple[Format, ...]
    notation: Notation
    head: Mapping[str, Any]

    @classmethod
    def of(
        cls, read: ReadChain, wanted: Wanted, formats: Sequence[Format] | None, notation: Notation
    ) -> "ChainTask":
        """Return the task of a request."""
        return cls(
            chain=read.chain,
            parameters=tuple(read.parameters),
            variables=read.variables,
            wanted=wanted,
            formats=tuple(dict.fromkeys(formats or DEFAULT_FORMATS)),
            notation=notation,
            head={**units_of(read), "variables": list(read.variables), **_STATED.get(wanted, {})},
        )


def is_quick(chain: ScmChain, wanted: Wanted) -> bool:
    """Return whether closed forms of a chain are certain to be small, and found at once."""
    most = _QUICK_DERIVATIVES if wanted is Wanted.DIFFERENTIATED_JACOBIANS else _QUICK_JOINTS
    return chain.n_joints <= most and not verify(chain)


def written_chain(task: ChainTask) -> bytes:
    """Return the wanted matrices in the wanted formats, with the meaning of short names, as JSON.

    Raises:
        FormSizeError: a matrix has too many operations to be written out, or is nested too deeply for JSON.
    """
    writing = Writing(task.formats, task.notation, task.chain.n_joints, task.parameters, task.variables)
    answer: dict[str, Any] = {}
    for name, found in _matrices(task).items():
        matrices = found if isinstance(found, list) else [found]
        forms = [writing.matrix(matrix, _PURPOSES[name]) for matrix in matrices]
        answer[name] = forms if isinstance(found, list) else forms[0]
    return writing.answer(**task.head, **answer)


def _matrices(task: ChainTask) -> dict[str, Matrix | list[Matrix]]:
    chain = task.chain
    if task.wanted is Wanted.INVERSE_TRANSFORM:
        return {"transform": inverse_closed_form_scm(chain)}
    if task.wanted is Wanted.INSPECTED_JACOBIANS:
        return {name: jacobian_closed_form_scm(chain, frame) for frame, name in JACOBIANS.items()}
    form = closed_form_scm(chain)
    if task.wanted is Wanted.DIFFERENTIATED_JACOBIANS:
        return {
            name: jacobian_of_product(form.transform, chain.n_joints, frame)
            for frame, name in JACOBIANS.items()
        }
    return {
        "transform": form.transform,
        "links": list(form.links),
        "frames": list(form.frames),
        "end": form.end,
    }


_STATED = {
    Wanted.INSPECTED_JACOBIANS: {"joint_unit": "rad", "method": "inspection"},
    Wanted.DIFFERENTIATED_JACOBIANS: {"joint_unit": "rad", "method": "differentiation"},
}
_PURPOSES = {
    "transform": Purpose(name="chain_transform", meaning="pose of the tool in frame 0"),
    "links": Purpose(name="chain_link", meaning="pose of frame i in frame i-1", result="H"),
    "frames": Purpose(name="chain_frame", meaning="pose of frame i in frame 0", result="H"),
    "end": Purpose(name="chain_end", meaning="Final Transformation times tool", result="H"),
    "J0": Purpose(name="jacobian_base", meaning="Jacobian in the axes of frame 0", result="J"),
    "Jn": Purpose(name="jacobian_end", meaning="Jacobian in the axes of the tool", result="J"),
}
