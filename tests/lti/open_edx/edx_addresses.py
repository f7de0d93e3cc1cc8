"""Addresses: those of the block, and what a test does there in the place of people."""

import json

from django.http import HttpRequest, HttpResponse, HttpResponseRedirect, JsonResponse
from django.urls import include, path
from django.views.decorators.csrf import csrf_exempt
from lti_consumer.api import get_lti_1p3_content_url, get_lti_1p3_launch_info
from lti_consumer.models import LtiAgsScore, LtiConfiguration
from opaque_keys.edx.keys import UsageKey

from tests.lti.open_edx.edx_course import Course

course = Course()


@csrf_exempt
def add(request: HttpRequest) -> HttpResponse:
    """Put a block into the course; answers with what Studio shows its author."""
    told = json.loads(request.body)
    location = course.add(told["name"], told["fields"])
    block = course.block(location, "author", "instructor")
    shown = get_lti_1p3_launch_info(block.get_lti_1p3_launch_data())
    return JsonResponse({**shown, "block": str(location)})


def opened(request: HttpRequest) -> HttpResponse:
    """Open a block as somebody: the redirect that the frame of the page follows."""
    asked = request.GET
    location = UsageKey.from_string(asked["block"])
    data = course.block(location, asked["user"], asked["role"]).get_lti_1p3_launch_data()
    if asked.get("deep"):
        return HttpResponseRedirect(get_lti_1p3_launch_info(data)["deep_linking_launch_url"])
    return HttpResponseRedirect(get_lti_1p3_content_url(data))


def state(request: HttpRequest) -> HttpResponse:
    """Tell what arrived: scores of the service, marks that the block published, content that was chosen."""
    scores = [
        {"user": score.user_id, "given": score.score_given, "maximum": score.score_maximum,
         "progress": score.grading_progress, "stamp": score.timestamp.timestamp()}
        for score in LtiAgsScore.objects.all()
    ]  # fmt: skip
    items = [
        item.attributes for each in LtiConfiguration.objects.all() for item in each.ltidlcontentitem_set.all()
    ]
    return JsonResponse({"scores": scores, "published": course.published, "chosen": items})


urlpatterns = [
    path("api/", include("lti_consumer.plugin.urls")),
    path("add", add),
    path("opened", opened),
    path("state", state),
]
