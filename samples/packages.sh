#!/bin/sh
# Installs the Debian packages that thiessen needs, those that are missing:
#   samples/packages.sh build          to build and run the program
#   samples/packages.sh build tests    the tests as well
#   samples/packages.sh build named PACKAGE...    and these
set -eu

# libopencv-dev alone tells CMake where OpenCV is; its freetype module comes with it.
build='g++ cmake make libeigen3-dev libgdal-dev libgeos-dev libgeographiclib-dev libopencv-dev libcli11-dev libtomlplusplus-dev libfontconfig-dev
  libfribidi-dev libexpat1-dev libhowardhinnant-date-dev libedit-dev libpq-dev libssl-dev libsqlite3-dev libnetcdf-dev zlib1g-dev fonts-dejavu-core fonts-unifont'
tests='ninja-build libgtest-dev libbenchmark-dev libcgal-dev clang libclang-rt-dev clang-format
  clang-tidy shellcheck mandoc gdal-bin python3 python3-xarray python3-netcdf4 locales git'

say() { printf '%s\n' "$*"; }
fail() {
  printf 'packages.sh: error: %s\n' "$1" >&2
  printf 'hint: %s\n' "$2" >&2
  exit 1
}

wanted=
named=
for group; do
  if [ -n "$named" ]; then
    wanted="$wanted $group"
    continue
  fi
  case $group in
    named) named=yes ;;
    build) wanted="$wanted $build" ;;
    tests) wanted="$wanted $tests" ;;
    *) fail "there is no group of packages '$group'" 'the groups are: build, tests; named PACKAGE... stands last' ;;
  esac
done

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  # shellcheck disable=SC2086  # the list is meant to be split
  fail 'this script needs apt-get, the package manager of Debian' \
    "install what these packages hold by your own system's means, then see \"Building\" in README.md:$(printf ' %s' $wanted)"
fi

# Before its version 2, as in Ubuntu 22.04, GeographicLib is in a package of another name.
if ! apt-cache show libgeographiclib-dev >/dev/null 2>&1 && apt-cache show libgeographic-dev >/dev/null 2>&1; then
  wanted=$(printf '%s' "$wanted" | sed 's/libgeographiclib-dev/libgeographic-dev/')
fi

missing=
for package in $wanted; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
if [ -z "$missing" ]; then
  say 'All packages that are needed are installed.'
  exit 0
fi

as_root=
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null ||
    fail "these packages are missing, and only root may install them:$missing" \
      "as root, run: apt-get install --no-install-recommends$missing"
  as_root=sudo
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
    -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 "$@" </dev/null >"$log" 2>&1
}
# shellcheck disable=SC2086
install() { apt install --no-install-recommends "$@" $missing; }
updated=
update() {
  [ -z "$updated" ] || return 0
  updated=yes
  say 'Fetching the list of packages ...'
  apt update || true # what matters is whether the packages can be had
}

say "Installing packages (a few minutes, where all are missing):$missing"
install --dry-run || update
if ! install; then
  update
  if ! install; then
    tail -n 20 "$log" >&2
    fail 'the packages could not be installed; the last lines of apt-get stand above' \
      "is there a network? To see all of it: $as_root apt-get install --no-install-recommends$missing"
  fi
fi
say 'The packages are installed.'
