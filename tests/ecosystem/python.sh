#!/bin/bash
# Installs the module of Python by pip, runs its tests and its walk-through
# Packages: pybind11-dev python3-pybind11 python3-dev python3-venv python3-pip python3-setuptools python3-wheel python3-pytest python3-numpy python3-pandas python3-shapely python3-matplotlib
set -euo pipefail

work=$CLONE/build-ecosystem/python
mkdir -p "$work"
[ -x "$work/venv/bin/python" ] || /usr/bin/python3 -m venv --system-site-packages "$work/venv"
# What was built is kept, so that the next time takes seconds.
THIESSEN_PYTHON_BUILD=$work/build "$work/venv/bin/python" -m pip install --no-index --no-build-isolation --no-deps \
  --force-reinstall "$CLONE/src/python"
cd "$work"
THIESSEN_PROGRAM=$BUILD/cli/thiessen "$work/venv/bin/python" -B -m pytest -q -p no:cacheprovider "$CLONE/tests/python" |
  tee "$work/said"
"$work/venv/bin/python" -B "$CLONE/samples/python/walkthrough.py" "$work/county.png"
test -s "$work/county.png"
echo "= $(tail -n 1 "$work/said"); the walk-through drew its plot"
