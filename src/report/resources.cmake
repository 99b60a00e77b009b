# cmake -DFROM=src/report -DSCRIPT="elements.js;...;page.js" -DTO=page_resources.cpp -P resources.cmake
# The page's files as texts of the program.
cmake_minimum_required(VERSION 3.22)

set(code "#include \"report/page_resources.h\"\n\nnamespace thiessen {\n")
# A text stands in the code as file(READ) gives it, however many semicolons and brackets it has.
macro(append_text name)
  string(APPEND code "\nconst char* const page_${name} =")
  foreach(file ${ARGN})
    file(READ ${FROM}/${file} text)
    string(APPEND code "\n    R\"resource(${text})resource\"")
  endforeach()
  string(APPEND code ";\n")
endmacro()
append_text(html page.html)
append_text(css page.css)
append_text(script ${SCRIPT})
file(WRITE ${TO} "${code}\n}  // namespace thiessen\n")
