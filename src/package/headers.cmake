# cmake -DFROM=src -DTO=folder -P headers.cmake
# The headers that users include, and no others: what study/thiessen.h reaches, in TO/thiessen, and TO/thiessen.h.
# Among each other they are called by thiessen/ROOM/..., so that no name of a room meets a folder of the user's.
cmake_minimum_required(VERSION 3.22)

include(${CMAKE_CURRENT_LIST_DIR}/reached_headers.cmake)
thiessen_reached_headers(known ${FROM} study/thiessen.h)
foreach(header ${known})
  file(READ ${FROM}/${header} text)
  string(REGEX REPLACE "(#include )\"([^\"]*)\"" "\\1<thiessen/\\2>" text "${text}")
  thiessen_write(${TO}/thiessen/${header} "${text}")
endforeach()
thiessen_write(${TO}/thiessen.h "#pragma once\n\n#include <thiessen/study/thiessen.h>\n")

file(GLOB_RECURSE there RELATIVE ${TO}/thiessen ${TO}/thiessen/*)
foreach(header ${there})
  if(NOT header IN_LIST known)
    file(REMOVE ${TO}/thiessen/${header})
  endif()
endforeach()
