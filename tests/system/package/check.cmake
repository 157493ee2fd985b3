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

# The program of README.md, in a folder with a scene.
file(READ ${source_dir}/../../../README.md page)
string(REGEX MATCH "```cpp\n([^`]*)```" block "${page}")
set(program_text "${CMAKE_MATCH_1}")
file(WRITE ${work_dir}/readme_source/main.cpp "${program_text}")
configure_and_build(${source_dir}/readme readme ${compiler} "" -D MAIN_DIR=${work_dir}/readme_source)
file(COPY_FILE ${source_dir}/../../../scenes/hello.json ${work_dir}/readme/scene.json)
execute_process(COMMAND ${work_dir}/readme/program WORKING_DIRECTORY ${work_dir}/readme RESULT_VARIABLE failed
  ERROR_VARIABLE text)
if(failed OR NOT EXISTS ${work_dir}/readme/scene.png)
  message(FATAL_ERROR "the program of README.md: ${failed} ${text}")
endif()
