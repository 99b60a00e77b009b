# Before an installation: notes which of the folders it makes are not there yet, so that uninstalling removes these and
# no others. THIESSEN_FOLDERS_MADE is the list to add to, THIESSEN_FOLDERS what will be made under the prefix, and
# THIESSEN_OWN_FOLDERS what has this project's name and goes, where it is empty, whoever made it: an earlier installation
# from another build folder may have.
if(CMAKE_INSTALL_COMPONENT)
  return()  # a part of it, as packages are made of: of that there is no uninstalling
endif()
foreach(folder ${THIESSEN_OWN_FOLDERS})
  cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}" OUTPUT_VARIABLE path)
  file(APPEND "${THIESSEN_FOLDERS_MADE}" "$ENV{DESTDIR}${path}\n")
endforeach()
foreach(folder ${THIESSEN_FOLDERS})
  cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}" OUTPUT_VARIABLE path)
  set(below)
  while(NOT EXISTS "$ENV{DESTDIR}${path}" AND NOT path STREQUAL below)
    file(APPEND "${THIESSEN_FOLDERS_MADE}" "$ENV{DESTDIR}${path}\n")
    set(below "${path}")
    cmake_path(GET path PARENT_PATH path)
  endwhile()
endforeach()
