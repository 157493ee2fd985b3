#include "gl/context/driver_environment.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <string_view>

namespace refraster {
namespace {

// Of Mesa (docs.mesa3d.org/envvars.html), of libglvnd, which finds EGL's drivers, and of the drivers' own loaders.
constexpr std::string_view prefixes[] = {"MESA_",           "LIBGL_",     "GALLIUM_", "EGL_",
                                         "__EGL_",          "__GLVND_",   "GBM_",     "VK_ICD_FILENAMES",
                                         "VK_DRIVER_FILES", "__NV_PRIME_"};
// With these words in the name they choose nothing, but what is written down.
constexpr std::string_view harmless[] = {"DEBUG", "CACHE", "LOG"};

bool chooses_driver(std::string_view name) {
  return std::any_of(std::begin(prefixes), std::end(prefixes),
                     [&](std::string_view prefix) { return name.starts_with(prefix); }) &&
         std::none_of(std::begin(harmless), std::end(harmless),
                      [&](std::string_view word) { return name.find(word) != std::string_view::npos; });
}

} // namespace

std::vector<std::string> driver_variables(const char* const* environment, const std::vector<std::string>& ignored) {
  std::vector<std::string> found;
  for (; environment && *environment; ++environment) {
    const std::string_view variable(*environment);
    const std::string_view name = variable.substr(0, variable.find('='));
    if (chooses_driver(name) && std::find(ignored.begin(), ignored.end(), name) == ignored.end())
      found.emplace_back(variable);
  }
  std::sort(found.begin(), found.end());
  return found;
}

void enter_environment(const std::map<std::string, std::string>& variables) {
  for (const auto& [name, value] : variables) setenv(name.c_str(), value.c_str(), 1);
}

std::string advice(const std::vector<std::string>& variables) {
  if (variables.empty())
    return "install an OpenGL driver: Mesa's software drivers are in the Debian packages libegl1 and libgl1-mesa-dri";
  std::string list;
  for (const std::string& variable : variables) list += (list.empty() ? "" : ", ") + variable;
  return "the environment chooses the driver: try again with " + std::string(variables.size() == 1 ? "this" : "these") +
         " unset: " + list;
}

} // namespace refraster
