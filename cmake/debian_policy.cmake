# What Debian's policy asks of the files that are installed.
set(CMAKE_SKIP_INSTALL_RPATH ON) # libraries are found where the system's are
find_program(REFRASTER_GZIP gzip REQUIRED) # for pages of the manual
set(REFRASTER_ZSH_FOLDER zsh/vendor-completions)
