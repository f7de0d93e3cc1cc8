"""The service that generated clients call."""

from tests.service.conftest import base_url

__all__ = ["base_url"]
