// refraster explain SCENE X Y

#include <refraster/files.h>
#include <refraster/notes.h>
#include <refraster/render.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/diagnostics.h"
#include "app/memory_limit.h"
#include "app/options/picture_options.h"
#include "app/options/scene_options.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "io/scene/scene_source.h"
#include "verify/device/read_profile.h"
#include "verify/explain/bounds_story.h"
#include "verify/explain/explain_pixel.h"
#include "verify/explain/story_json.h"
#include "verify/explain/story_text.h"
#include "verify/images/actual_pixel.h"

#include <iostream>
#include <memory>
#include <optional>

namespace refraster {
namespace {

struct ExplainArguments {
  std::string device, scene, actual, layer, json;
  int x = 0, y = 0;
  PictureArguments picture; // of the size, by default the actual image's
  int lights = 3;
  SceneOptions reading;
  SceneChanges changes;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
};

/// Throws UsageError for a pixel that the image does not have.
void check_pixel(const ExplainArguments& arguments, const Size& size) {
  const auto check = [](const char* name, int found, int count, const char* what) {
    if (found >= count)
      throw UsageError(name, std::to_string(found),
                       "0 to " + std::to_string(count - 1) + ", in an image " + std::to_string(count) + " pixels " +
                           what);
  };
  check("X", arguments.x, size.width, "wide");
  check("Y", arguments.y, size.height, "high");
}

ExitCode run(const ExplainArguments& arguments) {
  check_different({arguments.json}, {arguments.scene, arguments.actual});
  if (!arguments.json.empty()) check_writable(arguments.json);
  prepare_cache(arguments.reading.mesh_cache);
  NoteList notes;
  std::optional<ColourImage> actual;
  if (!arguments.actual.empty())
    actual = read_actual_image(arguments.actual, arguments.layer, arguments.reading.memory, notes);
  PictureArguments asked = arguments.picture;
  if (actual) {
    const Size its{actual->colour.width, actual->colour.height};
    const Size size = asked.size.value_or(its);
    if (size != its)
      throw UsageError("--size", std::to_string(size.width) + "x" + std::to_string(size.height),
                       "the size of " + arguments.actual + ", " + std::to_string(its.width) + "x" +
                           std::to_string(its.height));
    asked.size = size;
    check_pixel(arguments, size);
  }

  auto line = progress_line(arguments.diagnostics, "reading " + arguments.scene);
  SceneOptions reading = arguments.reading;
  reading.notes = &notes;
  SceneSource source = read_scene_source(arguments.scene, reading, arguments.changes.edits());
  Picture picture = asked.over(source.view.picture);
  // Floats hold linear values, unless they are said not to.
  if (actual && actual->full_scale == 1) picture.transfer = asked.transfer.value_or(Transfer::linear);
  const Scene scene = std::move(source).placed(picture.width, picture.height);
  line.reset(); // before anything is printed
  print_file_notes(notes, arguments.diagnostics);
  check_pixel(arguments, {picture.width, picture.height});
  const ExplainRequest request{arguments.x,     arguments.y,      picture.width,           picture.height,
                               picture.samples, picture.transfer, arguments.reading.memory};
  PixelStory story = explain_pixel(
      scene, request, actual ? std::optional(actual_pixel(*actual, arguments.x, arguments.y)) : std::nullopt);
  story.scene = arguments.scene;
  if (!arguments.device.empty()) story.bounds = bounds_story(scene, request, device_profile(arguments.device));
  if (!arguments.json.empty()) write_text(arguments.json, story_json(story));
  if (arguments.json != standard_output) // which then holds the JSON and nothing else
    std::cout << story_text(story, {.lights = static_cast<std::size_t>(arguments.lights)});
  return ExitCode::ok;
}

} // namespace

Command explain_command() {
  const auto arguments = std::make_shared<ExplainArguments>();
  ExplainArguments& a = *arguments;
  const Range places{0, double(largest_side - 1)};
  return {.name = "explain",
          .meaning = "Tell how a pixel comes about, from its triangles to its terms",
          .groups = {{"Scene",
                      {scene_argument(a.scene), outside_option(a.reading.outside),
                       exposure_option(a.reading.exposure_stops), shadow_option(a.reading),
                       cache_option(a.reading.mesh_cache)}},
                     {"Pixel",
                      {number_option("X", a.x, places, "column, from the left").required().by_default(""),
                       number_option("Y", a.y, places, "row, from the top").required().by_default(""),
                       size_option(a.picture, "pixels of the image, with --actual those of that image"),
                       samples_option(a.picture, "samples a pixel, at the standard positions"),
                       srgb_option(a.picture, "levels are those of the sRGB curve: shown too, and those of --actual"),
                       linear_option(a.picture)}},
                     scene_change_options(a.changes),
                     {"Another value",
                      {file_option("--actual", "FILE", a.actual,
                                   "image of another renderer (" + readable_formats() +
                                       "): which term would have to be what for its pixel to be right"),
                       text_option("--layer", "NAME", a.layer, "of .exr files: the layer whose R, G and B it has")}},
                     {"Device",
                      {text_option("--device", "NAME|FILE", a.device,
                                   "also what a right device may have at the pixel, and what makes that as wide as it "
                                   "is: one of refraster list devices, or a file of your own")}},
                     {"Report",
                      {number_option("--lights", a.lights, Range{0, 1000000},
                                     "lights described in full: those that give most; all are in the sum"),
                       file_option("--json", "FILE", a.json, "write the numbers as JSON; - is standard output"),
                       memory_option(a.max_memory), strict_option(a.diagnostics), quiet_option(a.diagnostics)}}},
          .notes = {"All numbers are made by the formulas that make the image, and add up to the pixel bit for bit. "
                    "docs/explain.md reads an example."},
          .finish = [arguments]() -> Action {
            if (!arguments->layer.empty() && arguments->actual.empty())
              throw UsageError("--layer", "found no --actual, whose layer it names");
            if (arguments->picture.size) check_pixel(*arguments, *arguments->picture.size);
            return [arguments] {
              arguments->reading.memory = set_memory_limit(arguments->max_memory, 1);
              return run(*arguments);
            };
          }};
}

} // namespace refraster
