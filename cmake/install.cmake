include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(floors GLOBAL PROPERTY REFRASTER_FLOORS)
install(TARGETS ${floors} refraster_strict_fp EXPORT refrasterTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/refraster)
install(TARGETS refraster RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT refrasterTargets NAMESPACE refraster:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/refraster)
configure_package_config_file(cmake/refrasterConfig.cmake.in ${PROJECT_BINARY_DIR}/refrasterConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/refraster)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/refrasterConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/refrasterConfig.cmake ${PROJECT_BINARY_DIR}/refrasterConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/refraster)
