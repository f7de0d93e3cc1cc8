"""SCM chains: SCM2DH of the toolbox."""

from __future__ import annotations

from kinematics.cells import ReadTable, parameter_values
from kinematics.scm import modified_dh_from_scm, read_chain
from service.schemas.conversion import ConvertRequest
from service.settings import Settings
from service.wire.conversion.described import RobotDescription
from service.wire.prepared_chains import in_chain


def described_chain(request: ConvertRequest, settings: Settings) -> RobotDescription:
    """The robot of an SCM chain, as the modified DH table that is exactly the chain for every q.

    Raises:
        DescriptionError: the chain cannot be read, or does not pass the document's input check.
        ParameterError: the parameters that were given do not fit.
    """
    assert request.scm is not None
    with in_chain("scm", request.scm):
        chain = read_chain(request.scm.raw(), settings.cell_limits)
        table = modified_dh_from_scm(chain.chain)
    if request.parameters is not None:
        parameter_values(chain.parameters, chain.angle_unit, request.parameters)
    read = ReadTable(
        table=table,
        angle_unit=chain.angle_unit,
        length_unit=chain.length_unit,
        parameters=chain.parameters,
    )
    return RobotDescription(read=read, parameters=request.parameters)
