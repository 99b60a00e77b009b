# What is installed where, and how it is taken away again; read before anything is installed.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(folders_made ${PROJECT_BINARY_DIR}/install_folders.txt)
install(CODE "set(THIESSEN_FOLDERS_MADE \"${folders_made}\")
set(THIESSEN_FOLDERS ${CMAKE_INSTALL_BINDIR} ${CMAKE_INSTALL_INCLUDEDIR}/thiessen
    ${CMAKE_INSTALL_LIBDIR}/cmake/thiessen ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_LIBDIR}/thiessen
    ${CMAKE_INSTALL_MANDIR}/man1 ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    ${CMAKE_INSTALL_DATADIR}/zsh/site-functions ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
    ${CMAKE_INSTALL_DOCDIR})
set(THIESSEN_OWN_FOLDERS ${CMAKE_INSTALL_INCLUDEDIR}/thiessen ${CMAKE_INSTALL_LIBDIR}/cmake/thiessen
    ${CMAKE_INSTALL_LIBDIR}/thiessen ${CMAKE_INSTALL_DOCDIR})")
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/new_folders.cmake)

if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(uninstall VERBATIM
    COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
            -DFOLDERS_MADE=${folders_made} -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake)
endif()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright
        COMPONENT library)
set(samples ${PROJECT_SOURCE_DIR}/samples)
install(DIRECTORY ${samples}/textbook ${samples}/library ${samples}/colorado ${samples}/python ${samples}/qgis
        ${samples}/r ${samples}/jobs DESTINATION ${CMAKE_INSTALL_DOCDIR}/samples COMPONENT library
        FILES_MATCHING REGEX "\\.(csv|geojson|cpp|md|py|R)$")
install(PROGRAMS ${samples}/jobs/areal_jobs.sh DESTINATION ${CMAKE_INSTALL_DOCDIR}/samples/jobs COMPONENT library)
