"""Dynamic Registration 1.0: the platform's configuration in, this tool's out, a client id back."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlsplit

import orjson

from courses.model import Platform
from kinematics.errors import Fault
from service.lti import claims as names
from service.lti.fetching import Fetcher, http_address
from service.lti.launch_errors import LoginError, unreachable

_NEEDED = ("issuer", "authorization_endpoint", "token_endpoint", "jwks_uri", "registration_endpoint")


@dataclass(frozen=True, kw_only=True, slots=True)
class ToolRegistration:
    """What platforms are told of this tool; `root` is its address, with a slash at the end."""

    name: str
    description: str
    root: str

    def written(self) -> dict[str, Any]:
        """Return the configuration as the specification writes it. Of people, only `sub` is asked for."""
        scopes = (names.LINE_ITEM_SCOPE, names.RESULT_SCOPE, names.SCORE_SCOPE)
        target = f"{self.root}lti/launch"
        return {
            "application_type": "web",
            "response_types": ["id_token"],
            "grant_types": ["implicit", "client_credentials"],
            "initiate_login_uri": f"{self.root}lti/login",
            "redirect_uris": [target],
            "client_name": self.name,
            "jwks_uri": f"{self.root}lti/jwks",
            "logo_uri": f"{self.root}static/logo/img/mark.svg",
            "token_endpoint_auth_method": "private_key_jwt",
            "scope": " ".join(scopes),
            names.TOOL_CONFIGURATION: {
                "domain": urlsplit(self.root).netloc,
                "description": self.description,
                "target_link_uri": target,
                "claims": ["iss", "sub"],
                "custom_parameters": {names.HISTORY: names.HISTORY_VARIABLE},
                "messages": [
                    {"type": names.RESOURCE_LINK_REQUEST, "target_link_uri": target},
                    {"type": names.DEEP_LINKING_REQUEST, "target_link_uri": target, "label": self.name},
                ],
            },
        }


def register(
    fetcher: Fetcher, configuration: str, token: str | None, tool: ToolRegistration
) -> tuple[Platform, str | None]:
    """Register the tool with a platform; return it, and its deployment if it names one.

    Raises:
        LoginError: the configuration lacks something, or speaks for another host.
        PlatformError: the platform does not answer as it should.
    """
    found, _ = fetcher.get_json(configuration)
    if not isinstance(found, Mapping):
        raise unreachable(configuration, "JSON")
    for name in _NEEDED:
        if not isinstance(found.get(name), str) or not _is_address(found[name]):
            raise _lacks(name)
    if urlsplit(found["issuer"]).hostname != urlsplit(configuration).hostname:
        raise _lacks("issuer")
    headers = {"Content-Type": "application/json"}
    if token:
        headers["Authorization"] = f"Bearer {token}"
    address = found["registration_endpoint"]
    content = orjson.dumps(tool.written())
    given = fetcher.send("POST", address, headers=headers, content=content).succeeded().json()
    client_id = given.get("client_id") if isinstance(given, Mapping) else None
    if not isinstance(client_id, str) or not client_id:
        raise unreachable(address, "client_id")
    own = given.get(names.TOOL_CONFIGURATION)
    deployment = own.get("deployment_id") if isinstance(own, Mapping) else None
    return _platform(found, client_id), str(deployment) if deployment else None


def _platform(found: Mapping[str, Any], client_id: str) -> Platform:
    platform = found.get("https://purl.imsglobal.org/spec/lti-platform-configuration")
    family = platform.get("product_family_code") if isinstance(platform, Mapping) else None
    audience = found.get("authorization_server")
    return Platform(
        issuer=found["issuer"],
        client_id=client_id,
        name=str(family or urlsplit(found["issuer"]).hostname or ""),
        authorization_endpoint=found["authorization_endpoint"],
        token_endpoint=found["token_endpoint"],
        token_audience=audience if isinstance(audience, str) and audience else None,
        jwks_uri=found["jwks_uri"],
    )


def _is_address(text: str) -> bool:
    try:
        return http_address(text) == text
    except ValueError:
        return False


def _lacks(name: str) -> LoginError:
    return LoginError(Fault.at("lti_configuration_invalid", name=name))
