# cmake -DFROM=clone -DTO=commit.cpp -P commit.cmake
# The source that knows the commit of a clone, with `-dirty` behind it where what is compiled differs from it. It is
# looked at in every build, and written only where it has changed.
cmake_minimum_required(VERSION 3.22)

set(commit unknown)
if(EXISTS ${FROM}/.git)
  find_program(git git)
  if(git)
    execute_process(COMMAND ${git} -C ${FROM} rev-parse --verify --quiet HEAD
                    OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(hash MATCHES "^[0-9a-f]+$")
      string(SUBSTRING ${hash} 0 7 commit)
      execute_process(COMMAND ${git} -C ${FROM} diff --quiet HEAD -- src cli CMakeLists.txt
                      RESULT_VARIABLE differs OUTPUT_QUIET ERROR_QUIET)
      if(differs)
        string(APPEND commit -dirty)
      endif()
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${TO} CONTENT [[
#include "cli/help/commit.h"

namespace thiessen::cli {

const char* commit() {
  return "@commit@";
}

}  // namespace thiessen::cli
]] @ONLY)
