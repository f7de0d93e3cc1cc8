"""The settings that a command finds in its environment."""

from __future__ import annotations

import os
import sys

from pydantic import ValidationError

from service.settings import Settings


def settings_of_environment() -> Settings:
    """Return the settings of the environment; what cannot be understood ends the program with its name."""
    known = {f"FRAMEWISE_{name.upper()}" for name in Settings.model_fields}
    faults = [
        f"  {name}: there is no such setting"
        for name in sorted(os.environ)
        if name.upper().startswith("FRAMEWISE_") and name.upper() not in known
    ]
    try:
        settings = Settings()
    except ValidationError as error:
        faults += [
            "  " + ": ".join((*(f"FRAMEWISE_{str(step).upper()}" for step in fault["loc"][:1]), fault["msg"]))
            for fault in error.errors()
        ]
    if faults:
        sys.exit("\n".join(("These settings cannot be understood:", *faults)))
    return settings
