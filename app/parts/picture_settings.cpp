#include "app/parts/picture_settings.h"

#include "app/options/option.h"
#include "app/turntable/scene_digest.h"
#include "io/file/build_info.h"
#include "io/file/sha256.h"
#include "io/json/json_writer.h"

#include <algorithm>

namespace refraster {
namespace {

constexpr std::string_view yes = "yes", no = "no";

std::string_view yes_or_no(bool flag) {
  return flag ? yes : no;
}

std::string cameras_digest(const std::vector<Camera>& cameras) {
  JsonWriter json;
  json.array([&] {
    for (const Camera& camera : cameras) {
      const auto& [position, target, up, fov_y, near, far] = camera;
      json.value(std::vector<double>{position.x, position.y, position.z, target.x, target.y, target.z, up.x, up.y, up.z,
                                     fov_y, near, far});
    }
  });
  return text_sha256(json.text());
}

/// Which lights move with the camera.
std::string moving_lights(const SceneView& view) {
  std::string text;
  for (const std::size_t i : view.moving_point_lights) text += "point " + std::to_string(i) + " ";
  for (const std::size_t i : view.moving_direction_lights) text += "direction " + std::to_string(i) + " ";
  return text;
}

[[noreturn]] void refuse_setting(const std::string& path, std::string_view name, std::string_view found) {
  throw InputError(InputFault{path, 0, 0, std::string(name), "\"" + std::string(found) + "\"",
                              "what this version of refraster writes there"});
}

} // namespace

Settings picture_settings(const PictureRun& run, const SceneSource& source, const std::vector<Camera>& cameras) {
  std::string aovs;
  for (const Aov aov : run.files.aovs) aovs += (aovs.empty() ? "" : ",") + std::string(kind_of(aov).name);
  return {{"version", this_build().version},
          {"scene", scene_digest(run.scene, source.scene)},
          {"lights of the camera", moving_lights(source.view)},
          {"cameras", cameras_digest(cameras)},
          {"size", std::to_string(run.size.width) + "x" + std::to_string(run.size.height)},
          {"samples", std::to_string(run.samples)},
          {"precision", run.precision},
          {"srgb", std::string(yes_or_no(run.transfer == Transfer::srgb))},
          {"bits", std::to_string(run.files.bits)},
          {"quality", std::to_string(run.files.jpeg_quality)},
          {"transparent", std::string(yes_or_no(run.files.background == Background::transparent))},
          {"aov", aovs},
          {"aov-filter", std::string(name_of(run.files.aov_filter))},
          {"aov-format", run.files.aov_format},
          {"layers", std::string(yes_or_no(run.files.aov_place == AovPlace::layers))}};
}

void take_file_settings(const std::string& path, const Settings& settings, FrameFiles& files, Transfer& transfer) {
  const auto value = [&](std::string_view name) {
    const std::optional<std::string_view> found = setting(settings, name);
    if (!found) refuse_setting(path, name, "");
    return *found;
  };
  const auto flag = [&](std::string_view name) {
    const std::string_view word = value(name);
    if (word != yes && word != no) refuse_setting(path, name, word);
    return word == yes;
  };
  const auto number = [&](std::string_view name, int least, int most) {
    const std::optional<int> found = number_from<int>(value(name));
    if (!found || *found < least || *found > most) refuse_setting(path, name, value(name));
    return *found;
  };
  transfer = flag("srgb") ? Transfer::srgb : Transfer::linear;
  files.bits = number("bits", 0, 32);
  files.jpeg_quality = number("quality", 1, 100);
  files.background = flag("transparent") ? Background::transparent : Background::blended;
  files.aov_place = flag("layers") ? AovPlace::layers : AovPlace::beside;
  files.aov_format = value("aov-format");
  if (!files.aov_format.empty()) {
    const std::vector<std::string> formats = aov_formats();
    if (std::find(formats.begin(), formats.end(), files.aov_format) == formats.end())
      refuse_setting(path, "aov-format", files.aov_format);
  }
  files.aovs.clear();
  if (const std::string_view names = value("aov"); !names.empty())
    for (const std::string_view name : split(names, ',')) {
      const auto kind = std::find_if(std::begin(aov_kinds), std::end(aov_kinds),
                                     [&](const AovKind& one) { return one.name == name; });
      if (kind == std::end(aov_kinds)) refuse_setting(path, "aov", name);
      files.aovs.push_back(static_cast<Aov>(kind - std::begin(aov_kinds)));
    }
}

} // namespace refraster
