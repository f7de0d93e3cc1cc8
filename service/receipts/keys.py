"""The keys that sign receipts: one signs, all of them verify."""

import json
import os
import time
from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from cryptography.hazmat.primitives.hashes import SHA256
from cryptography.hazmat.primitives.kdf.hkdf import HKDF
from joserfc import jws
from joserfc.errors import JoseError
from joserfc.jwk import OKPKey

from kinematics.errors import Fault
from service.http.api_keys import key_file_unreadable
from service.http.problems import RequestError
from service.secret import installation_secret
from service.settings import Settings

ALGORITHM = "EdDSA"
_PURPOSE = b"framewise receipts, Ed25519, 1"
_SEED_BYTES = 32  # Bytes of an Ed25519 private key (RFC 8032 §5.1.5).


def _registry() -> jws.JWSRegistry:
    """Return a registry of EdDSA alone, under the name that verifiers know (RFC 9864 renames it Ed25519)."""
    algorithm = copy(jws.JWSRegistry.algorithms[ALGORITHM])
    algorithm.security_warning = None
    registry = jws.JWSRegistry(algorithms=[ALGORITHM])
    registry.algorithms = {ALGORITHM: algorithm}
    return registry


REGISTRY = _registry()


@dataclass(frozen=True, kw_only=True, slots=True)
class ReceiptKeys:
    """Ed25519 keys, the signing one first."""

    keys: tuple[OKPKey, ...]

    @property
    def signing(self) -> OKPKey:
        """The key that signs."""
        return self.keys[0]

    def find(self, kid: object) -> OKPKey | None:
        """Return the key of a `kid`, or None."""
        return next((key for key in self.keys if key.kid == kid), None)

    def sign(self, content: bytes) -> str:
        """Return a detached JWS of some bytes (RFC 7515, appendix F)."""
        header = {"alg": ALGORITHM, "kid": self.signing.kid}
        signed = jws.serialize_compact(header, content, self.signing, registry=REGISTRY)
        head, _, signature = signed.split(".")
        return f"{head}..{signature}"

    def public(self) -> dict[str, Any]:
        """Return the public keys as a JWK Set (RFC 7517)."""
        return {"keys": [key.as_dict(private=False) for key in self.keys]}


def receipt_keys(settings: Settings) -> ReceiptKeys:
    """Return the keys of an installation: of its file, or of its secret, or made for this process alone."""
    if settings.receipt_keys is not None:
        return read_keys(settings.receipt_keys)
    return keys_of_secret(installation_secret(settings))


def keys_of_secret(secret: bytes) -> ReceiptKeys:
    """Derive the signing key from the installation's secret (HKDF-SHA256, RFC 5869).

    Every process and replica with the same secret signs and verifies alike, and nothing has to be stored.
    """
    seed = HKDF(algorithm=SHA256(), length=_SEED_BYTES, salt=None, info=_PURPOSE).derive(secret)
    return ReceiptKeys(keys=(_key(Ed25519PrivateKey.from_private_bytes(seed)),))


def read_keys(path: Path) -> ReceiptKeys:
    """Read the keys of a file that `rotate` wrote.

    Raises:
        UnavailableError: the file is no JWK Set of Ed25519 private keys.
    """
    try:
        entries = json.loads(path.read_text(encoding="utf-8"))["keys"]
        keys = tuple(OKPKey.import_key(entry) for entry in entries)
    except (ValueError, TypeError, KeyError, JoseError) as error:
        raise key_file_unreadable(path, error) from error
    if not keys or not all(key.is_private and key.as_dict().get("crv") == "Ed25519" for key in keys):
        raise key_file_unreadable(path, ValueError("Ed25519, private"))
    return ReceiptKeys(keys=keys)


def rotate(path: Path, retire: Sequence[str] = ()) -> ReceiptKeys:
    """Put a new signing key in front; the old ones go on verifying what they signed.

    Args:
        path: the file; it is made if it is missing, readable by its owner alone.
        retire: kids whose receipts are to be refused from now on.

    Raises:
        RequestError: the file holds no key of such a kid; it stays as it is.
        UnavailableError: the file cannot be understood.
    """
    old = read_keys(path).keys if path.exists() else ()
    if unknown := [kid for kid in retire if kid not in {key.kid for key in old}]:
        raise RequestError(Fault.at("receipt_kid_unknown", id=unknown[0], file=path.name))
    keys = (_key(Ed25519PrivateKey.generate()), *(key for key in old if key.kid not in retire))
    document = {"keys": [key.as_dict(private=True) for key in keys]}
    draft = path.with_name(f"{path.name}.{os.getpid()}.{time.monotonic_ns()}")
    try:
        descriptor = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    except OSError as error:
        error.filename = str(path)  # the name that somebody typed
        raise
    with os.fdopen(descriptor, "w", encoding="utf-8") as file:
        json.dump(document, file, indent=2)
    draft.replace(path)
    return ReceiptKeys(keys=keys)


def _key(private: Ed25519PrivateKey) -> OKPKey:
    key = OKPKey.import_key(private, {"use": "sig", "alg": ALGORITHM})
    key.ensure_kid()
    return key
