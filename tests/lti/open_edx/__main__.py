"""Open edX's LTI consumer block on loopback, in a process and an environment of its own: `make test-openedx`.

The block, its launches, keys, tokens and services are the published
`lti-consumer-xblock`, as Open edX runs it. What it asks its platform for (a course, who is signed in, a
gradebook) is answered by `edx_course`: `lti_consumer.plugin.compat` is the package's own seam for that.

    python -m tests.lti.open_edx   prints its address, then serves until its standard input ends
"""

import json
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any
from wsgiref.simple_server import WSGIRequestHandler, WSGIServer, make_server

import django
from django.conf import settings


def configured(root: Path) -> None:
    """Set up Django as far as the block needs it."""
    templates = {
        "BACKEND": "django.template.backends.django.DjangoTemplates",
        "APP_DIRS": True,
        "OPTIONS": {"context_processors": ["django.template.context_processors.request"]},
    }
    settings.configure(
        ALLOWED_HOSTS=["127.0.0.1"],
        CACHES={"default": {"BACKEND": "django.core.cache.backends.locmem.LocMemCache"}},
        DATABASES={"default": {"ENGINE": "django.db.backends.sqlite3", "NAME": str(root / "edx.sqlite")}},
        DEFAULT_AUTO_FIELD="django.db.models.AutoField",
        INSTALLED_APPS=[
            "django.contrib.auth",
            "django.contrib.contenttypes",
            "django.contrib.sessions",
            "rest_framework",
            "waffle",
            "lti_consumer.apps.LTIConsumerApp",
        ],
        DEBUG_PROPAGATE_EXCEPTIONS=True,
        LOGGING={"version": 1, "disable_existing_loggers": True, "root": {"level": "ERROR"}},
        MIDDLEWARE=[
            "edx_django_utils.cache.middleware.RequestCacheMiddleware",
            "django.contrib.sessions.middleware.SessionMiddleware",
            "django.contrib.auth.middleware.AuthenticationMiddleware",
        ],
        PLATFORM_NAME="Open edX",
        ROOT_URLCONF="tests.lti.open_edx.edx_addresses",
        SECRET_KEY="of a process that lives for a test",
        SERVICE_VARIANT="lms",
        TEMPLATES=[templates],
        USAGE_ID_PATTERN=r"(?P<usage_id>(?:i4x://?[^/]+/[^/]+/[^/]+/[^@]+(?:@[^/]+)?)|(?:[^/]+))",
        USE_TZ=True,
    )
    django.setup()


def main() -> None:
    """Serve until standard input ends."""
    with tempfile.TemporaryDirectory() as folder:
        configured(Path(folder))
        from django.core.management import call_command
        from django.core.wsgi import get_wsgi_application

        from tests.lti.open_edx import edx_addresses

        call_command("migrate", verbosity=0)
        edx_addresses.course.joined()
        server = make_server("127.0.0.1", 0, get_wsgi_application(), WSGIServer, Quiet)
        settings.LTI_BASE = settings.LMS_ROOT_URL = f"http://127.0.0.1:{server.server_port}"
        threading.Thread(target=server.serve_forever, daemon=True).start()
        print(json.dumps(settings.LMS_ROOT_URL), flush=True)
        sys.stdin.read()


class Quiet(WSGIRequestHandler):
    """Logs nothing."""

    def log_message(self, *_: Any) -> None: ...


if __name__ == "__main__":
    main()
