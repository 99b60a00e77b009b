#!/bin/sh
# From a clone to areal rainfall: installs what is missing, builds thiessen, and runs it on ten years
# of rainfall in Colorado. It may be run again at once, and from any folder.
set -eu

clone=$(cd "$(dirname "$0")/.." && pwd)
program=$clone/build/cli/thiessen
sample=$clone/samples/colorado
results=$clone/results/colorado

say() { printf '%s\n' "$*"; }

say '1. The packages that thiessen is built from'
"$clone/samples/packages.sh" build

say
say "2. Building thiessen in $clone/build (a few minutes the first time) ..."
"$clone/samples/build.sh" "$clone/build" -DCMAKE_BUILD_TYPE=Release
say "The program is $program"

say
say '3. 376 rain gauges, 64 counties of Colorado, 120 months:'
say "   thiessen run stations.csv counties.geojson rainfall.csv --basin-id name -o $results"
say
mkdir -p "$results"
"$program" run "$sample/stations.csv" "$sample/counties.geojson" "$sample/rainfall.csv" \
  --basin-id name --title 'Colorado, monthly rainfall 1988-1997' -o "$results" --overwrite

say
say "The results are in $results:"
say '   rain.csv        the rainfall of every county, month by month, in millimetres'
say '   weights.csv     the share of each gauge in each county'
say '   summary.csv     the table above, with all digits'
say '   study.gpkg      all of it, as QGIS opens it in colour'
say '   cells.geojson   the Thiessen cells, for whatever reads GeoJSON'
say '   report.html     all of it as a page for a browser'
say '   map.png         a picture of them'
say '   study.toml      what was asked; --config takes it'
say 'Where the figures come from: samples/colorado/README.md'
say "Every command has its own help, with an example that runs: $program --help"
