"""POST /scm/products: motions multiplied and compared."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Annotated, Any, TypeAlias

from pydantic import Discriminator, Field, Tag, WithJsonSchema

from kinematics.cells import AngleUnit, LengthUnit, Limits, ParameterKind
from kinematics.printing import Format, Notation
from kinematics.scm.product_reading import LARGEST_VARIABLE, RawFactor, ReadProducts, read_products
from kinematics.symbolic import ProofStatus
from service.http.calls import CallRouter
from service.http.problems import moved
from service.http.routing import ApiRequest, BytesResponse, OneRobotRoute
from service.http.validation import CHOICE
from service.schemas.base import LONGEST_LIST, Matrix4, OneOf, Real, Wire
from service.schemas.kinematics.scm import (
    ENTRIES,
    PLACEMENT_SHAPES,
    ListedPlacement,
    PlacementModel,
    SixEntries,
)
from service.schemas.kinematics.written_matrices import SomeParameters, WrittenJacobians, WrittenMatrix
from service.schemas.tables import SHORT_CELL, Units
from service.wire.kinematics.chain_forms import DEFAULT_FORMATS
from service.wire.kinematics.exact_values import exact_values
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.motion_products import ProductsTask, written_products
from service.work.workers import Lane

router = CallRouter("scm", route_class=OneRobotRoute)

MOST_PRODUCTS = 8
MOST_FACTORS = 32  # Products in a request and factors in each; all of them are multiplied in symbols.
_ROW = {"type": "array", "items": SHORT_CELL, "minItems": 4, "maxItems": 4}


_MATRIX, _PLACEMENT = CHOICE + "matrix", CHOICE + "placement"


def _notation_of(value: Any) -> str:
    matrix = isinstance(value, list) and bool(value) and all(isinstance(row, list) for row in value)
    return _MATRIX if matrix else _PLACEMENT


MotionFactor: TypeAlias = Annotated[
    Annotated[Any, Tag(_MATRIX)] | Annotated[SixEntries, Tag(_PLACEMENT)],
    Discriminator(_notation_of),
    WithJsonSchema(
        {
            "description": "a motion: an object with some of x, y, z, a, b, c (one alone is HTX … HRX), "
            "the list [X, Y, Z, A, B, C] of a frame, or a 4×4 matrix of cells with the last row 0, 0, 0, 1",
            "anyOf": [*PLACEMENT_SHAPES, {"type": "array", "items": _ROW, "minItems": 4, "maxItems": 4}],
        }
    ),
]


class ScmProductsRequest(Wire):
    """Products of motions, and what is wanted of them."""

    products: list[Annotated[list[MotionFactor], Field(min_length=1, max_length=MOST_FACTORS)]] = Field(
        min_length=1,
        max_length=MOST_PRODUCTS,
        description="each a list of motions, multiplied from left to right; q1, q2, … and the names in "
        "`variables` are joint variables, other names parameters",
    )
    variables: list[Annotated[str, Field(min_length=1, max_length=64)]] | None = Field(
        None,
        min_length=1,
        max_length=LARGEST_VARIABLE,
        description="names of the joint variables, as in h2j(H, [a1 a2 d3]); q1, q2, … if left out",
    )
    angle_unit: OneOf[AngleUnit] = Field(
        AngleUnit.RAD, description="unit of every angle: motions, joints, parameters and answer"
    )
    length_unit: OneOf[LengthUnit] = Field(
        LengthUnit.M, description="unit of every length: motions, joints, parameters and answer"
    )
    parameters: SomeParameters = Field(default_factory=dict)
    joints: list[Real] | None = Field(
        None,
        max_length=LARGEST_VARIABLE,
        description="values of the joint variables, for the products in numbers (S2D)",
    )
    jacobian: bool = Field(False, description="whether J0 and Jn of every product are wanted (H2J)")
    formats: list[OneOf[Format]] | None = Field(
        None, max_length=LONGEST_LIST, min_length=1, description="text and latex if left out"
    )
    notation: OneOf[Notation] = Field(
        Notation.SHORT, description="short writes c23 (SCZIP), full cos(q2 + q3)"
    )

    def raw(self) -> list[list[RawFactor]]:
        """Return the factors as the cell grammar reads them."""
        return [
            [factor.cells() if isinstance(factor, PlacementModel) else factor for factor in factors]
            for factors in self.products
        ]

    def place(self, where: tuple[str | int, ...]) -> tuple[str | int, ...]:
        """Return the place of an entry in what was sent: by its number where the motion is a list."""
        match where:
            case ("products", int(i), int(k), str(entry)):
                listed = isinstance(self.products[i][k], ListedPlacement)
                return (*where[:-1], ENTRIES.index(entry)) if listed else where
        return where


class ScmProduct(WrittenJacobians):
    """One product."""

    transform: WrittenMatrix = Field(description="the product; motions about and along one axis are added")
    numbers: Matrix4 | None = Field(
        None, description="its values, where every parameter and every joint variable in it has one"
    )
    xyzabc: list[Real] | None = Field(
        None, description="[X, Y, Z, A, B, C] of the values (GEO), if they are those of a rigid motion"
    )


class ScmProductsAnswer(Units):
    """The products, and which of them are equal."""

    variables: list[str] = Field(
        description="names of the joint variables: as given, or q1 … qn up to the last one that occurs"
    )
    parameters: list[str] = Field(description="the parameters that are left")
    products: list[ScmProduct] = Field(description="in the order of the request")
    equal_to_first: list[OneOf[ProofStatus]] = Field(
        description="whether each product is the first one for all values: proved, refuted or undecided"
    )
    symbols: dict[str, str] | None = Field(None, description="what the short names stand for")


@router.call("/scm/products", "Products of motions, compared", answer=ScmProductsAnswer, exclude_none=True)
async def products(body: ScmProductsRequest, request: ApiRequest) -> BytesResponse:
    """Multiply motions and matrices: HRX … HTZ, GEO, SCZIP, S2D and H2J of the toolbox.

    Each product is formed exactly, written, evaluated if everything in it has a value, and
    compared with the first as a function. This shows that translations along an axis and rotations about it
    commute (eq. 2.10 to 2.12), and that other motions do not.
    """
    task = await request.in_turn(partial(_task, body, request.settings.cell_limits))
    return BytesResponse(await request.resources.workers.run(Lane.SLOW, written_products, task))


def _task(body: ScmProductsRequest, limits: Limits) -> ProductsTask:
    """Return what a validated request asks of the workers.

    Raises:
        KinematicsError: motions that cannot be read, values that do not fit; every fault at its place.
    """
    with moved(lambda fault: replace(fault, where=body.place(fault.where))):
        read = read_products(body.raw(), body.angle_unit, body.length_unit, limits, body.variables)
    return ProductsTask(
        read=read,
        values=exact_values(read, body.parameters),
        joints=None if body.joints is None else _joints(body.joints, read),
        jacobian=body.jacobian,
        formats=tuple(dict.fromkeys(body.formats or DEFAULT_FORMATS)),
        notation=body.notation,
    )


def _joints(given: Sequence[float], read: ReadProducts) -> tuple[float, ...]:
    """Joint values in [rad] and length units."""
    units = [
        1.0 if read.joints.get(k) is ParameterKind.LENGTH else read.angle_unit.radians
        for k in range(1, read.n_joints + 1)
    ]
    return tuple(values_in_radians(given, units, "joints"))
