#!/bin/bash
# Installs the module of Python by pip, with an installed thiessen, runs its tests and its walk-through
# Packages: pybind11-dev python3-pybind11 python3-dev python3-venv python3-pip python3-setuptools python3-wheel python3-pytest python3-numpy python3-pandas python3-shapely python3-matplotlib python3-xarray
set -euo pipefail

work=$CLONE/build-ecosystem/python
mkdir -p "$work"
[ -x "$work/venv/bin/python" ] || /usr/bin/python3 -m venv --system-site-packages "$work/venv"

# All that the module is linked with is of this component; what BUILD knows of a user's own installation stays.
rm -rf "$work/prefix"
cmake --install "$BUILD" --prefix "$work/prefix" --component library
# What was built is kept, so that the next time takes seconds.
CMAKE_PREFIX_PATH=$work/prefix THIESSEN_PYTHON_BUILD=$work/module "$work/venv/bin/python" -m pip -v install --no-index \
  --no-build-isolation --no-deps --force-reinstall "$CLONE/src/python" 2>&1 | tee "$work/installed"
grep -F "linked with the thiessen that is installed: $work/prefix/" "$work/installed"

cd "$work"
# All names are looked up at once, so that none that is in no archive waits for its call.
export LD_BIND_NOW=1
THIESSEN_PROGRAM=$BUILD/cli/thiessen "$work/venv/bin/python" -B -m pytest -q -p no:cacheprovider "$CLONE/tests/python" |
  tee "$work/said"
"$work/venv/bin/python" -B "$CLONE/samples/python/walkthrough.py" "$work/county.png"
test -s "$work/county.png"
echo "= $(tail -n 1 "$work/said"); the walk-through drew its plot"
