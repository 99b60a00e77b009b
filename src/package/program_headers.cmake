# cmake -DFROM=clone -DTO=file -P program_headers.cmake
# The digest of the headers that the module for Python reaches, as thiessen-config.cmake reads it.
cmake_minimum_required(VERSION 3.22)

include(${CMAKE_CURRENT_LIST_DIR}/reached_headers.cmake)
thiessen_program_digest(digest ${FROM})
thiessen_write(${TO} "set(THIESSEN_PROGRAM_HEADERS ${digest})\n")
