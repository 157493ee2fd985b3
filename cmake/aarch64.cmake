# Toolchain of the preset aarch64: Debian's cross compiler, libraries of arm64 that scripts/setup_aarch64 unpacks, and
# qemu's emulation of a user's programs to run what was built. There is no binfmt: whatever starts a program that was
# built puts the emulator before it.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

set(REFRASTER_AARCH64_ROOT ${CMAKE_CURRENT_LIST_DIR}/../build/aarch64-root CACHE PATH "Libraries of arm64: scripts/setup_aarch64")
get_filename_component(arm64_root "${REFRASTER_AARCH64_ROOT}" ABSOLUTE)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES REFRASTER_AARCH64_ROOT)
if(NOT EXISTS ${arm64_root}/complete)
  message(FATAL_ERROR "no libraries of arm64 in ${arm64_root}: run scripts/setup_aarch64")
endif()

# Libraries, headers and CMake's packages come from there alone; programs that the build runs, from this machine.
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH ${arm64_root} /usr/aarch64-linux-gnu) # the second has the C library
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${arm64_root})
set(ENV{PKG_CONFIG_LIBDIR} ${arm64_root}/usr/lib/aarch64-linux-gnu/pkgconfig:${arm64_root}/usr/share/pkgconfig)
# Debian puts headers that differ between machines into a folder of their own.
set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${arm64_root}/usr/include/aarch64-linux-gnu)
# The emulator finds libraries in the root: no program needs to know where it stands.
set(CMAKE_SKIP_BUILD_RPATH ON)
# Where the linker looks for what those libraries need themselves.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-rpath-link,${arm64_root}/usr/lib/aarch64-linux-gnu:${arm64_root}/lib/aarch64-linux-gnu")

find_program(REFRASTER_QEMU_AARCH64 qemu-aarch64-static REQUIRED)
set(CMAKE_CROSSCOMPILING_EMULATOR ${REFRASTER_QEMU_AARCH64};-L;${arm64_root})
