# The consumer with its own fragment function gives the bits that the same function gives within the tree.
set(work_dir ${work_dir}_fragment_kit)
include(${CMAKE_CURRENT_LIST_DIR}/installed.cmake)

set(scene ${source_dir}/fragment_kit/moon.json)
run(${moon} ${scene})
set(expected "${output}")
message(STATUS "${expected}")
if(NOT expected MATCHES "double [1-9][0-9]+ .*float .*fast .*exact ")
  message(FATAL_ERROR "not every precision was rendered:\n${expected}")
endif()

foreach(with g++ clang++)
  find_program(compiler_${with} ${with})
  if(NOT compiler_${with})
    message(STATUS "${with} is not installed: skipped")
    continue()
  endif()
  execute_process(COMMAND ${compiler_${with}} -fopenmp -x c++ -o /dev/null - INPUT_FILE ${source_dir}/empty.cpp
    RESULT_VARIABLE no_openmp OUTPUT_QUIET ERROR_QUIET)
  if(no_openmp)
    message(STATUS "${with} has no OpenMP: skipped")
    continue()
  endif()
  configure_and_build(${source_dir}/fragment_kit ${with} ${compiler_${with}} -march=x86-64-v2 -D MOON_DIR=${moon_dir})
  run(${work_dir}/${with}/moon ${scene})
  if(NOT output STREQUAL expected)
    message(FATAL_ERROR "${with} at x86-64-v2:\n${output}within the tree:\n${expected}")
  endif()
endforeach()

# What would not give the same bits does not compile.
execute_process(COMMAND ${compiler} -std=c++20 -ffast-math -fsyntax-only -I${moon_dir} -I${prefix}/include
  -I${prefix}/include/refraster-kit ${source_dir}/fragment_kit/moon.cpp RESULT_VARIABLE failed OUTPUT_QUIET
  ERROR_VARIABLE text)
if(NOT failed OR NOT text MATCHES "IEEE arithmetic")
  message(FATAL_ERROR "-ffast-math is not refused:\n${text}")
endif()
