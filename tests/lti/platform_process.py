"""A learning management system on loopback, in a process of its own, around `lti1p3platform`.

That library signs and verifies with other code than ours (PyJWT, jwcrypto). What it does not check is
checked here: redirect_uri, response_mode, scope and prompt of a login; audience, age and replay of a client
assertion; scopes of services. The gradebook is as strict as Moodle's: timestamps rise in whole seconds (409).

    python -m tests.lti.platform_process   prints its address, then serves until its standard input ends
"""

import base64
import json
import random
import sys
import threading
import time
from datetime import datetime
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import parse_qs, parse_qsl, urlencode, urlsplit

from jwcrypto.jwk import JWK
from lti1p3platform.ltiplatform import LTI1P3PlatformConfAbstract
from lti1p3platform.message_launch import LTIAdvantageMessageLaunchAbstract
from lti1p3platform.oidc_login import OIDCLoginAbstract
from lti1p3platform.registration import Registration

CLIENT, DEPLOYMENT = "framewise-client", "deployment-1"
AGS = "https://purl.imsglobal.org/spec/lti-ags/scope/"
NRPS = "https://purl.imsglobal.org/spec/lti-nrps/scope/contextmembership.readonly"


class Lms:
    """What the platform knows."""

    def __init__(self, root: str) -> None:
        self.root = root
        key = JWK.generate(kty="RSA", size=2048)
        self.private = key.get_op_key("sign")
        self.public = key.export_to_pem().decode()
        self.lock = threading.Lock()
        self.begin("")

    def begin(self, tool: str) -> None:
        """Know nothing but a tool: what another one sent, of the same people and links, is gone."""
        self.tool = tool
        self.assertions: set[str] = set()
        self.items: dict[str, dict[str, Any]] = {}
        self.scores: list[dict[str, Any]] = []
        self.results: dict[tuple[str, str], dict[str, Any]] = {}
        self.returned: list[dict[str, Any]] = []
        self.registered: list[dict[str, Any]] = []
        self.refused: list[str] = []
        self.faults = 0.0
        self.random = random.Random(1)

    def item(self, resource: str) -> str:
        address = f"{self.root}/lineitems/{resource}/lineitem?type_id=1"
        self.items.setdefault(resource, {"id": address, "resourceId": resource, "scoreMaximum": 10})
        return address


class KnownKey(Registration):
    """Signs with a private key that was read once: OpenSSL sees each time, in 32 ms, whether it is sound."""

    def get_kid(self) -> str:
        """Return the name of the key, which is that of its public half."""
        return str(self.get_jwk(self.get_platform_public_key())["kid"])


class Configuration(LTI1P3PlatformConfAbstract):
    def __init__(self, lms: Lms) -> None:
        self.lms = lms
        super().__init__()
        self.get_registration()

    def init_platform_config(self, **kwargs: Any) -> None: ...

    def get_registration_by_params(self, **kwargs: Any) -> Registration:
        made = KnownKey().set_iss(self.lms.root).set_client_id(CLIENT).set_deployment_id(DEPLOYMENT)
        made.set_platform_public_key(self.lms.public).set_platform_private_key(self.lms.private)
        made.set_oidc_login_url(f"{self.lms.tool}/lti/login").set_launch_url(f"{self.lms.tool}/lti/launch")
        made.set_deeplink_launch_url(f"{self.lms.tool}/lti/launch")
        return made.set_tool_key_set_url(f"{self.lms.tool}/lti/jwks")


class Login(OIDCLoginAbstract):
    def set_lti_message_hint(self, **kwargs: Any) -> None:
        self._lti_message_hint = kwargs["hint"]

    def get_redirect(self, url: str) -> str:
        return url


