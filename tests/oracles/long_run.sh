#!/bin/bash
# Runs the randomised tests for long, one seed after another, until one fails:
#   tests/oracles/long_run.sh BUILD-FOLDER [SEEDS] [ROUNDS] [GTEST-FILTER]
# A failure prints its seed; the line to run it again is in the test's output. Ten million
# insertions, deletions, undos, redos and trials, in the plane and in space:
#   tests/oracles/long_run.sh BUILD-FOLDER 1 28 'Operations.*'
# 100,000 points in the geodesic cells of each of 14 networks, at 0.1 m and at 1 mm:
#   tests/oracles/long_run.sh BUILD-FOLDER 1 100 '*GeodesicCells.hold*'
set -euo pipefail

build=$1
seeds=${2:-10}
rounds=${3:-20}
filter=${4:-*}
first=$(date +%s)
for ((seed = first; seed < first + seeds; ++seed)); do
  for test in geometry tessellation earth basin rainfall oracles; do
    program=$(find "$build" -name "${test}_test" -type f -perm -u+x | head -n 1)
    if [[ -z $program ]]; then
      printf '%s: not built\n' "$test"
      continue
    fi
    printf '%s: seed %d, %d rounds\n' "$test" "$seed" "$rounds"
    THIESSEN_SEED=$seed THIESSEN_ROUNDS=$rounds "$program" --gtest_brief=1 \
      --gtest_also_run_disabled_tests --gtest_filter="$filter"
  done
done
