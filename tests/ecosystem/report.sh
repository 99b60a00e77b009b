#!/bin/bash
# Opens report.html in a Chromium without a window, and uses it by mouse, by keyboard and on paper
# Packages: chromium chromium-driver poppler-utils
set -euo pipefail

work=$CLONE/build-ecosystem/report
rm -rf "$work"
mkdir -p "$work"
export THIESSEN=$BUILD/cli/thiessen
/usr/bin/python3 -B "$CLONE/tests/ecosystem/report_page.py" "$CLONE" "$work"
echo "= hover, pan, zoom, slider, sorting, keyboard, printing; names that would be markup are text; an empty console"
