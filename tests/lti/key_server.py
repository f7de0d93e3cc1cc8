"""A key set on loopback whose private key the test holds."""

from __future__ import annotations

import json
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from types import TracebackType

from jwcrypto.jwk import JWK


class KeyServer:
    """Serves one public key at /jwks and counts who asks."""

    def __init__(self) -> None:
        key = JWK.generate(kty="RSA", size=2048, kid="key-1", use="sig", alg="RS256")
        self.kid = "key-1"
        self.private = key.get_op_key("sign")  # read once: to read it takes a hundred times what signing does
        self.public = key.export_to_pem().decode()
        self.fetched = self.visited_elsewhere = 0
        document = json.dumps({"keys": [json.loads(key.export_public())]}).encode()
        outer = self

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                if self.path == "/jwks":
                    outer.fetched += 1
                else:
                    outer.visited_elsewhere += 1
                self.send_response(200)
                self.send_header("Content-Length", str(len(document)))
                self.end_headers()
                self.wfile.write(document)

            def log_message(self, *_: object) -> None: ...

        self._server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.root = f"http://127.0.0.1:{self._server.server_address[1]}"

    def __enter__(self) -> KeyServer:
        """Begin to serve."""
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End."""
        self._server.shutdown()
        self._server.server_close()
