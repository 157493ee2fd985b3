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

# The manual and completions are what the program prints, and --help names the page that stands there.
set(share ${prefix}/share)
run(${prefix}/bin/refraster list man-page --folder ${work_dir}/pages)
file(GLOB pages RELATIVE ${work_dir}/pages ${work_dir}/pages/*)
file(GLOB installed_pages RELATIVE ${share}/man/man1 ${share}/man/man1/*)
if(NOT pages OR NOT pages STREQUAL installed_pages)
  message(FATAL_ERROR "pages of the manual: found ${installed_pages}, expected ${pages}")
endif()
function(expect_same file expected)
  file(READ ${file} found)
  if(NOT found STREQUAL expected)
    message(FATAL_ERROR "${file} is not what the program prints")
  endif()
endfunction()
foreach(page IN LISTS pages)
  file(READ ${work_dir}/pages/${page} expected)
  expect_same(${share}/man/man1/${page} "${expected}")
endforeach()
foreach(of IN ITEMS bash=bash-completion/completions/refraster zsh=zsh/site-functions/_refraster
    fish=fish/vendor_completions.d/refraster.fish)
  string(REGEX MATCH "^(.*)=(.*)$" whole ${of})
  set(file ${share}/${CMAKE_MATCH_2})
  run(${prefix}/bin/refraster list completions ${CMAKE_MATCH_1})
  expect_same(${file} "${output}")
endforeach()
run(${prefix}/bin/refraster brdf info --help)
string(REGEX REPLACE "[ \n]+" " " help "${output}")
string(FIND "${help}" "Page of the manual: `man refraster-brdf-info`, ${share}/man/man1/refraster-brdf-info.1 " at)
if(at LESS 0)
  message(FATAL_ERROR "--help does not name the page that is installed:\n${output}")
endif()

# The Python module, where it is built.
if(python)
  run(${CMAKE_COMMAND} -E env PYTHONPATH=${prefix}/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1
    ${python} ${source_dir}/use_module.py ${prefix} ${source_dir}/../../../scenes/hello.json)
endif()

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
