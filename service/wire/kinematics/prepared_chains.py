"""From what a request says of an SCM chain to one that can be computed with."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace

from kinematics.cells import Limits, parameter_values
from kinematics.errors import DescriptionError, Fault
from kinematics.scm import ReadChain, ScmChain, check_values, read_chain, verify, with_values
from service.http.problems import moved
from service.schemas.kinematics.scm import ChainQuestion, ScmChainModel, Verification
from service.wire.kinematics.exact_values import exact_values
from service.wire.kinematics.prepared_robots import joint_units, listed_robot


@dataclass(frozen=True, kw_only=True, slots=True)
class PreparedChain:
    """A chain that can be computed with.

    Attributes:
        read: the chain, exact.
        values: the value of every parameter [rad, or the chain's length unit].
        angle: what one unit of the request's angles is in [rad].
    """

    read: ReadChain
    values: Mapping[str, float]
    angle: float

    @property
    def chain(self) -> ScmChain:
        """The chain."""
        return self.read.chain

    @property
    def joint_units(self) -> tuple[float, ...]:
        """For joint 1 … n what one unit of the request is in [rad], or in the chain's length unit."""
        return joint_units([row.joint for row in self.chain.rows], self.angle)


def prepared_structure(question: ChainQuestion, limits: Limits) -> ReadChain:
    """Return the chain of a request, read and verified.

    Raises:
        DescriptionError: it cannot be read, or does not pass the document's input check.
        RequestError: the catalogue has no such robot.
    """
    if question.chain is None:
        listed = listed_robot(str(question.robot)).chain
        assert listed is not None  # every file has one: tests/kinematics/catalogue
        return listed.read
    with in_chain("chain", question.chain):
        read = read_chain(question.chain.raw(), limits)
        faults = verify(read.chain) if question.verify is Verification.STRICT else ()
        if faults:
            raise DescriptionError(faults)
    return read


def written_structure(question: ChainQuestion, limits: Limits) -> ReadChain:
    """Return the chain of a request for closed forms: parameters that have a value are gone, the others stay.

    Raises:
        KinematicsError: the chain or its parameters are not right; every fault at its place.
        RequestError: the catalogue has no such robot.
    """
    read = prepared_structure(question, limits)
    values = exact_values(read, question.parameters)
    with in_chain("chain", question.chain):
        chain = with_values(read.chain, values)
    left = {name: kind for name, kind in read.parameters.items() if name not in values}
    return replace(read, chain=chain, parameters=left)


@contextmanager
def in_chain(field: str, chain: ScmChainModel | None) -> Iterator[None]:
    """Place the faults of a chain's entries where the chain was sent, or at `robot` if none was."""

    def place(fault: Fault) -> Fault:
        return replace(fault, where=("robot",) if chain is None else (field, *chain.place(fault.where)))

    with moved(place):
        yield


def prepared_chain(question: ChainQuestion, limits: Limits) -> PreparedChain:
    """Return the chain of a request with a value for every parameter; a catalogue robot brings its own.

    Raises:
        KinematicsError: the chain or its parameters are not right; every fault at its place.
        RequestError: the catalogue has no such robot.
    """
    read = prepared_structure(question, limits)
    given = dict(question.parameters)
    if question.chain is None:
        given = {**listed_robot(str(question.robot)).chain_values, **given}
    values = parameter_values(read.parameters, read.angle_unit, given)
    with in_chain("chain", question.chain):
        check_values(read.chain, values)
    return PreparedChain(read=read, values=values, angle=read.angle_unit.radians)
