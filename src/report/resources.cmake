# cmake -DFROM=src/report -DTO=page_resources.cpp -P resources.cmake
# The page's files as texts of the program.
cmake_minimum_required(VERSION 3.22)

set(code "#include \"report/page_resources.h\"\n\nnamespace thiessen {\n")
foreach(kind html css js)
  file(READ ${FROM}/page.${kind} text)
  string(APPEND code "\nconst char* const page_${kind} = R\"resource(${text})resource\";\n")
endforeach()
file(WRITE ${TO} "${code}\n}  // namespace thiessen\n")
