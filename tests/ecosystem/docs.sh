#!/bin/bash
# Writes the pages of the library's face by Doxygen, without a warning
# Packages: doxygen
set -euo pipefail

cmake "$BUILD" >/dev/null
cmake --build "$BUILD" --target docs
pages=$BUILD/docs/html
grep -q 'Three ways to link it' "$pages/index.html"
grep -q 'Cost: n log n' "$pages/classthiessen_1_1Thiessen.html"
echo "= $(find "$pages" -name '*.html' | wc -l) pages in $pages"
