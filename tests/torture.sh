#!/bin/bash
# Bad, hostile and degenerate input and failing machines, row by row, from outside: one line a row, "holds", "FAILS" with
# what was seen, or "not tried" with what this machine lacks. Exit status 1 where a row fails.
#   tests/torture.sh [--program build/cli/thiessen] [--shim build/tests/libthiessen_faults.so] [--long] [ROW...]
# --long has the forms that take hours; a ROW is T028, or T020-T030.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
exec python3 -B "$here/torture/torture.py" "$@"
