#pragma once
// Variables of the environment that choose an OpenGL driver, or say what it pretends to be.

#include <map>
#include <string>
#include <vector>

namespace refraster {

/// Those that are set, as "NAME=value", sorted; of an empty list of `environment`, terminated by null as environ is,
/// none. `ignored` are names that this program has set itself.
std::vector<std::string> driver_variables(const char* const* environment, const std::vector<std::string>& ignored);

/// Sets variables, by name, for this process, so that its driver draws as they say. Before the first context: drivers
/// read them once a process.
void enter_environment(const std::map<std::string, std::string>& variables);

/// What to do where no driver starts: look at those variables if there are any, else install one.
std::string advice(const std::vector<std::string>& variables);

} // namespace refraster
