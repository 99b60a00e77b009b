#!/bin/bash
# Compares the triangles of cells --delaunay with those of scipy, and a saved session with itself
# Packages: python3-scipy
set -euo pipefail

work=$CLONE/build-ecosystem/scipy
rm -rf "$work"
mkdir -p "$work"
export THIESSEN=$BUILD/cli/thiessen
/usr/bin/python3 -B "$CLONE/tests/ecosystem/scipy_delaunay.py" "$work"
echo "= the triangles and neighbours of 2,000 gauges in a plane, and a session saved and loaded"
