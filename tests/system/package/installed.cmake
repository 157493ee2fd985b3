# The build, installed to ${prefix}; and how a project outside is built against it.
file(REMOVE_RECURSE ${work_dir})
set(prefix ${work_dir}/prefix)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${ARGN}\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

# configure_and_build(SOURCE NAME COMPILER FLAGS [OPTIONS...]): into ${work_dir}/NAME.
function(configure_and_build source name with flags)
  run(${CMAKE_COMMAND} -G ${generator} -S ${source} -B ${work_dir}/${name} -D CMAKE_CXX_COMPILER=${with}
    -D CMAKE_CXX_FLAGS=${flags} -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF ${ARGN})
  run(${CMAKE_COMMAND} --build ${work_dir}/${name})
endfunction()

run(${CMAKE_COMMAND} --install ${build_dir} --prefix ${prefix})
