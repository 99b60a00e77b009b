# What the library rests on, as thiessen::GeographicLib and thiessen::GEOS: read where thiessen is built, and again by
# find_package(thiessen) where it is used, so that no path of the machine that built it is kept. What is missing ends the
# build of thiessen; find_package(thiessen) is told of it in thiessen_LACKING.
#
# GeographicLib has a CMake config where its own build installed one, a module file on Debian and Ubuntu, and neither
# on some systems; before version 2 its library is called Geographic. The config's target has had two names.
include(CMakeFindDependencyMacro)

set(thiessen_LACKING)

function(thiessen_lacks message)
  if(NOT CMAKE_FIND_PACKAGE_NAME STREQUAL "thiessen")
    message(FATAL_ERROR "${message}")
  endif()
  set(thiessen_LACKING "${message}" PARENT_SCOPE)
endfunction()

function(thiessen_find_geographiclib)
  find_package(GeographicLib CONFIG QUIET)
  set(found)
  foreach(target GeographicLib::GeographicLib GeographicLib_SHARED GeographicLib)
    if(NOT found AND TARGET ${target})
      set(found ${target})
    endif()
  endforeach()
  if(found)
    add_library(thiessen::GeographicLib INTERFACE IMPORTED GLOBAL)
    target_link_libraries(thiessen::GeographicLib INTERFACE ${found})
    return()
  endif()
  find_path(GeographicLib_INCLUDE_DIR GeographicLib/Geodesic.hpp)
  find_library(GeographicLib_LIBRARY NAMES GeographicLib Geographic)
  mark_as_advanced(GeographicLib_INCLUDE_DIR GeographicLib_LIBRARY)
  if(NOT GeographicLib_INCLUDE_DIR OR NOT GeographicLib_LIBRARY)
    thiessen_lacks("GeographicLib is not found: install libgeographiclib-dev (Debian), libgeographic-dev (Ubuntu 22.04) or GeographicLib-devel (Fedora)")
    set(thiessen_LACKING "${thiessen_LACKING}" PARENT_SCOPE)
    return()
  endif()
  add_library(thiessen::GeographicLib INTERFACE IMPORTED GLOBAL)
  set_target_properties(thiessen::GeographicLib PROPERTIES
                        INTERFACE_INCLUDE_DIRECTORIES "${GeographicLib_INCLUDE_DIR}"
                        INTERFACE_LINK_LIBRARIES "${GeographicLib_LIBRARY}")
endfunction()

# GEOS by its C interface: its own CMake config is younger than some systems' GEOS.
function(thiessen_find_geos)
  find_path(GEOS_INCLUDE_DIR geos_c.h)
  find_library(GEOS_LIBRARY geos_c)
  mark_as_advanced(GEOS_INCLUDE_DIR GEOS_LIBRARY)
  if(NOT GEOS_INCLUDE_DIR OR NOT GEOS_LIBRARY)
    thiessen_lacks("GEOS is not found: install libgeos-dev (Debian, Ubuntu) or geos-devel (Fedora)")
    set(thiessen_LACKING "${thiessen_LACKING}" PARENT_SCOPE)
    return()
  endif()
  add_library(thiessen::GEOS INTERFACE IMPORTED GLOBAL)
  set_target_properties(thiessen::GEOS PROPERTIES
                        INTERFACE_INCLUDE_DIRECTORIES "${GEOS_INCLUDE_DIR}"
                        INTERFACE_LINK_LIBRARIES "${GEOS_LIBRARY}")
endfunction()

find_dependency(Threads)
if(NOT TARGET thiessen::GeographicLib)
  thiessen_find_geographiclib()
endif()
if(NOT TARGET thiessen::GEOS AND NOT thiessen_LACKING)
  thiessen_find_geos()
endif()
