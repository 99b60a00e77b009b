#!/bin/bash
# Runs the Processing scripts in a QGIS without a window, and compares with the program
# Packages: qgis qgis-providers python3-qgis gdal-bin
set -euo pipefail

work=$CLONE/build-ecosystem/qgis
rm -rf "$work"
mkdir -p "$work/profile" "$work/out"
export THIESSEN=$BUILD/cli/thiessen QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR=$work
/usr/bin/python3 -B "$CLONE/tests/ecosystem/qgis_scripts.py" "$CLONE" "$work"
/usr/bin/python3 -B "$CLONE/tests/ecosystem/qgis_study.py" "$CLONE" "$work"

# As the page says, without a window and without Python of one's own: the scripts lie in a profile.
export QGIS_CUSTOM_CONFIG_PATH=$work/config PYTHONDONTWRITEBYTECODE=1
mkdir -p "$work/config/profiles/default/processing"
ln -s "$CLONE/samples/qgis" "$work/config/profiles/default/processing/scripts"
qgis_process.bin plugins enable processing
cd "$work"
ogr2ogr -oo X_POSSIBLE_NAMES=lon -oo Y_POSSIBLE_NAMES=lat -a_srs EPSG:4326 stations.gpkg "$CLONE/samples/colorado/stations.csv"
ogr2ogr basins.gpkg "$CLONE/samples/colorado/counties.geojson"
command=$(sed -n 's/^ *qgis_process run/qgis_process.bin run/p' "$CLONE/samples/qgis/README.md")
eval "$command"
"$THIESSEN" cells stations.gpkg basins.gpkg -o wanted.gpkg -q
for file in cells wanted; do ogr2ogr -f CSV -lco GEOMETRY=AS_WKT "$file.csv" "$file.gpkg"; done
cmp cells.csv wanted.csv
echo "= study.gpkg opens with its layers, labels and classes, and is drawn in their colours"
echo "= cells, weights and areal rainfall of Colorado's counties, a warning, an error and Cancel, layers of another CRS than their files'"
