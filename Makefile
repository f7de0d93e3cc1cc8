# One place for every command: a person and CI call the same targets.
SHELL := /bin/bash
PYTHON ?= python3
PORT ?= 8000
# Four on two processors: those that wait for a page, a delay or a database leave none idle.
PROCESSES ?= 4
ENGINE ?= $(if $(shell command -v docker),docker,podman)
VENV := .venv
PEERS := .venv-peers
DESCRIPTIONS := .venv-descriptions
RUNNERS := .venv-runners
OPENAPI := .venv-openapi-generator
FUZZ := .venv-fuzz
RUNNERS_LOCK := tests/service/adapters/requirements-runners
OPENEDX := .venv-openedx
OPENEDX_LOCK := tests/lti/requirements-openedx
PY := $(VENV)/bin/python
PIP := $(PY) -m pip --disable-pip-version-check install --quiet --require-hashes

export MUED_URL MUED_AUTHORIZATION
# Tests start the service a hundred times: what is compiled is kept, also where an image says otherwise.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: pytest university openapi-generator accessibility lint-python lint-web help sbom licences serve test mued test-clone test-openedx campaign kill-campaign measure-courses exam explore lint descriptions runners bench lock browser proxy clean vendor picture exercise check-exercises

help: ## this list
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## /\t/' | expand -t 14

$(VENV)/bin/python:
	$(PYTHON) -m venv $(VENV)

$(VENV)/.runtime: requirements.lock | $(VENV)/bin/python
	@echo "Installing what the service needs into $(VENV) …"
	$(PIP) -r requirements.lock
	@touch $@

$(VENV)/.dev: requirements-dev.lock | $(VENV)/bin/python
	@echo "Installing what the tests need into $(VENV) …"
	$(PIP) --no-compile -r requirements-dev.lock
	@$(PY) -m compileall -qq -j 0 -x '/tests/' $(VENV)/lib || true # on all processors, without the packages' own tests
	@touch $@ $(VENV)/.runtime

serve: $(VENV)/.runtime vendor ## run the service on http://127.0.0.1:8000 (PORT= changes it)
	$(PY) -m service --port $(PORT)

test: $(VENV)/.dev vendor ## every check and test (PROCESSES= changes how many processes run them)
	$(MAKE) -j 3 pytest lint-python lint-web

pytest: $(VENV)/.dev vendor
	$(PY) -m pytest -n $(PROCESSES) --dist loadfile --no-loadscope-reorder --durations 30

mued: $(VENV)/.dev ## ask a µEd service at MUED_URL= (this checkout, if left out) whether it keeps the standard
	$(PY) -m pytest -n 0 tests/mued

test-clone: $(VENV)/.dev ## clone into a folder with a space in its name, serve and test there, twice (slow)
	TEST_CLONE=1 $(PY) -m pytest tests/architecture/test_clone.py

lint: $(VENV)/.dev vendor ## style, types and import arrows, of Python and of the pages' scripts
	$(MAKE) -j 2 lint-python lint-web

lint-python: $(VENV)/.dev
	$(PY) -m ruff check .
	$(PY) -m ruff format --check .
	$(PY) -m mypy
	$(PY) -c "from importlinter.cli import lint_imports_command as main; main()"

lint-web: $(VENV)/.dev vendor
	$(PY) tools/lint_web.py

accessibility: $(VENV)/.dev vendor ## axe-core on every page at every width in all colours, and every page in all languages (some minutes)
	EVERYTHING=1 $(PY) -m pytest -n 0 tests/web/test_accessibility.py tests/web/test_answer_forms.py tests/web/test_author.py \
	    tests/web/test_environments.py tests/web/test_lesson.py

