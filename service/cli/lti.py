"""`framewise lti`: platforms, invitations to register, and keys."""

import argparse
import json
import sys
from dataclasses import fields
from urllib.parse import urlsplit

from courses.model import Platform, PlatformStatus
from courses.people.administration import invite_administrator
from courses.people.platforms import (
    add_deployment,
    add_platform,
    deployments_of,
    invite,
    platforms,
    remove_platform,
    set_status,
)
from service.cli.backups import opened_store, record_number
from service.cli.environment import Subparsers, settings_of_environment
from service.course_resources import CourseResources, now
from service.lti.fetching import Fetcher, http_address, origin_of
from service.lti.signing_keys import key_set
from service.messages import sentence

_ADDRESSES = ("authorization_endpoint", "token_endpoint", "jwks_uri")


def add(subparsers: Subparsers) -> None:
    """Declare `lti` with what it does."""
    actions = subparsers.add_parser("lti", help="learning management systems and keys").add_subparsers(
        required=True, metavar="action"
    )
    actions.add_parser("platforms", help="list the platforms").set_defaults(run=_list)
    _declare_add(actions.add_parser("add", help="register a platform, or change one"))
    for status in PlatformStatus:
        verb = {"pending": "suspend", "active": "activate", "disabled": "disable"}[status.value]
        parser = actions.add_parser(verb, help=f"set a platform to {status.value}")
        parser.add_argument("platform", type=record_number)
        parser.set_defaults(run=_set_status, status=status)
    remove = actions.add_parser("remove", help="forget a platform with all its courses")
    remove.add_argument("platform", type=record_number)
    remove.add_argument("--yes", action="store_true", required=True, help="attempts and grades are lost")
    remove.set_defaults(run=_remove)
    deployment = actions.add_parser("deployment", help="allow a deployment of a platform to launch")
    deployment.add_argument("platform", type=record_number)
    deployment.add_argument("deployment", type=_identifier)
    deployment.set_defaults(run=_add_deployment)
    invitation = actions.add_parser("invite", help="print an address for dynamic registration, valid once")
    invitation.add_argument("root", type=_address, help="address of this service as the platform reaches it")
    invitation.add_argument("--note", default="", help="for whom it is")
    invitation.set_defaults(run=_invite)
    administer = actions.add_parser(
        "administer", help="print an address that opens the platforms' page, valid once"
    )
    administer.add_argument("root", type=_address, help="address of this service as your browser reaches it")
    administer.set_defaults(run=_administer)
    keys = actions.add_parser("keys", help="print the public keys")
    keys.set_defaults(run=_keys, rotate=False, at_once=False)
    rotate = actions.add_parser("rotate", help="make a new key; it signs two days after it is published")
    rotate.add_argument("--now", action="store_true", dest="at_once", help="it signs at once")
    rotate.set_defaults(run=_keys, rotate=True)


def _declare_add(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("issuer", type=_address)
    parser.add_argument("client_id", type=_identifier)
    for name in _ADDRESSES:
        parser.add_argument(f"--{name.replace('_', '-')}", type=_address, required=True)
    parser.add_argument(
        "--token-audience", type=_identifier, help="audience of token requests, if not the token endpoint"
    )
    parser.add_argument(
        "--deployment", type=_identifier, action="append", default=[], help="may be given several times"
    )
    parser.add_argument(
        "--origin", type=_origin, action="append", default=[], help="further origin that frames the pages"
    )
    parser.add_argument("--name", default="")
    parser.add_argument("--names-shared", action="store_true", help="store the names that it shares")
    parser.set_defaults(run=_add)


def _address(text: str) -> str:
    try:
        return http_address(text)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"an address is needed, such as https://lms.example.edu/…, not {text!r}"
        ) from None


def _origin(text: str) -> str:
    """Return an origin as browsers write it; a path would never match."""
    try:
        parts = urlsplit(http_address(text))
    except ValueError:
        parts = None
    if parts is None or parts.path not in ("", "/") or parts.query or parts.fragment or "@" in parts.netloc:
        raise argparse.ArgumentTypeError(
            f"an origin is needed, such as https://lms.example.edu, not {text!r}"
        )
    return origin_of(text.strip())


def _identifier(text: str) -> str:
    """Return what the platform calls something."""
    if not text.strip() or not text.isprintable():
        raise argparse.ArgumentTypeError(f"what the platform calls it is needed, not {text!r}")
    return text.strip()


def _add(options: argparse.Namespace) -> None:
    given = {field.name: getattr(options, field.name) for field in fields(Platform) if field.name in options}
    asked = Platform(**given, origins=tuple(options.origin), status=PlatformStatus.ACTIVE)
    with opened_store() as store:
        stored = add_platform(store, asked, tuple(options.deployment), now())
    sys.stdout.write(f"{stored.id}\n")
    fetcher = Fetcher(frozenset(settings_of_environment().lti_trusted_origins))
    for address in filter(fetcher.refuses, stored.called):
        sys.stderr.write(f"{sentence(options.lang, 'platforms-not-fetched', {'address': address})}\n")


def _list(_: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        for platform in platforms(store):
            deployments = ", ".join(deployments_of(store, platform.id))
            row = (str(platform.id), platform.status.value, platform.issuer, platform.client_id, deployments)
            sys.stdout.write("\t".join(row) + "\n")


def _set_status(options: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        set_status(store, options.platform, options.status)


def _remove(options: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        remove_platform(store, options.platform)


def _add_deployment(options: argparse.Namespace) -> None:
    with opened_store(only_if_there=True) as store:
        add_deployment(store, options.platform, options.deployment)


def _invite(options: argparse.Namespace) -> None:
    with opened_store() as store:
        secret = invite(store, options.note, now())
    sys.stdout.write(f"{options.root.rstrip('/')}/lti/register/{secret}\n")


def _administer(options: argparse.Namespace) -> None:
    with opened_store() as store:
        code = invite_administrator(store, now())
    sys.stdout.write(f"{options.root.rstrip('/')}/platforms#code={code}\n")


def _keys(options: argparse.Namespace) -> None:
    courses = CourseResources(settings_of_environment())
    try:
        if options.rotate:
            courses.rotate(at_once=options.at_once)
        sys.stdout.write(json.dumps(key_set(courses.keys()), indent=2) + "\n")
    finally:
        courses.close()
