include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY REFRASTER_LAYERS)
install(TARGETS ${layers} refraster_strict_fp EXPORT refrasterTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT development
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/refraster)
# Everything that the component `libraries` installs: scripts/package_levels.
add_custom_target(libraries)
add_dependencies(libraries ${layers})
if(BUILD_SHARED_LIBS)
  set_target_properties(refraster PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
endif()
install(TARGETS refraster RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT refrasterTargets NAMESPACE refraster:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/refraster)
configure_package_config_file(cmake/refrasterConfig.cmake.in ${PROJECT_BINARY_DIR}/refrasterConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/refraster)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/refrasterConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/refrasterConfig.cmake ${PROJECT_BINARY_DIR}/refrasterConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/refraster)