lock: $(VENV)/.dev ## renew the hash locks from pyproject.toml
	for lock in "requirements.lock" "requirements-telemetry.lock --extra telemetry --constraint requirements.lock" \
	  "requirements-dev.lock --group dev" ; do \
	  $(PY) -m uv pip compile pyproject.toml --universal --generate-hashes --no-header --no-annotate \
	    --python-version 3.11 --quiet -o $$lock ; done
	$(PY) -m uv pip compile --group node --universal --generate-hashes --no-header --no-annotate \
	    --python-version 3.11 --quiet -o requirements-node.lock
	$(PY) -m uv pip compile bench/requirements-peers.txt pyproject.toml --constraint requirements.lock --universal \
	    --generate-hashes --no-header --no-annotate --python-version 3.11 --quiet -o bench/requirements-peers.lock
	$(PY) -m uv pip compile tests/kinematics/urdf/requirements-descriptions.txt --constraint requirements-dev.lock \
	    --universal --generate-hashes --no-header --no-annotate --python-version 3.11 --quiet \
	    -o tests/kinematics/urdf/requirements-descriptions.lock
	$(PY) -m uv pip compile tests/fuzz/requirements-fuzz.txt pyproject.toml --constraint requirements.lock --universal \
	    --generate-hashes --no-header --no-annotate --python-version 3.11 --quiet -o tests/fuzz/requirements-fuzz.lock
	$(PY) -m uv pip compile $(RUNNERS_LOCK).txt pyproject.toml --constraint requirements.lock --universal \
	    --generate-hashes --no-header --no-annotate --python-version 3.11 --quiet -o $(RUNNERS_LOCK).lock
	$(PY) -m uv pip compile tests/clients/requirements-openapi-generator.txt --universal --generate-hashes --no-header \
	    --no-annotate --python-version 3.11 --quiet -o tests/clients/requirements-openapi-generator.lock
	$(PY) -m uv pip compile $(OPENEDX_LOCK).txt --universal --generate-hashes --no-header --no-annotate \
	    --python-version 3.11 --quiet -o $(OPENEDX_LOCK).lock

bench: $(PEERS)/.peers ## measure beside the peers, write docs/performance.md (ONLY="forward jacobian": some)
	OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=1 $(PEERS)/bin/python -m bench $(ONLY)

$(PEERS)/bin/python:
	$(PYTHON) -m venv $(PEERS)

$(PEERS)/.peers: bench/requirements-peers.lock | $(PEERS)/bin/python
	$(PEERS)/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes -r $<
	@touch $@

exercise: $(VENV)/.runtime ## start an exercise: NEW=id and ROBOT=id, TABLE=, AXES= or URDF=file (INTO=folder)
	$(PY) -m service exercises new $(NEW) $(if $(ROBOT),--robot $(ROBOT)) $(if $(TABLE),--table $(TABLE)) \
	    $(if $(AXES),--axes $(AXES)) $(if $(URDF),--urdf $(URDF)) $(if $(INTO),--into $(INTO))

check-exercises: $(VENV)/.runtime ## let exercises test themselves: SEEDS=50 students each (ONLY="puma560 my/folder": some)
	$(PY) -m service exercises check $(ONLY) --seeds $(or $(SEEDS),50)

$(DESCRIPTIONS)/bin/python:
	$(PYTHON) -m venv $(DESCRIPTIONS)

$(DESCRIPTIONS)/.installed: tests/kinematics/urdf/requirements-descriptions.lock | $(DESCRIPTIONS)/bin/python
	$(DESCRIPTIONS)/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes -r $<
	@touch $@

descriptions: $(DESCRIPTIONS)/.installed ## every chain of the published robot descriptions against Pinocchio (a minute)
	$(DESCRIPTIONS)/bin/python -m tests.kinematics.urdf.descriptions $(ARGS)

$(RUNNERS)/bin/python:
	$(PYTHON) -m venv $(RUNNERS)

$(RUNNERS)/.installed: $(RUNNERS_LOCK).lock | $(RUNNERS)/bin/python
	$(RUNNERS)/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes -r $<
	@touch $@

$(OPENAPI)/bin/python:
	$(PYTHON) -m venv $(OPENAPI)

$(OPENAPI)/.installed: tests/clients/requirements-openapi-generator.lock | $(OPENAPI)/bin/python
	$(OPENAPI)/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes -r $<
	@touch $@

openapi-generator: $(VENV)/.dev vendor $(OPENAPI)/.installed ## clients of OpenAPI Generator make every call (needs Java 11; a minute)
	$(PY) -m tests.clients.openapi_generator $(OPENAPI)/bin

runners: $(RUNNERS)/.installed ## nbgrader and Otter themselves run the examples of docs/lms/examples (a minute)
	$(RUNNERS)/bin/python -m tests.service.adapters.published_runners

$(OPENEDX)/bin/python:
	$(PYTHON) -m venv $(OPENEDX)

$(OPENEDX)/.installed: $(OPENEDX_LOCK).lock | $(OPENEDX)/bin/python
	$(OPENEDX)/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes -r $<
	@touch $@

test-openedx: $(VENV)/.dev $(OPENEDX)/.installed ## launches and scores against Open edX's own LTI consumer block (a minute)
	OPEN_EDX_PYTHON=$(OPENEDX)/bin/python $(PY) -m pytest -n 0 tests/lti/test_open_edx.py

campaign: $(VENV)/.dev ## the checker against two million tables, valid and wrong (half an hour; ARGS="--valid 100000": some)
	$(PY) -m tests.kinematics.equivalence $(ARGS)

