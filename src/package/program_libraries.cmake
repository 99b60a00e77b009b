# What the rooms from readings/ to files/ rest on beside what the library does, NetCDF and HDF5 as thiessen::NetCDF and
# thiessen::HDF5: read where thiessen is built, where all is required, and again by find_package(thiessen COMPONENTS
# program), which tells in thiessen_NOT_FOUND_MESSAGE what is missing.
include(CMakeFindDependencyMacro)

foreach(name GDAL PROJ EXPAT SQLite3 PostgreSQL ZLIB OpenSSL)
  if(CMAKE_FIND_PACKAGE_NAME)
    find_dependency(${name})
  else()
    find_package(${name} REQUIRED)
  endif()
endforeach()

find_path(NetCDF_INCLUDE_DIR netcdf.h)
find_library(NetCDF_LIBRARY netcdf)
find_path(HDF5_INCLUDE_DIR H5public.h PATH_SUFFIXES hdf5/serial)
find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5)
foreach(name NetCDF HDF5)
  mark_as_advanced(${name}_INCLUDE_DIR ${name}_LIBRARY)
  if(NOT ${name}_INCLUDE_DIR OR NOT ${name}_LIBRARY)
    string(TOLOWER ${name} package)
    set(message "${name} is not found: install lib${package}-dev (Debian, Ubuntu) or ${package}-devel (Fedora)")
    if(NOT CMAKE_FIND_PACKAGE_NAME)
      message(FATAL_ERROR "${message}")
    endif()
    set(${CMAKE_FIND_PACKAGE_NAME}_NOT_FOUND_MESSAGE "${message}")
    set(${CMAKE_FIND_PACKAGE_NAME}_FOUND OFF)
    return()
  endif()
  if(NOT TARGET thiessen::${name})
    add_library(thiessen::${name} INTERFACE IMPORTED GLOBAL)
    set_target_properties(thiessen::${name} PROPERTIES
                          INTERFACE_INCLUDE_DIRECTORIES "${${name}_INCLUDE_DIR}"
                          INTERFACE_LINK_LIBRARIES "${${name}_LIBRARY}")
  endif()
endforeach()
set(thiessen_program_FOUND ON)
