#!/bin/bash
# Installs what is missing, builds thiessen with its tests in <clone>/build-tests, and runs them all:
# layout, includes, lint, the core under sanitizers, every test, in a strange locale.
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
    grep -E 'tests passed|(sources|files) looked at' "$log" || true
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
  cd "$clone" || return
  local list found
  list=$(mktemp)
  if ! files '*.cpp' '*.h' >"$list" || [ ! -s "$list" ]; then
    echo 'no C++ files are found'
    return 1
  fi
  # Its status tells, so that one that cannot run is no pass.
  found=$(xargs -0 -r clang-format --dry-run -Werror <"$list" 2>&1) && rm "$list" && return
  printf 'places to mend with clang-format -i, file by file:\n'
  sed -n 's/^\([^ :]*\):[0-9]*:[0-9]*: error.*/\1/p' <<<"$found" | sort | uniq -c
  grep -v ': error: code should be' <<<"$found" | tail -n 3
  return 1
}

includes() { "$clone/tests/includes.py"; }

scripts() {
  cd "$clone"
  files '*.sh' .ci/run | xargs -0 -r shellcheck
}

run_ctest() {
  local folder=$1
  shift
  ctest --test-dir "$folder" --output-on-failure --no-tests=error --timeout 900 \
    --parallel "$(nproc)" "$@"
}

sanitized() {
  # Reports need the lines' numbers and no more of what a debugger wants.
  TARGETS=core_tests "$clone/samples/build.sh" "$core" -DTHIESSEN_TESTS=ON -DTHIESSEN_WERROR=ON \
    -DTHIESSEN_QUICK_TESTS=ON -DTHIESSEN_JOINED=ON -DTHIESSEN_SANITIZE=address,undefined -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG='-O1 -gline-tables-only' -DCMAKE_CXX_COMPILER=clang++ || return
  run_ctest "$core" -L core
}

# Turkish has a decimal comma and a letter i of its own; the Chatham Islands are 12:45 from Greenwich: what holds
# there holds in a plain locale, so no test runs twice.
tests() {
  local locales=$build/locales
  if [ ! -d "$locales/tr_TR.UTF-8" ]; then
    mkdir -p "$locales"
    localedef -i tr_TR -f UTF-8 "$locales/tr_TR.UTF-8" || return
  fi
  LOCPATH=$locales LC_ALL=tr_TR.UTF-8 LANG=tr_TR.UTF-8 TZ=Pacific/Chatham run_ctest "$build" "$@"
}

build() {
  say "Building thiessen and its tests in $build ..."
  "$clone/samples/build.sh" "$build" -DTHIESSEN_TESTS=ON -DTHIESSEN_WERROR=ON \
    -DTHIESSEN_QUICK_TESTS=ON -DTHIESSEN_JOINED=ON -DCMAKE_BUILD_TYPE=Release
}

# What a part took is kept in the build folder: the first time, when all has to be built, and the last.
known=$build/seconds
seconds_of() { # PART: what it took or, where that is not known, what it takes on two processors
  if [ -e "$known/$1" ]; then
    cat "$known/$1"
  elif [ -e "$known/$1.first" ]; then
    case $1 in
      build | lint | sanitized) echo $((120 / $(nproc))) ;;
      *) cat "$known/$1.first" ;;
    esac
  else
    case $1 in
      layout | scripts | includes) echo 5 ;;
      build) echo $((1200 / $(nproc))) ;;
      lint | sanitized) echo $((600 / $(nproc))) ;;
      *) echo $((800 / $(nproc))) ;;
    esac
  fi
}

estimate() {
  local name sum=0 told=''
  for name in "${parts[@]}" "${labels[@]}"; do
    wants "$name" || continue
    sum=$((sum + $(seconds_of "$name")))
    told+=", $name $(seconds_of "$name")"
  done
  say "This takes about $(((sum + 59) / 60)) min, as far as is known (in seconds: ${told#, })."
}

# part NAME COMMAND...: runs it, tells what it took and keeps that.
part() {
  local name=$1 from=$SECONDS to
  shift
  "$@"
  mkdir -p "$known"
  to=$known/$name
  [ -e "$known/$name.first" ] || to=$known/$name.first
  echo $((SECONDS - from)) >"$to"
  say "  $name: $((SECONDS - from)) s"
}

help() {
  cat <<'END'
tests/run.sh [PART...]: all parts, or those that are named:
  layout      the layout of the C++ files (clang-format)
  scripts     the shell scripts (shellcheck)
  includes    whether every file includes what it names
  build       the program and its tests
  lint        clang-tidy over src/ and cli/
  sanitized   the core with Clang, AddressSanitizer and UndefinedBehaviorSanitizer
  tests       every test, in a Turkish locale; ctest runs them in yours
or only some of the tests, by their label: core, files, oracles, golden or program.
What needs the build brings it up to date first.
END
}

parts=(layout scripts includes build lint sanitized tests)
labels=(core files oracles golden program)
for part; do
  case $part in
    -h | --help) help && exit ;;
  esac
  if [[ " ${parts[*]} ${labels[*]} " != *" $part "* ]]; then
    printf "run.sh: error: there is no part '%s'\nhint: the parts are: %s\n" "$part" "${parts[*]} ${labels[*]}" >&2
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

if wants lint tests "${labels[@]}"; then chosen=" build$chosen"; fi
estimate
if wants layout; then part layout check 'Checking the layout of the C++ files (clang-format)' layout; fi
if wants scripts; then part scripts check 'Checking the scripts (shellcheck)' scripts; fi
if wants includes; then part includes check 'Checking what files include' includes; fi
if wants build; then part build build; fi
if wants lint; then part lint check 'Linting (clang-tidy)' "$clone/tests/lint.py" "$build"; fi
if wants sanitized; then
  part sanitized check 'Testing the core with Clang, AddressSanitizer and UndefinedBehaviorSanitizer' sanitized
fi
if wants tests; then part tests check 'Testing in a Turkish locale' tests; fi
for label in "${labels[@]}"; do
  if wants "$label"; then part "$label" check "Testing $label in a Turkish locale" tests -L "$label"; fi
done

say
if [ ${#failures[@]} -gt 0 ]; then
  say "FAILED after $((SECONDS - started)) s:"
  printf '  %s\n' "${failures[@]}"
  exit 1
fi
say "All is well, after $((SECONDS - started)) s."
