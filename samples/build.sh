#!/bin/bash
# Configures and builds the project: samples/build.sh FOLDER [option of cmake ...]
# TARGETS, where it is set, names what to build; else all is built.
set -euo pipefail

source=$(cd "$(dirname "$0")/.." && pwd)
folder=$1
shift

# A compiler may take 1.5 GB over a file that includes OpenCV or CGAL.
memory=$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo 2>/dev/null || true)
jobs=$(nproc 2>/dev/null || echo 1)
[ "${memory:-1}" -ge "$jobs" ] || jobs=${memory:-1}
[ "$jobs" -ge 1 ] || jobs=1

# Tests are many small files: Ninja, where it is installed, wastes no time between them. Else CMake chooses.
generator=
if command -v ninja >/dev/null && [[ " $* " == *' -DTHIESSEN_TESTS=ON '* ]]; then generator=Ninja; fi

# The folder remembers where and with which generator it was made: begin afresh where the clone has moved
# since, or the generator is another.
fresh=
cache=$folder/CMakeCache.txt
if [ -f "$cache" ] &&
  { ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$source" "$cache" ||
    { [ -n "$generator" ] && ! grep -qxF "CMAKE_GENERATOR:INTERNAL=$generator" "$cache"; } ||
    { ! command -v ninja >/dev/null && grep -qxF 'CMAKE_GENERATOR:INTERNAL=Ninja' "$cache"; }; }; then
  fresh=--fresh
fi
mkdir -p "$folder"
log=$folder/build.log
# A terminal sees the build go on; a pipe gets silence, or the reason of a failure.
show() { if [ -t 1 ]; then tee "$log" | grep --line-buffered '^\[' || true; else cat >"$log"; fi; }
# shellcheck disable=SC2086
build() {
  cmake $fresh ${generator:+-G "$generator"} -S "$source" -B "$folder" "$@" &&
    cmake --build "$folder" --parallel "$jobs" ${TARGETS:+--target $TARGETS}
}
if ! build "$@" 2>&1 | show; then
  grep -nE -A 6 'error|Error|warning:' "$log" | head -n 60 >&2 || true
  tail -n 15 "$log" >&2
  printf 'build.sh: error: the build failed; all of its output is in %s\n' "$log" >&2
  exit 1
fi
