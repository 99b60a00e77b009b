# cmake -DPROGRAM=thiessen "-DWORDS=help;--manual" -DTO=thiessen.1 -P page.cmake
# What the program prints, as a file.
cmake_minimum_required(VERSION 3.22)

execute_process(COMMAND ${PROGRAM} ${WORDS} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${TO} "${text}")
