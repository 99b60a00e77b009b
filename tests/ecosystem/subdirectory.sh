#!/bin/bash
# Takes the clone as a folder of another project (add_subdirectory), with GCC 11, Ubuntu 22.04's
# Packages: g++-11
set -euo pipefail

work=$CLONE/build-ecosystem/subdirectory
mkdir -p "$work/storm"
ln -sfn "$CLONE" "$work/storm/thiessen"
cp "$CLONE/samples/library/textbook.cpp" "$work/storm/"
# A project that has its own build type, standard, and a target of the name that thiessen's installation has.
cat >"$work/storm/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.22)
project(storm LANGUAGES CXX)
add_custom_target(uninstall)
add_custom_target(docs)
add_subdirectory(thiessen)
foreach(name CMAKE_BUILD_TYPE CMAKE_CXX_STANDARD CMAKE_CXX_FLAGS CMAKE_EXPORT_COMPILE_COMMANDS GDAL_FOUND OpenCV_FOUND)
  if(${name})
    message(FATAL_ERROR "thiessen sets ${name}")
  endif()
endforeach()
if(TARGET thiessen_gdal OR TARGET thiessen)
  message(FATAL_ERROR "the program is built, too")
endif()
add_executable(storm textbook.cpp)
target_link_libraries(storm PRIVATE thiessen::thiessen)
END
cmake -S "$work/storm" -B "$work/build" -DCMAKE_CXX_COMPILER=g++-11 -DTHIESSEN_JOINED=ON
cmake --build "$work/build" --parallel "$(nproc)"
"$work/build/storm" | tee "$work/answer"
grep -qx 'rainfall: 69.8364 mm' "$work/answer"
DESTDIR=$work/root cmake --install "$work/build"
if [ -e "$work/root" ]; then
  echo 'thiessen installs itself with a project that only uses it'
  exit 1
fi
echo "= the textbook's answer, by $(g++-11 --version | head -n 1), without GDAL and OpenCV"
