#pragma once
// Variables of the environment that choose an OpenGL driver, or say what it pretends to be.

#include <string>
#include <vector>

namespace refraster {

/// Those that are set, as "NAME=value", sorted; of an empty list of `environment`, terminated by null as environ is,
/// none. `ignored` are names that this program has set itself.
std::vector<std::string> driver_variables(const char* const* environment, const std::vector<std::string>& ignored);

/// What to do where no driver starts: look at those variables if there are any, else install one.
std::string advice(const std::vector<std::string>& variables);

} // namespace refraster
