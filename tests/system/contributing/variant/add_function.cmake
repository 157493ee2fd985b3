# cmake -DROOT=... -DBLOCK=... -DOUT=... -P add_function.cmake: does what CONTRIBUTING.md asks of one who adds a fragment
# function to the library, steps 1 to 3, with the header of that page (BLOCK), in copies of the lists below OUT.

# substitute(FILE FROM TO STEP): OUT/FILE is ROOT/FILE with the first match of FROM replaced by TO.
function(substitute file from to step)
  file(READ ${ROOT}/${file} text)
  string(REGEX MATCH "${from}" found "${text}")
  if(found STREQUAL "")
    message(FATAL_ERROR "CONTRIBUTING.md, step ${step}: ${file} has no \"${from}\"")
  endif()
  string(FIND "${text}" "${found}" begin)
  string(LENGTH "${found}" length)
  math(EXPR end "${begin} + ${length}")
  string(SUBSTRING "${text}" 0 ${begin} before)
  string(SUBSTRING "${text}" ${end} -1 after)
  string(REPLACE "@FOUND@" "${found}" by "${to}")
  file(CONFIGURE OUTPUT ${OUT}/${file} CONTENT "${before}${by}${after}" @ONLY)
endfunction()

file(READ ${BLOCK} block)
string(REGEX MATCH "///[^\n]*\n(///[^\n]*\n)*struct Minnaert {.*\n};\n" parameters "${block}")
string(REGEX MATCH "template <Number T>.*\n}\n" formulas "${block}")
if(parameters STREQUAL "" OR formulas STREQUAL "")
  message(FATAL_ERROR "CONTRIBUTING.md: the header has no struct Minnaert, or no formulas")
endif()

# 1. The struct, and its name into the list.
substitute(include/refraster/material.h "/// Every fragment function of the library.*using FragmentFunction = std::variant<[A-Za-z, ]*"
  "${parameters}\n@FOUND@, Minnaert" 1)
# 2. The formulas.
file(CONFIGURE OUTPUT ${OUT}/shading/minnaert.h @ONLY CONTENT "#pragma once

#include \"math/elementary.h\"
#include \"shading/fragment.h\"

namespace refraster::inline REFRASTER_KIT {

${formulas}
} // namespace refraster::inline REFRASTER_KIT
")
substitute(shading/fragment_functions.h "#include \"shading/merl.h\"\n" "@FOUND@#include \"shading/minnaert.h\"\n" 2)
# 3. One for the laws.
substitute(tests/unit/shading/laws.h "    return list;" "    list.push_back({\"minnaert\", Minnaert{}});\n@FOUND@" 3)
