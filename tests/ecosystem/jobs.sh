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

refused() { # STATUS WORDS COMMAND...: it ends so, and says so
  local wanted=$1 words=$2 status=0
  shift 2
  "$@" 2>said || status=$?
  if [ "$status" -eq "$wanted" ] && grep -qF -- "$words" said; then return; fi
  echo "$*: $status, $(cat said)"
  exit 1
}

# What is there is not replaced without asking, and no older part is taken for a new one.
refused 1 'joined.csv already exists' "$jobs" join 1988 1997 joined.csv
refused 1 'joined.csv already exists' "$jobs" "${inputs[@]}" 1988 1997 joined.csv
OPTIONS=--overwrite "$jobs" join 1988 1990 joined.csv
[ "$(wc -l <joined.csv)" -eq 37 ]
refused 2 'the first year, 1997, is after the last, 1988' "$jobs" "${inputs[@]}" 1997 1988 reversed.csv
refused 2 'the first year, 1997, is after the last, 1988' "$jobs" join 1997 1988 reversed.csv
refused 2 'years have four digits' "$jobs" join 88 97 reversed.csv
refused 2 'areal_jobs.sh join FIRST LAST OUTPUT' "$jobs" join 1988
refused 2 'areal_jobs.sh join FIRST LAST OUTPUT' "$jobs" part a b
OPTIONS='--method none' refused 2 '--method' "$jobs" part "${inputs[@]}" 1990
refused 1 'rain_1990.csv is not there' "$jobs" join 1988 1997 lacking.csv
OPTIONS='--missing "x' refused 1 'quote' "$jobs" part "${inputs[@]}" 1990
[ ! -e reversed.csv ] && [ ! -e lacking.csv ] && [ ! -e lacking.csv.part ]

# Names of files and values with anything in them are handed on as they are.
mkdir names
cd names
odd="s t's \$(touch PWNED) \"q\" ; &.csv"
cp "${inputs[0]}" "$odd"
OPTIONS="--basins-where \"name = 'Denver'\" --missing x" "$jobs" "$odd" "${inputs[@]:1}" 1996 1997 'r 1.csv'
"$THIESSEN" rain "$odd" "${inputs[@]:1}" --basins-where "name = 'Denver'" --from 1996 --to 1997 -q | cmp - 'r 1.csv'
[ "$(find . -type f | wc -l)" -eq 4 ]
echo '= ten jobs with GNU parallel and as an array of Slurm, four ways of computing: the parts are the whole'
