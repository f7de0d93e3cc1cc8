"""One noun a file, in the packages `kinematics`, `checks`, `exercises` and `courses`; beside them the pages.

A page says all of a call: the shapes of its request and its answer, and the function between them. What
several calls share is in `service.schemas` and `service.wire`; requests for the OpenAPI document are in
`service/examples/calls.json`, by path. Each module has a `router`: calls that are functions are declared on a
`service.http.calls.CallRouter`, others on what `service.http.routing.api_router` returns.

The application mounts every module of this package and of those in it, in alphabetical order of the names of
files, as it stands: the paths of an API router already begin with /api/v1, and a page's router says its own.
Nothing is registered elsewhere.

Errors: raise `KinematicsError` or `ServiceError` with faults (inside `service.http.problems.located("table")`
when what is read stands at a place of the body); they become problem documents. No route catches them or
names a status.
"""

import importlib
import pkgutil
from collections.abc import Iterator

from fastapi import APIRouter


def routers() -> Iterator[APIRouter]:
    """Yield the router of every module of this package and of those in it."""
    found = [module for module in pkgutil.walk_packages(__path__, f"{__name__}.") if not module.ispkg]
    for module in sorted(found, key=lambda entry: entry.name.rpartition(".")[2]):
        yield importlib.import_module(module.name).router