class LaunchMessage(LTIAdvantageMessageLaunchAbstract):
    def __init__(self, lms: Lms, asked: dict[str, str]) -> None:
        self.lms, self.asked = lms, asked
        super().__init__(None, Configuration(lms))  # type: ignore[arg-type]

    def get_preflight_response(self) -> dict[str, Any]:
        return self.asked

    def prepare_launch(self, preflight_response: dict[str, Any]) -> None:
        hint = json.loads(base64.urlsafe_b64decode(preflight_response["lti_message_hint"]))
        self.set_user_data(preflight_response["login_hint"], hint["roles"], full_name=hint.get("name"))
        self.set_resource_link_claim(hint["resource"], title=hint.get("title", "A link"))
        self.set_launch_context_claim(hint["context"], context_title="Robotics 1")
        self.set_launch_presentation_claim("iframe", f"{self.lms.root}/return")
        self.set_custom_parameters_claim(hint.get("custom", {}))
        items = f"{self.lms.root}/lineitems"
        single = self.lms.item(hint["resource"]) if hint.get("coupled", True) else None
        self.set_ags(items, single)
        self.set_nrps(f"{self.lms.root}/members")
        if hint.get("deep"):
            self.set_dl(f"{self.lms.root}/deep", "title", "text", extra_data={"course": hint["context"]})

    def render_launch_form(self, launch_data: dict[str, Any], **kwargs: Any) -> dict[str, Any]:
        return launch_data


class Refusal(Exception):
    pass


