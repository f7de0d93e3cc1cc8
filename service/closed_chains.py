"""Closed forms of SCM chains as the wire shows them: what a worker process computes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.expressions import evaluate
from kinematics.jacobian import JacobianFrame
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.scm import (
    ReadChain,
    ScmChain,
    closed_form_scm,
    inverse_closed_form_scm,
    jacobian_by_differentiation,
    jacobian_closed_form_scm,
)
from kinematics.symbolic import Matrix

DEFAULT_FORMATS = (Format.TEXT, Format.LATEX)


class Wanted(StrEnum):
    """Which closed forms are wanted."""

    FORWARD_KINEMATICS = "forward_kinematics"
    INVERSE_TRANSFORM = "inverse_transform"
    INSPECTED_JACOBIANS = "inspected_jacobians"
    DIFFERENTIATED_JACOBIANS = "differentiated_jacobians"


@dataclass(frozen=True, kw_only=True, slots=True)
class ChainTask:
    """A closed form to be written.

    Attributes:
        chain: the chain.
        parameters: names of its parameters.
        wanted: which matrices.
        formats: in which formats.
        notation: how sines and cosines are written.
    """

    chain: ScmChain
    parameters: tuple[str, ...]
    wanted: Wanted
    formats: tuple[Format, ...]
    notation: Notation

    @classmethod
    def of(
        cls, read: ReadChain, wanted: Wanted, formats: Sequence[Format] | None, notation: Notation
    ) -> ChainTask:
        """The task of a request."""
        chosen = tuple(formats) if formats else DEFAULT_FORMATS
        return cls(
            chain=read.chain,
            parameters=tuple(read.parameters),
            wanted=wanted,
            formats=chosen,
            notation=notation,
        )


def written_chain(task: ChainTask) -> dict[str, Any]:
    """The wanted matrices in the wanted formats, with the variables and the meaning of short names.

    Raises:
        FormSizeError: a matrix has too many operations to be written out.
    """
    n = task.chain.n_joints
    printer = MatrixPrinter(n_joints=n, parameters=task.parameters, notation=task.notation)
    matrices = _matrices(task)
    answer: dict[str, Any] = {"variables": [f"q{i}" for i in range(1, n + 1)]}
    for name, found in matrices.items():
        purpose = _PURPOSES[name]
        if isinstance(found, list):
            answer[name] = [printer.write(matrix, task.formats, purpose) for matrix in found]
        else:
            answer[name] = printer.write(found, task.formats, purpose)
    flat = [
        matrix for found in matrices.values() for matrix in (found if isinstance(found, list) else [found])
    ]
    answer["symbols"] = printer.symbols(flat)
    return answer


def _matrices(task: ChainTask) -> dict[str, Matrix | list[Matrix]]:
    chain = task.chain
    if task.wanted is Wanted.INVERSE_TRANSFORM:
        return {"transform": inverse_closed_form_scm(chain)}
    if task.wanted is Wanted.INSPECTED_JACOBIANS:
        return {
            "J0": jacobian_closed_form_scm(chain, JacobianFrame.BASE),
            "Jn": jacobian_closed_form_scm(chain, JacobianFrame.END),
        }
    form = closed_form_scm(chain)
    if task.wanted is Wanted.DIFFERENTIATED_JACOBIANS:
        return {
            "J0": jacobian_by_differentiation(form.transform, chain.n_joints, JacobianFrame.BASE),
            "Jn": jacobian_by_differentiation(form.transform, chain.n_joints, JacobianFrame.END),
        }
    return {
        "transform": form.transform,
        "links": list(form.links),
        "frames": list(form.frames),
        "end": form.end,
    }


def jacobians_at(
    chain: ScmChain, values: Mapping[str, float], joints: Sequence[float]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """J0 and Jn by differentiation (eq. 3.24), in numbers.

    Raises:
        ParameterError: an entry has no finite value.
    """
    transform = closed_form_scm(chain).transform
    base, end = (
        jacobian_by_differentiation(transform, chain.n_joints, frame)
        for frame in (JacobianFrame.BASE, JacobianFrame.END)
    )
    return _numbers(base, values, joints), _numbers(end, values, joints)


def _numbers(matrix: Matrix, values: Mapping[str, float], joints: Sequence[float]) -> NDArray[np.float64]:
    return np.array([[evaluate(entry, values, joints) for entry in row] for row in matrix])


_PURPOSES = {
    "transform": Purpose(name="chain_transform", meaning="pose of the tool in frame 0"),
    "links": Purpose(name="chain_link", meaning="pose of frame i in frame i-1", result="H"),
    "frames": Purpose(name="chain_frame", meaning="pose of frame i in frame 0", result="H"),
    "end": Purpose(name="chain_end", meaning="Final Transformation times tool", result="H"),
    "J0": Purpose(name="jacobian_base", meaning="Jacobian in the axes of frame 0", result="J"),
    "Jn": Purpose(name="jacobian_end", meaning="Jacobian in the axes of the tool", result="J"),
}
