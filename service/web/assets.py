"""Files under `static/`: found once, compressed once, named by a version so that browsers keep them."""

import gzip
import hashlib
import mimetypes
import posixpath
import re
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from service.http.negotiation import weighted

SCAN_INTERVAL = 2.0  # Seconds for which a listing of the folder is trusted.

MEDIA_TYPES = {
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
    ".woff2": "font/woff2",
    ".json": "application/json",
}
TEXT = {".js", ".css", ".svg", ".json"}
_NAMES = r"[\w$*{}\s,]+?\sfrom\s+"
IMPORT = re.compile(
    rf"""^(?:import\s+(?:{_NAMES})?|export\s+{_NAMES})["'](\.{{1,2}}/[^"']+)["']""", re.MULTILINE
)
"""A static import, also over several lines; `import(…)` stands inside a line."""
ENCODINGS = {"br": ".br", "gzip": ".gz"}


@dataclass(frozen=True, kw_only=True, slots=True)
class Asset:
    """One representation of one file."""

    body: bytes
    media_type: str
    encoding: str | None
    etag: str


def static_root() -> Path:
    """Return where `static/` stands: inside the package in a wheel, beside it in a checkout."""
    package = Path(__file__).resolve().parent.parent
    packed = package / "static"
    return packed if packed.is_dir() else package.parent / "static"


class Assets:
    """The served files of one folder. Only listed files can be requested, so no path can escape it."""

    def __init__(self, root: Path) -> None:
        self._root = root
        self._files: Mapping[str, tuple[int, int]] = {}
        self._version = ""
        self._scanned = float("-inf")
        self._cached: dict[tuple[str, str], tuple[tuple[int, int], Asset]] = {}
        self._imports: dict[str, tuple[str, ...]] = {}
        self._all_imports: dict[str, tuple[str, ...]] = {}

    @property
    def version(self) -> str:
        """Changes whenever a served file changes; part of every asset's address."""
        self._scan()
        return self._version

    def get(self, name: str, accepted: str) -> Asset | None:
        """Return the file `name` in the smallest encoding that the client accepts; None if there is none.

        Args:
            name: path below the folder, with slashes.
            accepted: the request's Accept-Encoding.
        """
        self._scan()
        stamp = self._files.get(name)
        if stamp is None:
            return None
        encoding = self._encoding(name, accepted)
        kept = self._cached.get((name, encoding))
        if kept is not None and kept[0] == stamp:
            return kept[1]
        asset = self._read(name, encoding)
        self._cached[(name, encoding)] = (stamp, asset)
        return asset

    def imports(self, name: str) -> tuple[str, ...]:
        """Return all that a module imports before it runs, and what that imports, in order of discovery.

        A page names them all at once, so that a browser need not find them one behind the other. What a
        module imports later, by `import()`, is not among them.
        """
        self._scan()
        if name not in self._all_imports:
            self._all_imports[name] = self._found_imports(name)
        return self._all_imports[name]

    def _found_imports(self, name: str) -> tuple[str, ...]:
        found = [name]
        for module in found:
            if module not in self._imports:
                text = (self._root / module).read_text(encoding="utf-8") if module in self._files else ""
                folder = posixpath.dirname(module)
                targets = [posixpath.normpath(posixpath.join(folder, path)) for path in IMPORT.findall(text)]
                self._imports[module] = tuple(targets)
            found += [target for target in self._imports[module] if target not in found]
        return tuple(found[1:])

    def _scan(self) -> None:
        now = time.monotonic()
        if now - self._scanned < SCAN_INTERVAL:
            return
        files = {}
        for path in self._root.rglob("*"):
            if path.is_file() and not path.name.startswith("."):
                status = path.stat()
                files[path.relative_to(self._root).as_posix()] = (status.st_mtime_ns, status.st_size)
        digest = hashlib.sha256(repr(sorted(files.items())).encode())
        if files != self._files:
            self._imports.clear()
            self._all_imports.clear()
        self._files, self._version, self._scanned = files, digest.hexdigest()[:12], now

    def _encoding(self, name: str, accepted: str) -> str:
        wanted = {name for name, quality in weighted(accepted) if quality > 0.0}
        for encoding, suffix in ENCODINGS.items():
            if encoding in wanted and name + suffix in self._files:
                return encoding
        return "gzip" if "gzip" in wanted and Path(name).suffix in TEXT else "identity"

    def _read(self, name: str, encoding: str) -> Asset:
        ready = name + ENCODINGS.get(encoding, "")
        if encoding != "identity" and ready in self._files:
            body = (self._root / ready).read_bytes()
        else:
            body = (self._root / name).read_bytes()
            body = gzip.compress(body, 6, mtime=0) if encoding == "gzip" else body
        suffix = Path(name).suffix
        guessed = MEDIA_TYPES.get(suffix) or mimetypes.guess_type(name)[0] or "application/octet-stream"
        return Asset(
            body=body,
            media_type=guessed,
            encoding=None if encoding == "identity" else encoding,
            etag=f'"{hashlib.sha256(body).hexdigest()[:20]}"',
        )
