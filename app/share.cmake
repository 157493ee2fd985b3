# What the program says of itself, written to files below ${share}: pages of the manual, packed where ${pack} is the path
# of gzip, and what makes shells complete. ${emulator} runs the program where it is built for another machine.
file(REMOVE_RECURSE ${share})
set(completions_bash ${share}/bash-completion/completions/refraster)
set(completions_zsh ${share}/zsh/_refraster)
set(completions_fish ${share}/fish/vendor_completions.d/refraster.fish)

foreach(shell bash zsh fish)
  get_filename_component(folder ${completions_${shell}} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${emulator} ${program} list completions ${shell}
    OUTPUT_FILE ${completions_${shell}} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${emulator} ${program} list man-page --folder ${share}/man/man1 COMMAND_ERROR_IS_FATAL ANY)
if(pack)
  file(GLOB pages ${share}/man/man1/*.1)
  execute_process(COMMAND ${pack} -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
endif()
file(TOUCH ${share}/made.stamp)
