#include "app/view/snapshot.h"

#include "app/options/completions/completions.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace refraster {
namespace {
namespace fs = std::filesystem;

constexpr std::string_view camera_pointer = "/scene/camera";

std::string three(const Double3& v) {
  return "[" + json_number(v.x) + ", " + json_number(v.y) + ", " + json_number(v.z) + "]";
}

/// Whether it changes the camera, which the picture has another one for.
bool is_of_camera(const SceneEdit& edit) {
  return edit.pointer == camera_pointer || edit.pointer.starts_with(std::string(camera_pointer) + "/");
}

/// In quotes where a shell needs them.
std::string shell_word(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:+@%";
  return !word.empty() && word.find_first_not_of(plain) == std::string::npos ? word : shell_quoted(word);
}

} // namespace

SnapshotFiles unused_files(const FrameNames& names) {
  for (std::size_t i = 0;; ++i) {
    const std::string image = names.name(i), stem = fs::path(image).replace_extension().string();
    SnapshotFiles files{image, stem + ".camera.json", stem + ".sh"};
    const auto is_free = [](const std::string& path) { return !fs::exists(fs::symlink_status(path)); };
    if (is_free(files.image) && is_free(files.camera) && is_free(files.script)) return files;
  }
}

std::string camera_json(const Camera& camera) {
  const auto& [position, target, up, fov_y, near, far] = camera;
  return R"({"position": )" + three(position) + R"(, "target": )" + three(target) + R"(, "up": )" + three(up) +
         R"(, "fov_y": )" + json_number(fov_y) + R"(, "near": )" + json_number(near) + R"(, "far": )" +
         json_number(far) + "}";
}

std::vector<std::string> render_words(const std::string& program, const PictureRun& run,
                                      const std::vector<SceneEdit>& edits, const Camera& camera) {
  std::vector<std::string> words = {program,
                                    "render",
                                    run.scene,
                                    "--size",
                                    std::to_string(run.size.width) + "x" + std::to_string(run.size.height),
                                    "--samples",
                                    std::to_string(run.samples),
                                    run.transfer == Transfer::srgb ? "--srgb" : "--linear",
                                    "--precision",
                                    run.precision};
  const auto add = [&](std::string option, std::string value) {
    words.push_back(std::move(option)), words.push_back(std::move(value));
  };
  if (run.reading.outside == Outside::allowed) words.push_back("--allow-outside");
  if (run.reading.exposure_stops != 0) add("--exposure", json_number(run.reading.exposure_stops));
  for (const Aov aov : run.files.aovs) add("--aov", std::string(kind_of(aov).name));
  for (const std::vector<SceneEdit>& some : {run.changes.edits(), edits})
    for (const SceneEdit& edit : some)
      if (!is_of_camera(edit)) add("--set", edit.pointer + "=" + edit.value);
  add("--set", std::string(camera_pointer) + "=" + camera_json(camera));
  add("--output", run.output);
  return words;
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
  return line;
}

std::string shell_script(const std::vector<std::string>& words, const std::string& folder) {
  std::string command;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const bool begins = words[i].starts_with("--");
    command += (i == 0 ? "" : begins ? " \\\n  " : " ") + shell_word(words[i]);
  }
  return "#!/bin/sh\n# Makes the picture again that refraster view wrote, or, with a name as its argument, under that "
         "name.\ncd " +
         shell_word(folder) + " || exit\nimage=" + shell_word(words.back()) + "\nexec " + command +
         " \"${1:-$image}\"\n";
}

} // namespace refraster
