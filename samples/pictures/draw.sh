#!/bin/bash
# Draws the pictures of the page beside this script. usage: samples/pictures/draw.sh [PROGRAM [FOLDER]]
set -euo pipefail
cd "$(dirname "$0")/../.."
thiessen=${1:-build/cli/thiessen}
here=${2:-samples/pictures}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
samples/pictures/networks.py "$work"

# draw NAME ARGUMENTS...: one picture 800 pixels wide.
draw() { local name=$1; shift; "$thiessen" map "$@" --size 800 --overwrite -q -o "$here/$name.jpg"; }
textbook=(samples/textbook/stations.csv samples/textbook/basin.csv)
colorado=(samples/colorado/stations.csv samples/colorado/counties.geojson samples/colorado/rainfall.csv)

for network in one three twenty_five; do
  draw "$network" "$work/$network.csv" "$work/basin.csv" "$work/${network}_rain.csv" --metric planar
done
draw scripts "$work/scripts.csv" "$work/basin.csv" "$work/scripts_rain.csv" --metric planar --label name
draw globe "$work/globe.csv" "$work/earth.csv" "$work/globe_rain.csv" --crs EPSG:4326 --basins-crs EPSG:4326 --tolerance 1000
draw colorado "${colorado[@]}" --time 1997-08
draw county "${colorado[@]}" --basins-where "name = 'Larimer'" --basin-id name --time 1997-08
sed '2s/,.*/,0,0,0,0,0,0,0,0,0/' samples/textbook/rainfall.csv > "$work/dry.csv"
draw dry "${textbook[@]}" "$work/dry.csv" --metric planar
draw multiples "${colorado[@]}" --time 1997-04 --time 1997-05 --time 1997-06 --time 1997-07 --time 1997-08 --time 1997-09
draw isohyets "${textbook[@]}" samples/textbook/rainfall.csv --metric planar --method natural --isohyets --interval 5
draw surface "${colorado[@]}" --time 1997-08 --method natural --isohyets --label none

# A page for a printer: A4 at 300 dots to the inch, of which the page beside shows a smaller copy.
"$thiessen" map "${colorado[@]}" --time 1997-08 --size 297x210mm -q -o "$work/a4.png"
gdal_translate -q -of JPEG -outsize 800 0 -r average "$work/a4.png" "$here/a4.jpg"
rm -f "$here/a4.jpg.aux.xml"
