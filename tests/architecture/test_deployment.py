"""What is deployed: manifests that Kubernetes' schemas take, and a compose file whose parts fit together."""

import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import kubernetes_validate
import pytest
import yaml

from service.settings import Settings
from tests.architecture.sources import ROOT

FOLDER = ROOT / "deploy" / "kubernetes"
VERSIONS = ("1.30", "1.33")
COMPOSE = yaml.safe_load((ROOT / "compose.yaml").read_text(encoding="utf-8"))


def manifests() -> list[dict[str, Any]]:
    kustomization = yaml.safe_load((FOLDER / "kustomization.yaml").read_text(encoding="utf-8"))
    texts = [(FOLDER / name).read_text(encoding="utf-8") for name in kustomization["resources"]]
    return [found for text in texts for found in yaml.safe_load_all(text)]


MANIFESTS = manifests()
NAMES = [f"{found['kind']}-{found['metadata']['name']}" for found in MANIFESTS]


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("manifest", MANIFESTS, ids=NAMES)
def test_kubernetes_takes_every_manifest(manifest: dict[str, Any], version: str) -> None:
    kubernetes_validate.validate(manifest, version, strict=True)


def test_the_validator_refuses_what_is_wrong() -> None:
    wrong = {**MANIFESTS[0], "surplus": 1}
    with pytest.raises(kubernetes_validate.ValidationError):
        kubernetes_validate.validate(wrong, VERSIONS[0], strict=True)


def pods(value: Any) -> list[dict[str, Any]]:
    """Every pod's specification."""
    if isinstance(value, dict):
        own = [value] if "containers" in value else []
        return own + [pod for entry in value.values() for pod in pods(entry)]
    return [pod for entry in value for pod in pods(entry)] if isinstance(value, list) else []


def test_every_kind_is_there_once_for_its_purpose() -> None:
    assert len(NAMES) == len(set(NAMES))
    assert {"Deployment", "HorizontalPodAutoscaler", "PodDisruptionBudget", "Job", "CronJob", "Service"} <= {
        found["kind"] for found in MANIFESTS
    }


def test_no_container_has_more_rights_than_it_needs() -> None:
    for pod in pods(MANIFESTS):
        assert pod["securityContext"]["runAsNonRoot"] is True
        for container in pod["containers"]:
            context = container["securityContext"]
            assert context["readOnlyRootFilesystem"] is True
            assert context["allowPrivilegeEscalation"] is False
            assert context["capabilities"] == {"drop": ["ALL"]}
            assert container["resources"]["limits"]["memory"]


def test_no_pod_is_given_variables_that_are_no_settings() -> None:
    """Of a Service named framewise, Kubernetes makes FRAMEWISE_PORT=tcp://…, with which nothing starts."""
    assert len(pods(MANIFESTS)) == 5
    assert all(pod["enableServiceLinks"] is False for pod in pods(MANIFESTS))


def test_the_outermost_proxy_says_itself_where_a_request_comes_from() -> None:
    """With what a client sends kept in front, each could have as many addresses as it likes."""
    block = (ROOT / "deploy" / "compose" / "nginx.conf").read_text(encoding="utf-8")
    assert re.findall(r"X-Forwarded-(For|Prefix) ([^;]*);", block) == [
        ("For", "$remote_addr"),
        ("Prefix", '""'),
    ]


def test_the_image_is_named_in_one_place() -> None:
    kustomization = yaml.safe_load((FOLDER / "kustomization.yaml").read_text(encoding="utf-8"))
    (ours,) = kustomization["images"]
    assert ours["newTag"]
    images = [container["image"] for pod in pods(MANIFESTS) for container in pod["containers"]]
    assert sum(image.partition(":")[0] == ours["name"] for image in images) == 3


def test_a_job_of_an_older_version_stands_in_nobodys_way_for_long() -> None:
    """Kubernetes refuses to change one: the manifests of a new version could not be applied for a day."""
    (job,) = (found for found in MANIFESTS if found["kind"] == "Job")
    assert job["spec"]["ttlSecondsAfterFinished"] <= 600
    told = (ROOT / "docs" / "operations.md").read_text(encoding="utf-8")
    assert f"kubectl delete job {job['metadata']['name']} --ignore-not-found" in told


