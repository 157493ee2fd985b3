option(REFRASTER_PRECOMPILE "Read common headers once for each library, and once for all tests" OFF)

# What most files of a target include is read once, where REFRASTER_PRECOMPILE says so: a third of the time that its
# smaller files take. They include what they use all the same: a build without the option finds what is missing.
function(refraster_precompile target)
  if(REFRASTER_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
    refraster_precompiled_warnings(${target})
  endif()
endfunction()

# What GCC 12 sees wrongly in "literal" + std::string (GCC bug 105651) is then no longer a warning of a system header.
function(refraster_precompiled_warnings target)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>)
endfunction()

# refraster_layer(NAME SOURCES ... [PUBLIC ...] [PRIVATE ...])
# One library for one layer of the code base, with alias refraster::NAME. Static, or shared with BUILD_SHARED_LIBS:
# scripts/package_levels. Its headers are found within this build only: who uses the library sees include/refraster.
function(refraster_layer name)
  cmake_parse_arguments(layer "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target refraster_${name})
  add_library(${target} ${layer_SOURCES})
  add_library(refraster::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN")
  if(BUILD_SHARED_LIBS)
    # A library calls its own functions, also where a program built for another instruction set has them too.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
    target_link_options(${target} PRIVATE LINKER:-Bsymbolic-functions)
  endif()
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_link_libraries(${target} PUBLIC ${layer_PUBLIC} PRIVATE $<BUILD_INTERFACE:refraster_build_flags> ${layer_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY REFRASTER_LAYERS ${target})
endfunction()
