# Installs the build to a folder of its own, then builds and runs a program that knows only that folder.
file(REMOVE_RECURSE ${work_dir})
set(prefix ${work_dir}/prefix)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${ARGN}\n${text}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${build_dir} --prefix ${prefix})
run(${prefix}/bin/refraster --version)
run(${CMAKE_COMMAND} -G ${generator} -S ${consumer_dir} -B ${work_dir}/build -D CMAKE_CXX_COMPILER=${compiler}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${work_dir}/build)
run(${work_dir}/build/consumer)
