# Writes the entries of ctest for a GoogleTest program, one a suite of tests: a process for each of 1,500
# tests would spend most of its time loading libraries.
#   cmake -DPROGRAM=file -DLABEL=label -DOUTPUT=file -P suites.cmake
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+\\.[ \n]" suites "${listed}")
list(TRANSFORM suites REPLACE "[ \n]" "")
cmake_path(GET PROGRAM STEM room)
string(REGEX REPLACE "_test$" "" room ${room})
set(entries)
foreach(suite ${suites})
  string(REGEX REPLACE "\\.$" "" name ${suite})
  string(APPEND entries "add_test(\"${room}.${name}\" \"${PROGRAM}\" \"--gtest_filter=${name}.*\")\n"
         "set_tests_properties(\"${room}.${name}\" PROPERTIES LABELS ${LABEL})\n")
endforeach()
if(NOT entries)
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()
file(WRITE ${OUTPUT} "${entries}")
