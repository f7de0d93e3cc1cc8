"""From one description of a robot to another."""

from service.http.calls import CallRouter
from service.http.routing import OneRobotRoute
from service.schemas.kinematics.conversion import ConvertAnswer, ConvertRequest
from service.settings import Settings
from service.wire.kinematics.conversion import converted

router = CallRouter("kinematics", route_class=OneRobotRoute)


@router.call("/convert", "From one description of a robot to another")
def convert(body: ConvertRequest, settings: Settings) -> ConvertAnswer:
    """Return another description of the same robot, without loss.

    For a DH table of the other convention, base · (new table) · tool equals the old table for every q.
    Entries are moved, not computed, so parameters and spellings stay. For a product of exponentials, every
    parameter needs a value.
    """
    return converted(body, settings)
