# stb_image reads TGA and BMP from strangers, behind headers that io/image/tga_file.cpp and io/image/bmp_file.cpp make.
# Its faults in other formats do not reach us; these flags meet what a fault in those two could do:
#   -fwrapv                       an overflow is defined
#   -ftrivial-auto-var-init=zero  a palette on the stack that is not filled (nothings/stb issue 1929) shows no memory
# clang before 16 wants to be told twice.
include(CheckCXXCompilerFlag)
set(stb_flags -fwrapv)
check_cxx_compiler_flag(-ftrivial-auto-var-init=zero REFRASTER_HAS_ZERO_INIT)
set(twice -enable-trivial-auto-var-init-zero-knowing-it-will-be-removed-from-clang)
check_cxx_compiler_flag("-ftrivial-auto-var-init=zero ${twice}" REFRASTER_HAS_ZERO_INIT_TWICE)
if(REFRASTER_HAS_ZERO_INIT)
  list(APPEND stb_flags -ftrivial-auto-var-init=zero)
elseif(REFRASTER_HAS_ZERO_INIT_TWICE)
  list(APPEND stb_flags -ftrivial-auto-var-init=zero ${twice})
else()
  message(FATAL_ERROR "this compiler cannot zero variables: images with a faulty palette would show its memory")
endif()
