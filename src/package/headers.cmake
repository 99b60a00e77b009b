# cmake -DFROM=src -DTO=folder -P headers.cmake
# The headers that users include, and no others: what study/thiessen.h reaches, in TO/thiessen, and TO/thiessen.h.
# Among each other they are called by thiessen/ROOM/..., so that no name of a room meets a folder of the user's.
cmake_minimum_required(VERSION 3.22)

set(wanted study/thiessen.h)
set(known)
while(wanted)
  list(POP_FRONT wanted header)
  if(header IN_LIST known)
    continue()
  endif()
  list(APPEND known ${header})
  file(STRINGS ${FROM}/${header} lines REGEX "^#include \"")
  foreach(line ${lines})
    string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" included "${line}")
    list(APPEND wanted ${included})
  endforeach()
endwhile()

# write(file text): only where it differs, so that nothing is compiled anew for nothing.
function(write file text)
  set(old)
  if(EXISTS ${file})
    file(READ ${file} old)
  endif()
  if(NOT old STREQUAL text)
    file(WRITE ${file} "${text}")
  endif()
endfunction()

foreach(header ${known})
  file(READ ${FROM}/${header} text)
  string(REGEX REPLACE "(#include )\"([^\"]*)\"" "\\1<thiessen/\\2>" text "${text}")
  write(${TO}/thiessen/${header} "${text}")
endforeach()
write(${TO}/thiessen.h "#pragma once\n\n#include <thiessen/study/thiessen.h>\n")

file(GLOB_RECURSE there RELATIVE ${TO}/thiessen ${TO}/thiessen/*)
foreach(header ${there})
  if(NOT header IN_LIST known)
    file(REMOVE ${TO}/thiessen/${header})
  endif()
endforeach()
