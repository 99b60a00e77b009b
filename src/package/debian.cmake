# One Debian package, thiessen, of the program and the library: `cpack` in the build folder, or its target `package`.
# It is of what is installed, but for what Debian has in another form: the manual is packed, zsh looks elsewhere.
set(THIESSEN_MAINTAINER "The thiessen authors <authors@thiessen.example>" CACHE STRING "Who answers for the package")
mark_as_advanced(THIESSEN_MAINTAINER)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME thiessen)
set(CPACK_PACKAGE_CONTACT ${THIESSEN_MAINTAINER})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "areal rainfall from rain gauges by exact Thiessen polygons")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Rain gauges, basins and readings in; areal rainfall out. The gauges are
tessellated on the Earth as it is (Thiessen polygons, Voronoi cells), the
cells clipped to basins, and the readings weighed, step by step, gaps
included. Results are tables, cells for a GIS, maps and grids.
.
The package holds the program and, for programs in C++, the library with its
headers; to compile with it, or the module for Python from its sources,
install what is suggested, too.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core, fonts-unifont")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "g++, libgeographiclib-dev | libgeographic-dev, libgeos-dev, cmake, libgdal-dev, pybind11-dev")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_COMPONENTS_ALL program library debian)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)

find_program(GZIP_PROGRAM gzip)
find_program(DATE_PROGRAM date)
if(GZIP_PROGRAM AND DATE_PROGRAM)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C TZ=UTC ${DATE_PROGRAM} -R -d ${THIESSEN_DATE}
                  OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set(debian ${PROJECT_BINARY_DIR}/debian)
  file(WRITE ${debian}/changelog "thiessen (${PROJECT_VERSION}) unstable; urgency=medium

  * Version ${PROJECT_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  set(manual ${PROJECT_BINARY_DIR}/pages/thiessen.1)
  add_custom_command(OUTPUT ${debian}/thiessen.1.gz DEPENDS ${manual} thiessen_pages VERBATIM
    COMMAND ${CMAKE_COMMAND} -E copy ${manual} ${debian}/thiessen.1
    COMMAND ${GZIP_PROGRAM} -9nf ${debian}/thiessen.1)
  add_custom_command(OUTPUT ${debian}/changelog.gz DEPENDS ${debian}/changelog VERBATIM
    COMMAND ${GZIP_PROGRAM} -9nkf ${debian}/changelog)
  add_custom_target(thiessen_debian ALL DEPENDS ${debian}/thiessen.1.gz ${debian}/changelog.gz)
  install(FILES ${debian}/thiessen.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT debian EXCLUDE_FROM_ALL)
  install(FILES ${debian}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT debian EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/pages/_thiessen DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
          COMPONENT debian EXCLUDE_FROM_ALL)
  include(CPack)
endif()
