#!/bin/bash
# Runs the Processing scripts in a QGIS without a window, and compares with the program
# Packages: qgis qgis-providers python3-qgis
set -euo pipefail

work=$CLONE/build-ecosystem/qgis
rm -rf "$work"
mkdir -p "$work/profile" "$work/out"
export THIESSEN=$BUILD/cli/thiessen QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR=$work
/usr/bin/python3 -B "$CLONE/tests/ecosystem/qgis_scripts.py" "$CLONE" "$work"
/usr/bin/python3 -B "$CLONE/tests/ecosystem/qgis_study.py" "$CLONE" "$work"
echo "= study.gpkg opens with its layers, labels and classes, and is drawn in their colours"
echo "= cells, weights and areal rainfall of Colorado's counties, a warning, an error and Cancel"
