#pragma once
// The build that a report names.

#include <string>

namespace refraster {

/// The build of this program, as its compiler saw it.
struct BuildInfo {
  std::string version;  // of refraster: "0.1.0"
  std::string compiler; // "g++ 12.2.0"
  std::string type;     // CMake's: "Release"
  std::string march;    // what the build asked for: "native"
  std::string isa;      // what that means here: "x86-64-v4"
  std::string flags;    // of the compiler, for all that makes pixels
};
BuildInfo this_build();

} // namespace refraster
