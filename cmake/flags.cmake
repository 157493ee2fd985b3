# Sets of flags, each an interface target; never in CMAKE_CXX_FLAGS.

# Strict floating point: the same source gives the same bits in every lane count, optimisation level and compiler. All
# that compiles formulas needs it, also outside this build: the fragment kit exports it.
#   -ffp-contract=off         a*b+c is two roundings everywhere, not one where the machine has FMA
#   -fno-tree-slp-vectorize   GCC 12 drops double > float > double roundings in that pass (tests/unit/math: "narrowing is kept")
#   -fno-math-errno, -fno-trapping-math   change no value; sqrt becomes one instruction, selects become blends
#   -Wno-psabi                vectors wider than the baseline's registers have no stable ABI; none crosses a library border
add_library(refraster_strict_fp INTERFACE)
add_library(refraster::strict_fp ALIAS refraster_strict_fp)
set_target_properties(refraster_strict_fp PROPERTIES EXPORT_NAME strict_fp)
target_compile_options(refraster_strict_fp INTERFACE
  -ffp-contract=off -fno-fast-math -fno-math-errno -fno-trapping-math -Wno-psabi
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)

# How this code base itself is compiled. Nothing of it reaches who uses the libraries: their layouts do not depend on it.
add_library(refraster_build_flags INTERFACE)
target_link_libraries(refraster_build_flags INTERFACE refraster_strict_fp)
target_compile_options(refraster_build_flags INTERFACE
  $<$<BOOL:${REFRASTER_ISA}>:-march=${REFRASTER_ISA}>
  -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Wno-psabi
  # GCC 12 sees an overlap in "literal" + std::string at -O3 that is not there (GCC bug 105651).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  # Formulas join the masks of any number by & and |; those of numbers without lanes are bool.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>
  # From 18 on, clang tells of what libstdc++ 12 itself calls in std::stable_sort (LLVM issue 76515). What is deprecated
  # elsewhere, the other compilers tell.
  $<$<AND:$<CXX_COMPILER_ID:Clang>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,18>>:-Wno-deprecated-declarations>)
if(REFRASTER_WERROR)
  target_compile_options(refraster_build_flags INTERFACE -Werror)
endif()
