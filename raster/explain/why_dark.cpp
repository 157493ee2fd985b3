#include "raster/explain/why_dark.h"

#include "shading/light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <tuple>
#include <vector>

namespace refraster {
namespace {

double brightest(const Double3& rgb) {
  return std::max({rgb.x, rgb.y, rgb.z});
}

/// A light and whether it shines on the side of a surface that its normal points to, anywhere.
template <class Light>
struct Tried {
  Light light;
  bool reaches = false;
};

/// What the pixels that show a surface say.
struct Findings {
  std::uint64_t pixels = 0;
  std::uint64_t seen_from_behind = 0;     // the normal points away from the eye
  std::uint64_t measured_from_behind = 0; // and a measured BRDF is 0 there
  std::uint64_t without_normal = 0;
  std::vector<bool> objects; // that are seen
  std::size_t lights = 0, behind = 0;
  double arriving = 0; // the greatest sum of <n.l> C over all lights, C radiance times attenuation
};

/// The normal and position of a pixel are rounded to float: n by at most 2^-24 a component of a unit vector, the
/// position by 2^-24 of its size, which turns l by that over the distance. An n.l no larger than both may be 0.
bool is_above_horizon(double n_l, const Double3& position, double distance) {
  constexpr double float_rounding = 0x1p-24, components = 3;
  return n_l > components * float_rounding * (1 + length(position) / distance);
}

double distance_to(const auto& light, const Double3& position) {
  if constexpr (requires { light.position; }) return length(light.position - position);
  else return std::numeric_limits<double>::infinity();
}

template <class Light>
void shine(std::vector<Tried<Light>>& lights, const Fragment<double>& at, Double3& arriving_here) {
  for (Tried<Light>& tried : lights) {
    const Incident<double> incident = arriving(tried.light, at);
    const double n_l = dot(at.normal, incident.direction);
    if (!is_above_horizon(n_l, at.position, distance_to(tried.light, at.position))) continue;
    tried.reaches = true;
    arriving_here += incident.radiance * n_l;
  }
}

template <class Light>
auto lights_to_try(const std::vector<Light>& lights) {
  std::vector<Tried<decltype(prepared_light(lights.front()))>> shining;
  for (const Light& light : lights)
    if (brightest(light.radiance) > 0) shining.push_back({prepared_light(light)});
  return shining;
}

bool is_measured(const Object& object) {
  bool all = true;
  for_each_material(object, [&](const Material& material) { all = all && material.measured(); });
  return all;
}

Findings findings(const Scene& scene, const Frame& frame) {
  const std::vector<float>& objects = frame.aovs[0].values;
  const auto three = [](const Image<float>& image, std::size_t pixel) {
    const float* const at = &image.values[3 * pixel];
    return Double3(Float3(at[0], at[1], at[2]));
  };
  auto lights = std::apply([&](auto... list) { return std::tuple(lights_to_try(scene.*list)...); }, light_lists);
  const auto for_each_list = [&](const auto& visit) { std::apply([&](auto&... list) { (visit(list), ...); }, lights); };
  Findings found;
  for_each_list([&](const auto& tried) { found.lights += tried.size(); });
  found.objects.resize(scene.objects.size());
  // A second or so of work at most.
  constexpr std::size_t max_pairs = std::size_t{1} << 25;
  const std::size_t step = 1 + objects.size() * found.lights / max_pairs;
  for (std::size_t pixel = 0; pixel < objects.size(); pixel += step) {
    if (objects[pixel] == 0) continue;
    const auto object = static_cast<std::size_t>(objects[pixel]) - 1;
    ++found.pixels;
    found.objects[object] = true;
    const Double3 position = three(frame.aovs[1], pixel), normal = three(frame.aovs[2], pixel);
    const Fragment<double> at{position, normal, normalize(scene.camera.position - position), Double3(1), nullptr};
    if (squared_length(normal) == 0) ++found.without_normal;
    const bool from_behind = dot(normal, at.to_eye) < 0;
    if (from_behind) ++found.seen_from_behind;
    Double3 arriving_here(0);
    for_each_list([&](auto& tried) { shine(tried, at, arriving_here); });
    if (from_behind && is_measured(scene.objects[object])) {
      ++found.measured_from_behind;
      continue; // whatever arrives
    }
    found.arriving = std::max(found.arriving, brightest(arriving_here));
  }
  for_each_list([&](const auto& tried) {
    found.behind +=
        static_cast<std::size_t>(std::count_if(tried.begin(), tried.end(), [](auto& t) { return !t.reaches; }));
  });
  return found;
}

/// What a measured table lets be seen.
enum class TableContent { something, zeros, never_measured };

TableContent content_of(const MerlTable& table) {
  bool any_measured = false;
  const double* const values = table.values<double>();
  for (std::size_t i = 0; i < 3 * MerlTable::samples; i += 3) {
    const Double3 rgb(values[i], values[i + 1], values[i + 2]);
    if (std::min({rgb.x, rgb.y, rgb.z}) < 0) continue;
    any_measured = true;
    if (brightest(rgb) > 0) return TableContent::something;
  }
  return any_measured ? TableContent::zeros : TableContent::never_measured;
}

/// Calls visit(function) with the fragment function of each material of objects that are seen.
template <class Visit>
void for_each_seen(const Scene& scene, const Findings& found, const Visit& visit) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (found.objects[i])
      for_each_material(scene.objects[i], [&](const Material& material) {
        if (material.user_function) visit(*material.user_function);
        else std::visit(visit, material.fragment_function);
      });
}

/// What is wrong with the tables, if all objects that are seen are measured and no table holds any light.
std::string about_tables(const Scene& scene, const Findings& found) {
  std::vector<const MerlTable*> tables; // each once
  bool all_measured = true;
  for_each_seen(scene, found, [&]<class SomeFunction>(const SomeFunction& function) {
    if constexpr (std::is_same_v<SomeFunction, Merl>) {
      if (std::find(tables.begin(), tables.end(), function.table.get()) == tables.end())
        tables.push_back(function.table.get());
    } else {
      all_measured = false;
    }
  });
  if (!all_measured) return {};
  bool any_zeros = false;
  for (const MerlTable* const table : tables) {
    const TableContent content = content_of(*table);
    if (content == TableContent::something) return {};
    any_zeros |= content == TableContent::zeros;
  }
  const std::string which = tables.size() == 1 ? "the table has " : "the tables have ";
  return which + (any_zeros ? "no sample above 0" : "no measured sample");
}

bool any_ambient(const Scene& scene, const Findings& found) {
  bool any = false;
  for_each_seen(scene, found, [&](const auto& function) {
    if constexpr (requires { function.ka; }) any |= brightest(function.ka) > 0;
  });
  return any;
}

/// Whether no fragment function that is seen reflects anything, by its own parameters.
bool all_black(const Scene& scene, const Findings& found) {
  bool black = true;
  for_each_seen(scene, found, [&](const auto& function) {
    if constexpr (requires { function.kd + function.ks; })
      black &= brightest(function.kd) == 0 && brightest(function.ks) == 0;
    else black = false;
  });
  return black;
}

std::string two_digits(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

/// "the only light is", "both lights are", "all 3 lights are".
std::string all_lights(std::size_t lights, const std::string& verb_of_one, const std::string& verb) {
  if (lights == 1) return "the only light " + verb_of_one;
  return (lights == 2 ? "both" : "all " + std::to_string(lights)) + " lights " + verb;
}

} // namespace

std::string why_dark(const Scene& scene, const Frame& frame, double white_is_dark) {
  const Findings found = findings(scene, frame);
  if (found.pixels == 0) return {};
  const std::size_t in_scene = light_count(scene);
  const std::string ambient = any_ambient(scene, found) ? ", only ambient reflection (ka)" : " and ambient is 0";
  if (in_scene == 0) return "the scene has no light" + ambient;
  if (found.lights == 0) return all_lights(in_scene, "has", "have") + " radiance 0";
  if (const std::string tables = about_tables(scene, found); !tables.empty()) return tables;
  if (found.without_normal == found.pixels) return "what is seen has no normal";
  if (all_black(scene, found)) return "what is seen reflects no light: kd and ks are 0";
  const std::string behind = found.lights < in_scene ? " or have radiance 0" : "";
  const std::string turned =
      found.seen_from_behind == found.pixels ? "; its normals point away from the camera" : std::string();
  if (found.behind == found.lights)
    return "no light reaches what is seen: " + all_lights(in_scene, "is", "are") + " behind it" + behind + turned;
  if (found.measured_from_behind == found.pixels)
    return "the normals of what is seen point away from the camera, and a measured BRDF is 0 on that side";
  const std::string some_behind = found.behind == 0
                                      ? ""
                                      : "; " + std::to_string(found.behind) + " of " + std::to_string(found.lights) +
                                            (found.behind == 1 ? " lights is behind it" : " lights are behind it");
  if (found.arriving <= white_is_dark)
    return "little light reaches what is seen, " + two_digits(found.arriving) +
           " at most (radiance times attenuation times n.l)" + some_behind + turned;
  return "what is seen reflects little of the light that arrives, which is up to " + two_digits(found.arriving) +
         " (radiance times attenuation times n.l)" + turned;
}

} // namespace refraster
