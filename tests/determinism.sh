#!/bin/sh
# The same bytes from every compiler, and the same tests on another processor.
#
# tests/determinism.sh [PART...]
#   programs   the program by GCC and by Clang, each with -O0 and with -O3, on all golden cases, which are compared to the
#              byte (an hour on two processors; -O0 is ten times as slow)
#   arm64      the tests of the rooms without GDAL and OpenCV, compiled for ARM64, by qemu-user (half an hour)
# Without a part both. A room or a case that differs is named, and the exit status is 1. What is built stays in
# build-determinism/, so that the next run is short. arm64 wants g++-aarch64-linux-gnu and qemu-user-static, and fetches the
# libraries of ARM64 from Debian without installing them.
set -eu
cd "$(dirname "$0")/.."
folder=$PWD/build-determinism
mkdir -p "$folder"
failed=0

programs() {
  for compiler in g++ clang++; do
    for level in 0 3; do
      build=$folder/$compiler-O$level
      echo "== $compiler -O$level"
      if ! { cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="-O$level -DNDEBUG" \
                   -DTHIESSEN_JOINED=ON && cmake --build "$build" --target thiessen -j2; } >"$build.log" 2>&1; then
        tail -20 "$build.log"
        exit 1
      fi
      python3 -B tests/golden/run.py --program "$build/cli/thiessen" tests/golden/*/*.case >"$build.golden" || failed=1
      grep -E '^tests/golden/.*\.case:|cases:' "$build.golden" | tail -40
    done
  done
}

# The libraries of ARM64, unpacked under $root: apt is told of another machine, and this one stays as it is.
fetch_arm64() {
  root=$folder/arm64-root
  [ -e "$root/done" ] && return
  mkdir -p "$root/lists/partial" "$root/cache/archives/partial" "$root/packages"
  arm64="-o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::lists=$root/lists -o Dir::Cache=$root/cache -o Dir::State::status=/dev/null"
  # shellcheck disable=SC2086  # options, word by word
  (cd "$root/packages" && apt-get -qq $arm64 update &&
    apt-get -qq $arm64 download libgeographiclib-dev libgeographiclib23 libgtest-dev libgeos-dev libgeos-c1v5 libgeos3.11.1)
  for package in "$root"/packages/*.deb; do dpkg -x "$package" "$root"; done
  touch "$root/done"
}

arm64() {
  fetch_arm64
  build=$folder/arm64
  libraries=$root/usr/lib/aarch64-linux-gnu
  if ! { cmake -S . -B "$build" -DTHIESSEN_PROGRAM=OFF -DCMAKE_BUILD_TYPE=Release -DTHIESSEN_JOINED=ON -DCMAKE_SYSTEM_NAME=Linux \
        -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ \
        -DCMAKE_CXX_FLAGS="-isystem $root/usr/include" -DCMAKE_DISABLE_FIND_PACKAGE_GeographicLib=ON \
        -DGeographicLib_INCLUDE_DIR="$root/usr/include" -DGeographicLib_LIBRARY="$libraries/libGeographicLib.so" \
        -DGEOS_INCLUDE_DIR="$root/usr/include" -DGEOS_LIBRARY="$libraries/libgeos_c.so" \
        -DEigen_INCLUDE_DIR=/usr/include/eigen3 && cmake --build "$build" -j2; } >"$build.log" 2>&1; then
    tail -20 "$build.log"
    exit 1
  fi
  for room in base geometry tessellation diagram earth basin text outlines study rainfall; do
    alone=$(grep -rl '^// Compiled alone' tests/"$room" --include='*_test.cpp') || alone=
    find tests/"$room" -name '*_test.cpp' -exec grep -L '^// Compiled alone' {} + | sort |
      xargs python3 -B tests/joined.py "$build/$room.cpp"
    # shellcheck disable=SC2086  # sources, name by name
    aarch64-linux-gnu-g++ -std=c++20 -O1 -Isrc -Itests -isystem "$root/usr/include" "$build/$room.cpp" $alone tests/main.cpp \
      -Wl,--start-group "$build"/src/libthiessen_*.a -Wl,--end-group "$libraries/libgtest.a" \
      "$libraries/libGeographicLib.so" "$libraries/libgeos_c.so" -Wl,-rpath-link,"$libraries" -lpthread \
      -o "$build/${room}_test" || { failed=1; continue; }
    echo "== ARM64: $room"
    LD_LIBRARY_PATH=$libraries qemu-aarch64-static -L /usr/aarch64-linux-gnu -E LD_LIBRARY_PATH="$libraries" \
      "$build/${room}_test" --gtest_brief=1 >"$build/$room.txt" 2>&1 || failed=1
    grep -E '^\[  (PASSED|FAILED)' "$build/$room.txt" || tail -5 "$build/$room.txt"
  done
}

[ $# -gt 0 ] || set -- programs arm64
for part; do
  case $part in
    programs) programs ;;
    arm64) arm64 ;;
    *) sed -n '2,11s/^# \{0,1\}//p' "$0"; exit 2 ;;
  esac
done
exit $failed
