#!/bin/bash
# Uses thiessen for real from where people work: installs what that needs (Debian's packages) and runs each part.
#   tests/ecosystem/run.sh [PART...]     only these parts; --help lists them
# A part is a file beside this one. Its second line says what it does, a line "# Packages:" what it needs; it is run
# with CLONE, the clone, and BUILD, a folder in which program and library are built; it ends with 0 where all is well.
# What parts keep for the next time they keep in build-ecosystem/.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
CLONE=$(cd "$here/../.." && pwd)
BUILD=$CLONE/build-tests
export CLONE BUILD
started=$SECONDS

say() { printf '%s\n' "$*"; }

parts=()
for file in "$here"/*.sh; do
  name=$(basename "$file" .sh)
  [ "$name" = run ] || parts+=("$name")
done
chosen=("$@")
[ $# -gt 0 ] || chosen=("${parts[@]}")
for part in "${chosen[@]}"; do
  case $part in
    -h | --help)
      say 'tests/ecosystem/run.sh [PART...]: all parts, or those that are named:'
      for name in "${parts[@]}"; do printf '  %-14s%s\n' "$name" "$(sed -n '2s/^# //p' "$here/$name.sh")"; done
      exit
      ;;
  esac
  if [[ " ${parts[*]} " != *" $part "* ]]; then
    printf "run.sh: error: there is no part '%s'\nhint: the parts are: %s\n" "$part" "${parts[*]}" >&2
    exit 2
  fi
done

wanted=()
for part in "${chosen[@]}"; do
  read -ra names <<<"$(sed -n 's/^# Packages: *//p' "$here/$part.sh")"
  wanted+=("${names[@]}")
done
"$CLONE/samples/packages.sh" build tests named "${wanted[@]}"

# As tests/run.sh builds them, so that neither undoes what the other did. What is packaged is built here, and
# needs no test: so installing does not build all that there is first.
say "Building program and library in $BUILD ..."
TARGETS='thiessen thiessen_library thiessen_program thiessen_pages thiessen_debian' "$CLONE/samples/build.sh" "$BUILD" \
  -DTHIESSEN_TESTS=ON -DTHIESSEN_WERROR=ON -DTHIESSEN_QUICK_TESTS=ON -DTHIESSEN_JOINED=ON -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_SKIP_INSTALL_ALL_DEPENDENCY=ON

failures=()
for part in "${chosen[@]}"; do
  from=$SECONDS
  say "$part: $(sed -n '2s/^# //p' "$here/$part.sh") ..."
  log=$(mktemp)
  if "$here/$part.sh" >"$log" 2>&1; then
    sed -n 's/^= /  /p' "$log" # what a part tells begins so
  else
    cat "$log"
    failures+=("$part")
  fi
  rm -f "$log"
  say "  $part: $((SECONDS - from)) s"
done

say
if [ ${#failures[@]} -gt 0 ]; then
  say "FAILED after $((SECONDS - started)) s: ${failures[*]}"
  exit 1
fi
say "All is well, after $((SECONDS - started)) s."
