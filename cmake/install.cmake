# What `cmake --install` puts below a prefix, in four components: `program`, with its manual and completions;
# `libraries`, where they are shared; `development`; and `python` (python/CMakeLists.txt).
include(CMakePackageConfigHelpers)
set(REFRASTER_ZSH_FOLDER zsh/site-functions CACHE STRING "Below the data folder: one that zsh looks for completions in")

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/refraster)

# refraster_component(NAME TARGETS ...): what find_package(refraster COMPONENTS NAME) finds. A component
# asks for what it needs itself, so that who renders only needs no image library.
function(refraster_component name)
  install(TARGETS ${ARGN} EXPORT refraster_${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT development
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  install(EXPORT refraster_${name} NAMESPACE refraster:: FILE refraster_${name}.cmake DESTINATION ${package_dir}
    COMPONENT development)
endfunction()

refraster_component(raster refraster_headers refraster_math refraster_shading refraster_scene refraster_raster)
refraster_component(io refraster_io)
refraster_component(gl refraster_gl)
refraster_component(verify refraster_verify)
refraster_component(fragment_kit refraster_fragment_kit refraster_strict_fp)
install(DIRECTORY math shading DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/refraster-kit COMPONENT development
  FILES_MATCHING PATTERN "*.h" PATTERN precision_bounds.h EXCLUDE PATTERN half_of.h EXCLUDE PATTERN kit EXCLUDE)
install(FILES shading/kit/refraster/fragment_kit.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/refraster-kit/refraster
  COMPONENT development)
configure_package_config_file(cmake/refrasterConfig.cmake.in ${PROJECT_BINARY_DIR}/refrasterConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/refrasterConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/refrasterConfig.cmake ${PROJECT_BINARY_DIR}/refrasterConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT development)

if(BUILD_SHARED_LIBS)
  set_target_properties(refraster PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
endif()
install(TARGETS refraster RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
set(share ${PROJECT_BINARY_DIR}/share) # app/share.cmake fills it
install(DIRECTORY ${share}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
install(DIRECTORY ${share}/bash-completion/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion COMPONENT program)
install(DIRECTORY ${share}/fish/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fish COMPONENT program)
install(FILES ${share}/zsh/_refraster DESTINATION ${CMAKE_INSTALL_DATADIR}/${REFRASTER_ZSH_FOLDER} COMPONENT program)

# Everything that the component `libraries` installs, and everything that any of them does: scripts/package_levels.
get_property(layers GLOBAL PROPERTY REFRASTER_LAYERS)
add_custom_target(libraries)
add_dependencies(libraries ${layers})
add_custom_target(installed)
add_dependencies(installed libraries refraster refraster_share)
if(TARGET refraster_python)
  add_dependencies(installed refraster_python)
endif()
