#!/bin/bash
# Splits an archive by years into jobs; the parts joined are the whole, byte for byte
# Packages: parallel
set -euo pipefail

work=$CLONE/build-ecosystem/jobs
rm -rf "$work"
mkdir -p "$work"
cd "$work"
export THIESSEN=$BUILD/cli/thiessen
jobs=$CLONE/samples/jobs/areal_jobs.sh
inputs=("$CLONE/samples/colorado/stations.csv" "$CLONE/samples/colorado/counties.geojson" "$CLONE/samples/colorado/rainfall.csv")

for options in '--gaps retessellate' '--gaps strict --min-gauges 2' '--error --long' '--every year'; do
  # shellcheck disable=SC2086
  "$THIESSEN" rain "${inputs[@]}" $options -o whole.csv --overwrite -q
  OPTIONS=$options "$jobs" "${inputs[@]}" 1988 1997 joined.csv
  cmp whole.csv joined.csv
  rm rain_*.csv joined.csv
done

# As Slurm runs them, a year a task; one that has run already may be run again.
"$THIESSEN" rain "${inputs[@]}" -o whole.csv --overwrite -q
for year in $(seq 1988 1997) 1990; do SLURM_ARRAY_TASK_ID=$year "$jobs" part "${inputs[@]}"; done
"$jobs" join 1988 1997 joined.csv
cmp whole.csv joined.csv
echo '= ten jobs with GNU parallel and as an array of Slurm, four ways of computing: the parts are the whole'
