#include "verify/gl/driver_environment.h"

#include <algorithm>
#include <string_view>

namespace refraster {
namespace {

// Of Mesa (docs.mesa3d.org/envvars.html), of libglvnd, which finds EGL's drivers, and of the drivers' own loaders.
constexpr std::string_view prefixes[] = {
    "MESA_", "LIBGL_", "GALLIUM_",  "EGL_",  "__EGL_",           "__GLVND_",        "GBM_",
    "DRI_",  "LP_",    "SOFTPIPE_", "ZINK_", "VK_ICD_FILENAMES", "VK_DRIVER_FILES", "__NV_PRIME_"};

} // namespace

std::vector<std::string> driver_variables(const char* const* environment, const std::vector<std::string>& ignored) {
  std::vector<std::string> found;
  for (; environment && *environment; ++environment) {
    const std::string_view variable(*environment);
    const std::string_view name = variable.substr(0, variable.find('='));
    const bool chooses = std::any_of(std::begin(prefixes), std::end(prefixes),
                                     [&](std::string_view prefix) { return name.starts_with(prefix); });
    if (chooses && std::find(ignored.begin(), ignored.end(), name) == ignored.end()) found.emplace_back(variable);
  }
  std::sort(found.begin(), found.end());
  return found;
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
