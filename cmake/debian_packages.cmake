# Debian packages: `refraster`, the program and the libraries; `librefraster-dev`; `python3-refraster`. For a build with
# shared libraries, with others of the same libraries for newer levels of x86-64 beside it: scripts/package_levels --deb
# makes them all, and calls `cpack -G DEB`.
set(REFRASTER_LEVELS "" CACHE STRING "Build folders of the same libraries for newer levels of x86-64")
set(REFRASTER_MAINTAINER "The refraster authors <refraster@example.org>" CACHE STRING "Who makes the packages")
set(release 1)
set(version ${PROJECT_VERSION}-${release})

# What each package says of itself below /usr/share/doc: licence and changes, in Debian's form too.
set(control ${PROJECT_BINARY_DIR}/debian)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # SOURCE_DATE_EPOCH, where it is set
file(CONFIGURE OUTPUT ${control}/changelog.Debian @ONLY NEWLINE_STYLE UNIX CONTENT [[refraster (@version@) unstable; urgency=medium

  * Version @PROJECT_VERSION@: see changelog.gz.

 -- @REFRASTER_MAINTAINER@  @date@
]])
file(COPY_FILE ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${control}/changelog)
file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
file(WRITE ${control}/copyright "This is refraster, packaged by its authors.\n\n${licence}")
foreach(file changelog changelog.Debian)
  execute_process(COMMAND ${REFRASTER_GZIP} -9nf ${control}/${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CHANGELOG.md LICENSE)

# The dynamic loader's cache is made again, and who links these libraries depends on this very version.
file(WRITE ${control}/triggers "activate-noawait ldconfig\n")
set(shlibs "")
set(library_folders "")
get_property(layers GLOBAL PROPERTY REFRASTER_LAYERS)
foreach(layer IN LISTS layers)
  string(APPEND shlibs "lib${layer} ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} refraster (= ${version})\n")
  get_target_property(folder ${layer} BINARY_DIR)
  list(APPEND library_folders ${folder})
endforeach()
file(WRITE ${control}/shlibs "${shlibs}")

set(CPACK_PACKAGE_NAME refraster)
set(CPACK_PACKAGE_CONTACT "${REFRASTER_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "refraster built using CMake") # CPack's own: no line before those of each package
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};refraster;ALL;/")
foreach(level IN LISTS REFRASTER_LEVELS)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS ${level} refraster LEVELS /)
endforeach()
set(CPACK_COMPONENTS_ALL program libraries development python)
set(CPACK_COMPONENTS_LEVELS libraries) # of the builds of levels
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_without_scripts.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${release})
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${library_folders})

# refraster_package(NAME GROUP SECTION SUMMARY COMPONENTS ...): a package of components.
macro(refraster_package name group section summary)
  set(CPACK_DEBIAN_${group}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${group}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${group}_DESCRIPTION "reference rasterizer for the CPU: ${summary}
refraster renders scenes of triangles exactly, as a reference that images
of GPUs can be held against: it compares and verifies them, says of every
pixel how it comes about, and measures what it costs.")
  foreach(component ${ARGN})
    set(CPACK_COMPONENT_${component}_GROUP ${group})
  endforeach()
  string(TOLOWER ${ARGV4} first)
  install(FILES ${control}/copyright ${control}/changelog.gz ${control}/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${first})
endmacro()

refraster_package(refraster MAIN graphics "program and libraries" PROGRAM LIBRARIES)
set(CPACK_DEBIAN_MAIN_PACKAGE_CONTROL_EXTRA ${control}/triggers ${control}/shlibs)
set(CPACK_DEBIAN_MAIN_PACKAGE_RECOMMENDS "libegl1, libgl1-mesa-dri") # loaded by gl and verify --gl alone
set(CPACK_DEBIAN_MAIN_PACKAGE_SUGGESTS "ffmpeg, libsdl2-2.0-0") # turntable -o x.mp4, view

refraster_package(librefraster-dev DEV libdevel "headers for C++" DEVELOPMENT)
string(CONCAT CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "refraster (= ${version}), g++, pkg-config, libglm-dev, libboost-dev, "
  "libopenexr-dev, libpng-dev, libjpeg62-turbo-dev, zlib1g-dev, nettle-dev")

refraster_package(python3-refraster PYTHON python "module for Python" PYTHON)
get_property(python GLOBAL PROPERTY REFRASTER_PYTHON_VERSION)
if(NOT python MATCHES "^3\\.([0-9]+)")
  message(FATAL_ERROR "REFRASTER_DEBIAN: the Python module is not built (scripts/setup python)")
endif()
math(EXPR next "${CMAKE_MATCH_1} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "refraster (= ${version}), python3 (>= 3.${CMAKE_MATCH_1}~), python3 (<< 3.${next}~), python3-numpy")

include(CPack)