def test_labels_select_the_pods_that_they_mean() -> None:
    by_kind = {found["kind"]: found for found in MANIFESTS if found["metadata"]["name"] == "framewise"}
    labels = by_kind["Deployment"]["spec"]["template"]["metadata"]["labels"]
    for selector in (
        by_kind["Deployment"]["spec"]["selector"]["matchLabels"],
        by_kind["PodDisruptionBudget"]["spec"]["selector"]["matchLabels"],
        by_kind["Service"]["spec"]["selector"],
    ):
        assert selector == labels
    for found in MANIFESTS:
        if found["kind"] in ("Job", "CronJob"):
            own = [
                each["metadata"]["labels"]
                for each in templates(found["spec"])
                if "labels" in each["metadata"]
            ]
            assert labels not in own


def templates(value: Any) -> list[dict[str, Any]]:
    if not isinstance(value, dict):
        return []
    own = [value] if "metadata" in value and "spec" in value else []
    return own + [found for entry in value.values() for found in templates(entry)]


def test_every_setting_that_is_named_exists() -> None:
    known = {f"FRAMEWISE_{name.upper()}" for name in Settings.model_fields}
    texts = [path.read_text(encoding="utf-8") for path in (*FOLDER.glob("*.yaml"), ROOT / "compose.yaml")]
    named = set(re.findall(r"FRAMEWISE_[A-Z_]+", " ".join(texts)))
    assert named
    assert named <= known


def test_the_compose_file_fits_together() -> None:
    services = COMPOSE["services"]
    alone = [name for name, service in services.items() if "profiles" not in service]
    assert alone == ["framewise"]
    for name, service in services.items():
        assert set(service.get("networks", ())) <= set(COMPOSE["networks"]), name
        assert set(service.get("depends_on", ())) <= set(services), name
        for volume in service.get("volumes", ()):
            source = volume.split(":")[0]
            assert source in COMPOSE["volumes"] or (ROOT / source).exists(), volume
    ours = [service for service in services.values() if service.get("image") == "framewise"]
    assert len(ours) == 4
    assert all(service["read_only"] and service["cap_drop"] == ["ALL"] for service in ours)
    assert services["replica-1"] == services["replica-2"]


def test_the_settings_of_an_operator_reach_the_container() -> None:
    """What stood in the environment and in .env did not, and no page said where else to write it."""
    services = COMPOSE["services"]
    alone = services["framewise"]["environment"]
    assert alone["FRAMEWISE_SECRET"] is None  # passed on if it is set; without one the service starts, too
    page = (ROOT / "docs" / "operations.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"^```yaml compose\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    override = yaml.safe_load(example)["services"]
    assert set(override) <= set(services)
    named = override["framewise"]["environment"]
    settings = {name.removeprefix("FRAMEWISE_").lower(): value for name, value in named.items()}
    assert set(settings) <= set(Settings.model_fields)
    Settings.model_validate(settings)
    mounted = [volume.split(":")[1] for volume in override["framewise"]["volumes"]]
    assert mounted == [named["FRAMEWISE_EXERCISE_FOLDERS"]]


def test_the_proxy_of_the_compose_file_is_one_that_nginx_takes(tmp_path: Path) -> None:
    nginx = shutil.which("nginx") or "/usr/sbin/nginx"
    if not Path(nginx).exists():
        pytest.skip("needs nginx (make proxy)")
    block = (ROOT / "deploy" / "compose" / "nginx.conf").read_text(encoding="utf-8")
    for name in re.findall(r"server (replica-\d):8000", block):
        assert name in COMPOSE["services"]
        block = block.replace(f"{name}:8000", "127.0.0.1:9")
    whole = tmp_path / "nginx.conf"
    # Where Debian's nginx logs by default only root may write.
    ours = f"pid {tmp_path}/pid; error_log stderr;\nevents {{}}\n"
    whole.write_text(f"{ours}http {{\naccess_log off;\n{block}\n}}\n")
    checked = subprocess.run(
        [nginx, "-t", "-q", "-c", whole, "-p", tmp_path], capture_output=True, text=True, check=False
    )
    assert checked.returncode == 0, checked.stderr
