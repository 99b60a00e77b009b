#!/bin/bash
# Installs what is missing, builds thiessen with its tests in <clone>/build-tests, and runs them all:
# layout, lint, the core under sanitizers, every test in a strange locale, every test.
# It may be run again at once, and from any folder. Exit status 0 only where everything passed.
set -euo pipefail

clone=$(cd "$(dirname "$0")/.." && pwd)
build=$clone/build-tests
core=$build/core
started=$SECONDS
failures=()

say() { printf '%s\n' "$*"; }

# check SENTENCE COMMAND...: runs the command, shows its output where it fails, and goes on. A function that
# is called so does not end at its first failure (set -e is off within): it has to return.
check() {
  local sentence=$1 log
  shift
  log=$(mktemp)
  say "$sentence ..."
  if "$@" >"$log" 2>&1; then
    grep -E 'tests passed' "$log" || true
  else
    cat "$log"
    failures+=("$sentence")
  fi
  rm -f "$log"
}

# files PATTERN...: the clone's files of these names; build folders are left out, in a tree without git too.
files() {
  if [ -e "$clone/.git" ]; then
    git -C "$clone" ls-files -z --cached --others --exclude-standard -- "$@"
    return
  fi
  local pattern names=()
  for pattern; do names+=(-o -path "./$pattern"); done
  (cd "$clone" && find . -path './build*' -prune -o -type f '(' "${names[@]:1}" ')' -print0)
}

layout() {
  cd "$clone"
  local wrong
  wrong=$(files '*.cpp' '*.h' | xargs -0 -r clang-format --dry-run -Werror 2>&1 |
    sed -n 's/^\([^ :]*\):[0-9]*:[0-9]*: error.*/\1/p' | sort | uniq -c)
  [ -z "$wrong" ] && return
  printf 'places to mend with clang-format -i, file by file:\n%s\n' "$wrong"
  return 1
}

scripts() {
  cd "$clone"
  files '*.sh' .ci/run | xargs -0 -r shellcheck
}

run_ctest() {
  local folder=$1
  shift
  ctest --test-dir "$folder" --output-on-failure --no-tests=error --timeout 300 \
    --parallel "$(nproc)" "$@"
}

sanitized() {
  TARGETS=core_tests "$clone/samples/build.sh" "$core" -DTHIESSEN_TESTS=ON -DTHIESSEN_WERROR=ON \
    -DTHIESSEN_SANITIZE=address,undefined -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-O1 \
    -DCMAKE_CXX_COMPILER=clang++ || return
  run_ctest "$core" -L core
}

# Turkish has a decimal comma and a letter i of its own; the Chatham Islands are 12:45 from Greenwich.
strange_locale() {
  local locales=$build/locales
  if [ ! -d "$locales/tr_TR.UTF-8" ]; then
    mkdir -p "$locales"
    localedef -i tr_TR -f UTF-8 "$locales/tr_TR.UTF-8" || return
  fi
  LOCPATH=$locales LC_ALL=tr_TR.UTF-8 LANG=tr_TR.UTF-8 TZ=Pacific/Chatham \
    run_ctest "$build" -LE oracles
}

"$clone/samples/packages.sh" build tests

check 'Checking the layout of the C++ files (clang-format)' layout
check 'Checking the scripts (shellcheck)' scripts

say "Building thiessen and its tests in $build (some minutes the first time) ..."
"$clone/samples/build.sh" "$build" -DTHIESSEN_TESTS=ON -DTHIESSEN_WERROR=ON \
  -DCMAKE_BUILD_TYPE=Release

check 'Linting (clang-tidy)' "$clone/tests/lint.sh" "$build"
check 'Testing the core with Clang, AddressSanitizer and UndefinedBehaviorSanitizer' sanitized
check 'Testing in a Turkish locale' strange_locale

# The strange locale sees every test but the oracles; the plain one only those that run the whole program
# (their text is what a locale may change) and the oracles: no test of a room runs twice.
if wants locale; then check 'Testing in a Turkish locale' strange_locale; fi
for part in oracles golden program; do
  check "Testing: $part" run_ctest "$build" -L "^$part\$"
done

say
if [ ${#failures[@]} -gt 0 ]; then
  say "FAILED after $((SECONDS - started)) s:"
  printf '  %s\n' "${failures[@]}"
  exit 1
fi
say "All is well, after $((SECONDS - started)) s."
