# Installs the build to a folder of its own, then builds and runs a program that knows only that folder.
include(${CMAKE_CURRENT_LIST_DIR}/installed.cmake)
run(${prefix}/bin/refraster --version)

# Nothing is installed but the public headers and, apart, the fragment kit.
file(GLOB installed RELATIVE ${prefix}/include ${prefix}/include/*)
list(SORT installed)
if(NOT installed STREQUAL "refraster;refraster-kit")
  message(FATAL_ERROR "${prefix}/include holds ${installed}")
endif()
# And no instruction set is asked of who links it.
file(GLOB_RECURSE exported ${prefix}/lib/cmake/refraster/*.cmake)
foreach(file IN LISTS exported)
  file(READ ${file} text)
  if(text MATCHES "-march")
    message(FATAL_ERROR "${file} asks for an instruction set")
  endif()
endforeach()

configure_and_build(${source_dir}/consumer consumer ${compiler} "")
run(${work_dir}/consumer/consumer)