class Handler(BaseHTTPRequestHandler):
    """Routes of the platform."""

    lms: Lms
    protocol_version = "HTTP/1.1"

    def log_message(self, *_: Any) -> None: ...

    def do_GET(self) -> None:
        self._serve("get")

    def do_POST(self) -> None:
        self._serve("post")

    def _serve(self, verb: str) -> None:
        parts = urlsplit(self.path)
        body = self.rfile.read(int(self.headers.get("Content-Length") or 0))
        segments = parts.path.strip("/").split("/")
        query = {name: values[-1] for name, values in parse_qs(parts.query).items()}
        try:
            getattr(self, f"{verb}_{segments[0]}", self._nothing)(segments[1:], query, body)
        except Refusal as error:
            self.lms.refused.append(str(error))
            self._send(400, {"refused": str(error)})

    def _send(self, status: int, content: Any, **headers: str) -> None:
        is_page = isinstance(content, str)
        data = content.encode() if is_page else json.dumps(content).encode()
        self.send_response(status)
        self.send_header("Content-Type", "text/html; charset=utf-8" if is_page else "application/json")
        for name, value in headers.items():
            self.send_header(name.replace("_", "-"), value)
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def _nothing(self, *_: Any) -> None:
        self._send(204, {})

    def post_control(self, _: list[str], query: dict[str, str], body: bytes) -> None:
        told = json.loads(body or b"{}")
        if "tool" in told:
            self.lms.begin(told["tool"])
        self.lms.faults = told.get("faults", self.lms.faults)
        self._send(200, {})

    def get_state(self, *_: Any) -> None:
        lms = self.lms
        results = [{"resource": r, "user": u, **score} for (r, u), score in lms.results.items()]
        shown = {"results": results, "scores": lms.scores, "returned": lms.returned}
        self._send(200, {**shown, "registered": lms.registered, "refused": lms.refused, "items": lms.items})

    def get_start(self, _: list[str], query: dict[str, str], __: bytes) -> None:
        """Begin a launch, as a click on a link does."""
        login = Login(None, Configuration(self.lms))
        login.set_lti_message_hint(hint=query["hint"])
        if "target" in query:
            login.set_launch_url(query["target"])
        address = login.initiate_login(query["user"])
        more = {name: query[name] for name in ("lti_storage_target",) if name in query}
        self._send(302, {}, Location=f"{address}&{urlencode(more)}" if more else address)

    def get_auth(self, _: list[str], query: dict[str, str], __: bytes) -> None:
        wanted = {
            "scope": "openid",
            "response_type": "id_token",
            "response_mode": "form_post",
            "prompt": "none",
        }
        for name, value in {**wanted, "redirect_uri": f"{self.lms.tool}/lti/launch"}.items():
            if query.get(name) != value:
                raise Refusal(f"login: {name}")
        known = {*wanted, "redirect_uri", "client_id", "login_hint", "lti_message_hint", "state", "nonce"}
        if set(query) - known:
            raise Refusal(f"login: {set(query) - known}")
        made = LaunchMessage(self.lms, query).lti_launch()
        if "text/html" not in self.headers.get("Accept", ""):
            self._send(200, made)
            return
        fields = "".join(
            f'<input type="hidden" name="{name}" value="{made[name]}">' for name in ("id_token", "state")
        )
        script = "<script>document.forms[0].submit()</script>"
        form = f'<form method="post" action="{made["launch_url"]}">{fields}</form>{script}'
        self._send(200, f"<!doctype html><body>{form}</body>")

    def get_course(self, _: list[str], query: dict[str, str], __: bytes) -> None:
        """A page of the platform that shows the tool in a frame."""
        source = f"/start?{urlencode(query)}".replace("&", "&amp;")
        self._send(
            200,
            f'<!doctype html><title>LMS</title><iframe src="{source}" width="1200" height="900"></iframe>',
        )

    def get_frame(self, _: list[str], query: dict[str, str], __: bytes) -> None:
        """A page that shows any address in a frame; its title is the last message from there."""
        hear = "addEventListener('message', (event) => { document.title = event.data.subject })"
        source = query["source"].replace("&", "&amp;")
        frame = f'<iframe src="{source}" width="1200" height="900"></iframe>'
        self._send(200, f"<!doctype html><title>LMS</title><script>{hear}</script>{frame}")

    def get_jwks(self, *_: Any) -> None:
        self._send(200, Configuration(self.lms).get_jwks(), Cache_Control="max-age=60")

    def post_token(self, _: list[str], __: dict[str, str], body: bytes) -> None:
        form = dict(parse_qsl(body.decode()))
        configuration = Configuration(self.lms)
        claims = configuration.tool_validate_and_decode(form["client_assertion"])
        if (
            claims["aud"] != f"{self.lms.root}/token"
            or claims["iss"] != claims["sub"]
            or claims["sub"] != CLIENT
        ):
            raise Refusal("assertion: aud, iss or sub")
        if claims["exp"] - claims["iat"] > 300 or abs(claims["iat"] - time.time()) > 60:
            raise Refusal("assertion: age")
        with self.lms.lock:
            if claims["jti"] in self.lms.assertions:
                raise Refusal("assertion: replay")
            self.lms.assertions.add(claims["jti"])
        self._send(200, configuration.get_access_token(form))

    def _authorize(self, scope: str) -> None:
        token = self.headers.get("Authorization", "").removeprefix("Bearer ")
        if not Configuration(self.lms).validate_token(token, [scope]):
            raise Refusal(f"scope: {scope}")

    def get_lineitems(self, segments: list[str], query: dict[str, str], _: bytes) -> None:
        if segments:
            self._authorize(f"{AGS}result.readonly")
            result = self.lms.results.get((segments[0], query.get("user_id", "")))
            told = result and {
                "userId": query["user_id"],
                "resultScore": result["given"],
                "resultMaximum": result["maximum"],
            }
            self._send(200, [told] if told else [])
            return
        self._authorize(f"{AGS}lineitem")
        found = [
            item for item in self.lms.items.values() if query.get("resource_id") in (None, item["resourceId"])
        ]
        self._send(200, found)

    def post_lineitems(self, segments: list[str], _: dict[str, str], body: bytes) -> None:
        told = json.loads(body)
        if not segments:
            self._authorize(f"{AGS}lineitem")
            with self.lms.lock:
                if told["resourceId"] in self.lms.items:
                    raise Refusal("line item: twice")
                self.lms.item(told["resourceId"])
            self._send(201, self.lms.items[told["resourceId"]])
            return
        if segments[1:] != ["lineitem", "scores"]:
            raise Refusal(f"score: {self.path}")
        self._authorize(f"{AGS}score")
        if "application/vnd.ims.lis.v1.score+json" not in self.headers["Content-Type"]:
            raise Refusal("score: media type")
        self._take_score(segments[0], told)

    def _take_score(self, resource: str, told: dict[str, Any]) -> None:
        fault = self.lms.random.random() / self.lms.faults if self.lms.faults else 9.0
        if fault < 0.3:
            self._send(500, {})
            return
        if fault < 0.6:
            self._send(429, {}, Retry_After="1")
            return
        if fault < 0.8:
            self.close_connection = True
            self.connection.close()
            return
        stamp = int(datetime.fromisoformat(told["timestamp"]).timestamp())
        if told["gradingProgress"] != "FullyGraded" or not 0 <= told["scoreGiven"] <= told["scoreMaximum"]:
            raise Refusal("score: body")
        with self.lms.lock:
            known = self.lms.results.get((resource, told["userId"]))
            if known and known["stamp"] >= stamp:
                self._send(409, {})
                return
            result = {"given": told["scoreGiven"], "maximum": told["scoreMaximum"], "stamp": stamp}
            self.lms.results[resource, told["userId"]] = result
            self.lms.scores.append({"resource": resource, "user": told["userId"], **result})
        if fault < 1.0:  # taken, and the tool does not learn of it
            self.close_connection = True
            self.connection.close()
            return
        self._send(200, {})

    def get_members(self, _: list[str], query: dict[str, str], __: bytes) -> None:
        self._authorize(NRPS)
        everybody = [
            {"user_id": "teacher", "roles": ["Instructor"], "name": "T. Eacher"},
            {"user_id": "student", "roles": ["Learner"], "status": "Active"},
            {"user_id": "late", "roles": ["Learner"]},
            {"user_id": "gone", "roles": ["Learner"], "status": "Inactive"},
            {
                "user_id": "tried",
                "roles": ["Learner", "http://purl.imsglobal.org/vocab/lti/system/person#TestUser"],
            },
        ]
        start = int(query.get("from", 0))
        link = (
            {"Link": f'<{self.lms.root}/members?from={start + 2}>; rel="next"'}
            if start + 2 < len(everybody)
            else {}
        )
        self._send(200, {"members": everybody[start : start + 2]}, **link)

    def post_deep(self, _: list[str], __: dict[str, str], body: bytes) -> None:
        form = dict(parse_qsl(body.decode()))
        configuration = Configuration(self.lms)
        items = configuration.validate_deeplinking_resp(form)
        claims = configuration.tool_validate_and_decode(form["JWT"])
        if claims["aud"] != self.lms.root or claims["iss"] != CLIENT:
            raise Refusal("deep link: aud or iss")
        self.lms.returned.append({"items": items, "claims": claims})
        self._send(200, "<!doctype html><title>Chosen</title><p id='done'>done</p>")

    def get_openid(self, *_: Any) -> None:
        root = self.lms.root
        self._send(
            200,
            {
                "issuer": root,
                "authorization_endpoint": f"{root}/auth",
                "token_endpoint": f"{root}/token",
                "jwks_uri": f"{root}/jwks",
                "registration_endpoint": f"{root}/register",
            },
        )

    def post_register(self, _: list[str], __: dict[str, str], body: bytes) -> None:
        if self.headers.get("Authorization") != "Bearer once":
            raise Refusal("registration: token")
        told = json.loads(body)
        self.lms.registered.append(told)
        name = "https://purl.imsglobal.org/spec/lti-tool-configuration"
        self._send(200, {**told, "client_id": CLIENT, name: {**told[name], "deployment_id": DEPLOYMENT}})


def main() -> None:
    """Serve until standard input ends."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    root = f"http://127.0.0.1:{server.server_address[1]}"
    Handler.lms = Lms(root)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    print(root, flush=True)
    sys.stdin.read()


if __name__ == "__main__":
    main()
