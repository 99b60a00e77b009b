#!/bin/bash
# Areal rainfall year by year, in jobs of their own, and the parts joined:
#   areal_jobs.sh STATIONS BASINS RAINFALL FIRST LAST OUTPUT    all years with GNU parallel on this machine
#   areal_jobs.sh part STATIONS BASINS RAINFALL [YEAR]          one year; else the one of Slurm's array job
#   areal_jobs.sh join FIRST LAST OUTPUT                        the parts of these years, one behind the other
# Parts are rain_YEAR.csv in the current folder. OPTIONS, where it is set, holds further options for the program, with
# quotes where a value has blanks in it; with --overwrite among them an OUTPUT that exists is replaced.
set -euo pipefail

program=${THIESSEN:-thiessen}
options=()
words=$(xargs -r printf '%s\n' <<<"${OPTIONS:-}") # which takes quotes off, and nothing else
[ -z "$words" ] || mapfile -t options <<<"$words"

fail() { # STATUS MESSAGE
  printf 'areal_jobs.sh: error: %s\n' "$2" >&2
  exit "$1"
}

usage() {
  sed -n '2,7s/^# //p' "$0" >&2
  exit 2
}

require_years() { # FIRST LAST
  [[ $1 =~ ^[0-9]{4}$ && $2 =~ ^[0-9]{4}$ ]] || fail 2 "years have four digits, as in 1988 1997, not '$1' '$2'"
  [ "$1" -le "$2" ] || fail 2 "the first year, $1, is after the last, $2"
}

require_new() { # OUTPUT
  [ ! -e "$1" ] || [[ " ${options[*]} " == *' --overwrite '* ]] ||
    fail 1 "$1 already exists; --overwrite among OPTIONS replaces it"
}

part() { # STATIONS BASINS RAINFALL YEAR
  rm -f "rain_$4.csv" # a job that fails leaves no older part to be joined
  "$program" rain "$1" "$2" "$3" "${options[@]}" --from "$4" --to "$4" -o "rain_$4.csv" --overwrite --threads 1 -q
}

join() { # FIRST LAST OUTPUT
  local year
  for ((year = $1; year <= $2; ++year)); do
    [ -e "rain_$year.csv" ] || fail 1 "rain_$year.csv is not there: the job of $year has to run, again where it failed"
    cmp -s <(head -n 1 "rain_$1.csv") <(head -n 1 "rain_$year.csv") ||
      fail 1 "rain_$year.csv has other columns than rain_$1.csv"
  done
  made=$3.part
  trap 'rm -f "$made"' EXIT
  cat "rain_$1.csv" >"$made"
  for ((year = $1 + 1; year <= $2; ++year)); do tail -n +2 "rain_$year.csv" >>"$made"; done
  mv -f "$made" "$3"
}

case ${1:-} in
  part)
    [ $# -eq 4 ] || [ $# -eq 5 ] || usage
    part "$2" "$3" "$4" "${5:-${SLURM_ARRAY_TASK_ID:?is set in an array job; else name the year}}"
    ;;
  join)
    [ $# -eq 4 ] || usage
    require_years "$2" "$3"
    require_new "$4"
    join "$2" "$3" "$4"
    ;;
  *)
    [ $# -eq 6 ] || usage
    require_years "$4" "$5"
    require_new "$6"
    # Parallel hands its command to a shell: -q keeps names with blanks and quotes in them whole.
    seq "$4" "$5" | parallel -q --halt now,fail=1 "$0" part "$1" "$2" "$3"
    join "$4" "$5" "$6"
    ;;
esac
