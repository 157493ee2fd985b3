# stb_image reads images from strangers, and version 2.27, which Debian 12 has, has faults that are known and were mended
# in 2.28. This makes a copy in the build folder with those mended that reach us: STB_IMAGE_DIR, to be searched first.
# A newer stb_image is copied as it is. What no version mends is met in io/stb.cpp and io/stb_check.cpp, and here by
#   -fwrapv                       coefficients of a corrupt JPEG overflow (nothings/stb issue 1533): defined, and harmless
#   -ftrivial-auto-var-init=zero  palettes and blocks on the stack that a file does not fill (1535, 1595, 1861, 1929)
# What fuzzing found beyond those has a file in tests/fuzz/regressions/image.
file(READ ${STB_INCLUDE_DIR}/stb_image.h stb_image)
if(NOT stb_image MATCHES "stb_image - v([0-9.]+)")
  message(FATAL_ERROR "${STB_INCLUDE_DIR}/stb_image.h does not tell its version")
endif()
set(stb_version ${CMAKE_MATCH_1})
if(stb_version VERSION_LESS 2.27)
  message(FATAL_ERROR "stb_image ${stb_version} is too old: 2.27 is the oldest whose faults are known here")
endif()

# mend(COUNT TEXT ADDITION): adds a line behind each of the COUNT places where the text stands.
function(mend count text addition)
  string(REPLACE "${text}" "${text}\n${addition}" mended "${stb_image}")
  string(LENGTH "${stb_image}" before)
  string(LENGTH "${mended}" after)
  string(LENGTH "${addition}" each)
  math(EXPR expected "${before} + ${count} * (${each} + 1)")
  if(NOT after EQUAL expected)
    message(FATAL_ERROR "stb_image ${stb_version} is not the one that is to be mended, at: ${text}")
  endif()
  set(stb_image "${mended}" PARENT_SCOPE)
endfunction()

if(stb_version VERSION_LESS 2.28)
  # JPEG: a Huffman table with more than 256 codes is written past its end (issues 1289, 1291).
  mend(1 "               n += sizes[i];\n            }"
    "            if (n > 256) return stbi__err(\"more than 256 codes\", \"Corrupt JPEG\");")
  # A code that the table does not have is looked up beside it.
  mend(1 "   c = ((j->code_buffer >> (32 - k)) & stbi__bmask[k]) + h->delta[k];"
    "   if (c < 0 || c > 255) return -1;")
  # Where the bits of a scan end early, their number falls below 0, and is shifted by.
  mend(2 "   if (j->code_bits < n) stbi__grow_buffer_unsafe(j);" "   if (j->code_bits < n) return 0;")
  mend(1 "   if (j->code_bits < 1) stbi__grow_buffer_unsafe(j);" "   if (j->code_bits < 1) return 0;")
  mend(2 "s = r & 15; // combined length" "if (s > j->code_bits) return stbi__err(\"bits end early\", \"Corrupt JPEG\");")
  # PNG: codes that deflate does not have stand for distance 0, which is memory not yet written.
  mend(1 "         z = stbi__zhuffman_decode(a, &a->z_distance);"
    "         if (z >= 30) return stbi__err(\"bad distance\", \"Corrupt PNG\");")
endif()

set(STB_IMAGE_DIR ${PROJECT_BINARY_DIR}/stb)
set(written "")
if(EXISTS ${STB_IMAGE_DIR}/stb_image.h)
  file(READ ${STB_IMAGE_DIR}/stb_image.h written)
endif()
if(NOT written STREQUAL stb_image)
  file(WRITE ${STB_IMAGE_DIR}/stb_image.h "${stb_image}")
endif()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${STB_INCLUDE_DIR}/stb_image.h)

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
