#!/bin/bash
# Areal rainfall year by year, in jobs of their own, and the parts joined:
#   areal_jobs.sh STATIONS BASINS RAINFALL FIRST LAST OUTPUT    all years with GNU parallel on this machine
#   areal_jobs.sh part STATIONS BASINS RAINFALL [YEAR]          one year; else the one of Slurm's array job
#   areal_jobs.sh join FIRST LAST OUTPUT                        the parts of these years, one behind the other
# Parts are rain_YEAR.csv in the current folder. OPTIONS, where it is set, holds further options for the program.
set -euo pipefail

program=${THIESSEN:-thiessen}
read -ra options <<<"${OPTIONS:-}"

part() { # STATIONS BASINS RAINFALL YEAR
  "$program" rain "$1" "$2" "$3" "${options[@]}" --from "$4" --to "$4" -o "rain_$4.csv" --overwrite --threads 1 -q
}

join() { # FIRST LAST OUTPUT
  local year made=$3.part
  cat "rain_$1.csv" >"$made"
  for ((year = $1 + 1; year <= $2; ++year)); do
    cmp -s <(head -n 1 "rain_$1.csv") <(head -n 1 "rain_$year.csv") ||
      { echo "rain_$year.csv has other columns than rain_$1.csv" >&2 && exit 1; }
    tail -n +2 "rain_$year.csv" >>"$made"
  done
  mv "$made" "$3"
}

case ${1:-} in
  part)
    shift
    part "$1" "$2" "$3" "${4:-${SLURM_ARRAY_TASK_ID:?is set in an array job; else name the year}}"
    ;;
  join) join "$2" "$3" "$4" ;;
  *)
    [ $# -eq 6 ] || { sed -n '2,6s/^# //p' "$0" >&2 && exit 2; }
    parallel --halt now,fail=1 "$0" part "$1" "$2" "$3" ::: $(seq "$4" "$5")
    join "$4" "$5" "$6"
    ;;
esac
