#!/bin/bash
# Runs clang-tidy on the sources of src/ and cli/: tests/lint.sh BUILD-FOLDER
# A file is looked at again when it, a header of ours, its compiler's options or .clang-tidy changed.
set -euo pipefail

clone=$(cd "$(dirname "$0")/.." && pwd)
build=$1
stamps=$build/lint
mkdir -p "$stamps"
cd "$clone"

common=$(find src cli -name '*.h' -print0 | sort -z |
  xargs -0 sha256sum .clang-tidy "$build/CMakeCache.txt" src/CMakeLists.txt cli/CMakeLists.txt \
    CMakeLists.txt | sha256sum)

lint() {
  local file=$1 stamp
  stamp=$stamps/$(printf '%s %s' "$common" "$(sha256sum "$file")" | sha256sum | cut -c 1-32)
  [ -e "$stamp" ] && return
  set -o pipefail
  if clang-tidy --quiet -p "$build" "$file" 2>&1 | sed -E '/^[0-9]+ warnings? generated\.$/d'; then
    touch "$stamp"
  else
    return 1
  fi
}
export -f lint
export build stamps common

# shellcheck disable=SC2016
find src cli -name '*.cpp' -print0 | sort -z |
  xargs -0 -r -n 1 -P "$(nproc)" bash -c 'lint "$1"' lint
