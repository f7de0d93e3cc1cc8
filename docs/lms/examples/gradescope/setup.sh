#!/usr/bin/env bash
# Gradescope runs this once, when it builds the image. Put the wheel beside this file: pip wheel --no-deps .
set -euo pipefail
python3 -m venv /autograder/framewise
/autograder/framewise/bin/pip install /autograder/source/framewise-*.whl
