#!/bin/bash
# Installs what is missing, builds thiessen with its tests in <clone>/build-tests, and runs them all:
# layout, lint, the core under sanitizers, every test in a strange locale, every test.
# It may be run again at once, and from any folder. Exit status 0 only where everything passed.
#   tests/run.sh [PART...]     only these parts, in the order below; tests/run.sh --help lists them
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
    grep -E 'tests passed|sources looked at' "$log" || true
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

help() {
  cat <<'END'
tests/run.sh [PART...]: all parts, or those that are named:
  layout      the layout of the C++ files (clang-format)
  scripts     the shell scripts (shellcheck)
  build       the program and its tests
  lint        clang-tidy over src/ and cli/
  sanitized   the core with Clang, AddressSanitizer and UndefinedBehaviorSanitizer
  locale      every test but the oracles, in a Turkish locale
  oracles     comparisons with CGAL, GEOS and GeographicLib
  golden      whole runs of the program against golden files
  program     whole runs of the program against exact arithmetic
What needs the build brings it up to date first.
END
}

parts=(layout scripts build lint sanitized locale oracles golden program)
for part; do
  case $part in
    -h | --help) help && exit ;;
  esac
  if [[ " ${parts[*]} " != *" $part "* ]]; then
    printf "run.sh: error: there is no part '%s'\nhint: the parts are: %s\n" "$part" "${parts[*]}" >&2
    exit 2
  fi
done
chosen=" ${*:-${parts[*]}} "
wants() {
  local part
  for part; do [[ $chosen != *" $part "* ]] || return 0; done
  return 1
}

"$clone/samples/packages.sh" build tests

if wants layout; then check 'Checking the layout of the C++ files (clang-format)' layout; fi
if wants scripts; then check 'Checking the scripts (shellcheck)' scripts; fi

if wants build lint locale oracles golden program; then
  say "Building thiessen and its tests in $build (some minutes the first time) ..."
  "$clone/samples/build.sh" "$build" -DTHIESSEN_TESTS=ON -DTHIESSEN_WERROR=ON \
    -DCMAKE_BUILD_TYPE=Release
fi

if wants lint; then check 'Linting (clang-tidy)' "$clone/tests/lint.py" "$build"; fi
if wants sanitized; then
  check 'Testing the core with Clang, AddressSanitizer and UndefinedBehaviorSanitizer' sanitized
fi
# The strange locale sees every test but the oracles; the plain one only those that run the whole program
# (their text is what a locale may change) and the oracles: no test of a room runs twice.
if wants locale; then check 'Testing in a Turkish locale' strange_locale; fi
for part in oracles golden program; do
  if wants "$part"; then check "Testing: $part" run_ctest "$build" -L "^$part\$"; fi
done

say
if [ ${#failures[@]} -gt 0 ]; then
  say "FAILED after $((SECONDS - started)) s:"
  printf '  %s\n' "${failures[@]}"
  exit 1
fi
say "All is well, after $((SECONDS - started)) s."