explore: $(VENV)/.dev vendor ## the property tests with fresh seeds, and long ones in full; what fails becomes an example (ARGS="tests/kinematics": some)
	FRAMEWISE_EXPLORE=1 $(PY) -m pytest -n $(PROCESSES) --dist loadfile --no-loadscope-reorder $(or $(ARGS),tests/kinematics tests/exercises tests/service tests/mued tests/courses/test_policies.py tests/web/test_trainer.py tests/web/test_exercises.py)

campaign-answers: $(VENV)/.dev ## answers to every kind of question, right and wrong, against oracles of their own (an hour; ARGS="--only screws --answers 1000": some)
	$(PY) -m tests.exercises.meaning $(ARGS)

campaign-inverse: $(VENV)/.dev ## inverse kinematics at singularities against brute force (hours; ARGS="--poses 100 --tried 10": some)
	OMP_NUM_THREADS=1 $(PY) -m tests.kinematics.inverse $(ARGS)

.PHONY: students
students: $(VENV)/.dev ## simulated students in every exercise: do hints lead to full marks (a few minutes; ARGS="--only scara": some)
	$(PY) -m tests.exercises.students $(ARGS)

kill-campaign: $(VENV)/.dev ## kill -9 the service 100 times under load and once in a regrading, on SQLite and PostgreSQL, and its worker processes (KILLS=100)
	KILLS=$(or $(KILLS),100) $(PY) -m pytest tests/lti/test_killed.py tests/lti/test_regrading_killed.py tests/service/test_workers.py -k kill --timeout 7200

.PHONY: image
image: ## build the container image (ENGINE=podman), run it without rights, ask it for everything, weigh it
	$(ENGINE) build $(if $(findstring podman,$(ENGINE)),--format docker) --tag framewise $(ARGS) .
	$(PYTHON) tools/image_test.py framewise "$(ENGINE)"

.PHONY: attacks
attacks: $(VENV)/.dev ## an honest client beside 1, 4, 8 clients of each attack (a quarter of an hour; ARGS="--every 10": some)
	$(PY) -m tests.service.attacks.beside $(ARGS)

measure-courses: $(VENV)/.dev ## regrading and statistics of 2 000 students with 20 attempts each
	$(PY) -m tests.lti.measuring
	$(PY) -m tests.lti.storage_price

exam: $(VENV)/.dev ## the start of an exam of STUDENTS=2000, each with values of their own, or VARIANTS=20 prepared before
	$(PY) -m tests.lti.exam --students $(or $(STUDENTS),2000) $(if $(VARIANTS),--variants $(VARIANTS)) $(ARGS)

.PHONY: mixed
mixed: $(VENV)/.dev ## students at 80 % of the ceiling, one request in twenty hostile, for MINUTES=10
	$(PY) -m tests.lti.mixed_load --minutes $(or $(MINUTES),10) $(ARGS)

university: $(VENV)/.dev ## 100 000 students on the evening of a deadline: what saturates first (ARGS="--students 5000")
	$(PY) -m tests.lti.university $(ARGS)

$(FUZZ)/.installed: tests/fuzz/requirements-fuzz.lock
	$(PYTHON) -m venv $(FUZZ)
	$(FUZZ)/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes -r $<
	@touch $@

.PHONY: fuzz
fuzz: $(FUZZ)/.installed ## bytes to every reader, guided by coverage, for MINUTES=10 (ARGS="--only cells urdf": some)
	nice -n 19 $(FUZZ)/bin/python -m tests.fuzz --minutes $(or $(MINUTES),10) $(ARGS)

sbom: $(VENV)/.runtime ## bill of materials of the installation, CycloneDX JSON (INTO=file)
	@$(PY) tools/sbom.py $(INTO)

licences: $(VENV)/.runtime ## every package with its licence
	@$(PY) tools/sbom.py --licences

browser: ## Chromium without a window for the end-to-end tests (Debian; needs root)
	apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq chromium-headless-shell wrk

proxy: ## nginx for the test of the documented reverse proxy (Debian; needs root)
	apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq nginx-light

picture: $(VENV)/.dev vendor ## renew the pictures of the README and of docs/lms from live pages (needs Chromium)
	$(PY) -m tools.picture
	$(PY) -m tools.course_pictures

vendor: static/vendor/.complete

static/vendor/.complete: package.json package-lock.json tools/vendor.py | $(VENV)/.runtime
	$(PY) tools/vendor.py

clean: ## remove everything that make built
	rm -rf $(VENV) $(FUZZ) .venv-peers .venv-descriptions .venv-runners .venv-openedx $(OPENAPI) node_modules static/vendor build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis
