// refraster.compare, verify, explain: the JSON of the program's reports, as dictionaries.

#include "python/arrays.h"
#include "python/scene/scenes.h"
#include "python/work.h"
#include "raster/samples.h"
#include "suite/judging/verify_scene.h"
#include "verify/compare/compare_files.h"
#include "verify/device/read_profile.h"
#include "verify/explain/bounds_story.h"
#include "verify/explain/story_json.h"
#include "verify/images/actual_pixel.h"

#include <optional>
#include <utility>

namespace refraster::python {
namespace {

constexpr const char* made_in_python = "made in Python";

std::string text_argument(const std::string& place, const py::object& given) {
  std::string text;
  read_optional(place, given, Range{}, text);
  return text;
}

/// A limit, if it is given.
std::optional<double> limit_argument(const std::string& place, const py::object& given) {
  std::optional<double> limit;
  if (!given.is_none()) read_argument(place, given, Range{}, limit.emplace());
  return limit;
}

/// None, "ignore", "compare", or a colour (r, g, b) that images are laid over.
void read_alpha(const py::object& given, bool may_compare, AlphaUse& use, std::array<double, 3>& background) {
  if (given.is_none()) return;
  if (py::isinstance<py::str>(given)) {
    const auto word = py::cast<std::string>(given);
    if (word == "ignore") use = AlphaUse::ignored;
    else if (word == "compare" && may_compare) use = AlphaUse::compared;
    else
      refuse_argument("alpha", given, may_compare ? "\"ignore\", \"compare\" or (r, g, b)" : "\"ignore\" or (r, g, b)");
    return;
  }
  Double3 colour;
  read_argument("alpha", given, Range{}, colour);
  use = AlphaUse::composited, background = {colour.x, colour.y, colour.z};
}

void read_premultiplied(const py::object& given, AlphaEncoding& encoding) {
  if (given.is_none()) return;
  if (!py::isinstance<py::bool_>(given)) refuse_argument("premultiplied", given, "True, False or None");
  encoding = py::cast<bool>(given) ? AlphaEncoding::premultiplied : AlphaEncoding::straight;
}

StoredPrecision precision_of(const ArrayImage& image) {
  return image.full_scale == 1 ? StoredPrecision::floats(0x1p-24) : StoredPrecision::integers(image.full_scale);
}

/// Two arrays as two files would be read.
ImagePair pair_of(const py::object& a, const py::object& b) {
  const std::vector<int> channels = {1, 2, 3, 4};
  ArrayImage image_a = image_argument("a", a, channels), image_b = image_argument("b", b, channels);
  if (image_a.full_scale != image_b.full_scale || image_a.values.width != image_b.values.width ||
      image_a.values.height != image_b.values.height || image_a.values.channels != image_b.values.channels)
    refuse_argument("b", b, "the shape and the kind of numbers of a, " + found_text(a));
  ImagePair pair;
  pair.precision_a = precision_of(image_a), pair.precision_b = precision_of(image_b);
  pair.full_scale = image_a.full_scale;
  pair.a = std::move(image_a.values), pair.b = std::move(image_b.values);
  return pair;
}

struct CompareArguments {
  py::object max_abs, max_rms, max_count, unit, alpha, premultiplied, layer, scene;
  bool flip, allow_outside;
};

py::object compare_images(const py::object& a, const py::object& b, const CompareArguments& given) {
  CompareRequest request;
  const std::vector<std::size_t> unit = words_argument("unit", given.unit, {"levels", "values"});
  if (unit.size() != 1) refuse_argument("unit", given.unit, "\"levels\" or \"values\"");
  request.unit = unit.front() == 0 ? CompareUnit::levels : CompareUnit::values;
  request.limits.max_abs = limit_argument("max_abs", given.max_abs);
  request.limits.max_rms = limit_argument("max_rms", given.max_rms);
  if (!given.max_count.is_none())
    request.limits.max_count = static_cast<std::uint64_t>(
        whole_number("max_count", given.max_count, 0, std::numeric_limits<int>::max(), "a whole number >= 0"));
  read_alpha(given.alpha, true, request.pair.alpha, request.pair.background);
  read_premultiplied(given.premultiplied, request.pair.encoding);
  request.pair.layer = text_argument("layer", given.layer);
  SceneOptions reading;
  reading.outside = given.allow_outside ? Outside::allowed : Outside::refused;
  if (!given.scene.is_none()) request.scene = path_argument("scene", given.scene);
  const bool is_array = py::isinstance<py::array>(a);
  if (is_array != py::isinstance<py::array>(b))
    refuse_argument("b", b, is_array ? "an array, as a is" : "a path, as a is");
  std::optional<ImagePair> pair;
  if (is_array) request.a = "a", request.b = "b", pair = pair_of(a, b);
  else request.a = path_argument("a", a), request.b = path_argument("b", b);
  if (!request.scene.empty()) request.seen = objects_of_scene(request.scene, reading, request.a);
  std::string json;
  run_watched(py::none(), [&](Watch&) {
    FileComparison found = pair ? compare_pair(*std::move(pair), request) : compare_files(request);
    if (given.flip) found.report.mean_flip = flip_of(found);
    json = comparison_json(found.report);
  });
  return dictionary(json);
}

/// A Scene, or one that is read; and what reports call it.
struct GivenScene {
  SceneSource source;
  std::string name;
  bool is_file = false; ///< it is as its file says
};

GivenScene scene_argument(const py::object& given, bool allow_outside, NoteList& notes) {
  GivenScene scene;
  if (py::isinstance<LiveScene>(given)) {
    const auto& live = py::cast<const LiveScene&>(given);
    scene.source = source_of(live);
    scene.name = live.path.empty() ? made_in_python : live.path;
    return scene;
  }
  scene.name = path_argument("scene", given), scene.is_file = true;
  SceneOptions options;
  options.outside = allow_outside ? Outside::allowed : Outside::refused;
  options.notes = &notes;
  run_watched(py::none(), [&](Watch&) { scene.source = read_scene_source(scene.name, options); });
  return scene;
}

/// What a report is asked of a picture, over what the scene says.
void read_picture(const py::object& size, const py::object& samples, const py::object& srgb, Picture& picture) {
  if (!size.is_none()) std::tie(picture.width, picture.height) = size_argument("size", size);
  if (!samples.is_none()) {
    const std::string expected = expected_value(SampleCount{picture.samples}, Range{});
    picture.samples = whole_number("samples", samples, 1, 16, expected);
    if (!is_sample_count(picture.samples)) refuse_argument("samples", samples, expected);
  }
  read_optional("srgb", srgb, Range{}, picture.transfer);
}

struct VerifyArguments {
  py::object device, matrices, samples, srgb, ids, depth, layer, alpha, premultiplied, fail_on;
  bool flip_y, allow_outside;
};

std::vector<ClassLimit> class_limits(const py::object& given) {
  std::vector<ClassLimit> limits;
  if (given.is_none()) return limits;
  if (!py::isinstance<py::dict>(given))
    refuse_argument("fail_on", given, "a dictionary of counts by classes of pixels");
  std::vector<std::string_view> classes;
  for (const auto& [value, name] : EnumNames<PixelClass>::names)
    if (value != PixelClass::exact) classes.push_back(name);
  for (const auto& [name, most] : py::reinterpret_borrow<py::dict>(given)) {
    const std::size_t index = words_argument("fail_on", name, classes).at(0);
    const int count = whole_number("fail_on[\"" + std::string(classes[index]) + "\"]", most, 0,
                                   std::numeric_limits<int>::max(), "a whole number >= 0");
    limits.push_back({value_named<PixelClass>(classes[index]).value(), static_cast<std::uint64_t>(count)});
  }
  return limits;
}

/// The image of an array.
DeviceImage device_image(const py::object& actual, const py::object& srgb, const Picture& picture) {
  ArrayImage array = image_argument("actual", actual, {3});
  DeviceImage image;
  image.full_scale = array.full_scale;
  image.precision = precision_of(array);
  image.colour = std::move(array.values);
  if (array.full_scale != 1) image.transfer = picture.transfer; // floats hold linear values
  read_optional("srgb", srgb, Range{}, image.transfer);
  return image;
}

/// How a file is read.
DeviceImageRequest image_request(const VerifyArguments& given) {
  DeviceImageRequest request;
  if (!given.ids.is_none()) request.ids = path_argument("ids", given.ids);
  if (!given.depth.is_none()) request.depth = path_argument("depth", given.depth);
  request.layer = text_argument("layer", given.layer);
  read_alpha(given.alpha, false, request.alpha, request.background);
  read_premultiplied(given.premultiplied, request.encoding);
  request.rows = given.flip_y ? RowOrder::bottom_first : RowOrder::top_first;
  return request;
}

py::object verify_image(const py::object& scene, const py::object& actual, const VerifyArguments& given,
                        const py::object& progress) {
  VerifyTask task;
  task.limits = class_limits(given.fail_on);
  if (!given.device.is_none()) {
    task.device = path_argument("device", given.device);
    device_profile(task.device); // what is wrong with it is said before a scene is read
  }
  NoteList notes;
  GivenScene of = scene_argument(scene, given.allow_outside, notes);
  Picture& picture = of.source.view.picture;
  read_picture(py::none(), given.samples, given.srgb, picture);
  task.scene = of.name, task.origin = of.is_file ? SceneOrigin::file : SceneOrigin::memory;
  task.picture = picture;
  if (!given.srgb.is_none()) task.asked_transfer = picture.transfer;
  if (!given.matrices.is_none())
    task.matrices = words_argument("matrices", given.matrices, {"one", "three"}).at(0) == 0 ? ShaderMatrices::one
                                                                                            : ShaderMatrices::three;
  if (py::isinstance<py::array>(actual)) {
    task.source = JudgedSource::memory, task.actual = "an array";
    task.given = device_image(actual, given.srgb, picture);
  } else {
    task.actual = path_argument("actual", actual);
    task.image = image_request(given);
  }
  std::string json;
  run_watched(progress, [&](Watch& watch) {
    VerifySteps steps;
    steps.progress = watch.reporter();
    json = verdict_json(verify_scene(std::move(task), of.source, std::move(notes), steps).report);
  });
  return dictionary(json);
}

struct ExplainArguments {
  py::object size, samples, srgb, actual, layer, device;
  bool allow_outside;
};

py::object explain(const py::object& scene, const py::object& x, const py::object& y, const ExplainArguments& given) {
  NoteList notes;
  GivenScene of = scene_argument(scene, given.allow_outside, notes);
  Picture& picture = of.source.view.picture;
  read_picture(given.size, given.samples, given.srgb, picture);
  std::optional<ColourImage> actual;
  if (!given.actual.is_none()) {
    actual = read_actual_image(path_argument("actual", given.actual), text_argument("layer", given.layer), {}, notes);
    const int width = actual->colour.width, height = actual->colour.height;
    if (!given.size.is_none() && (picture.width != width || picture.height != height))
      refuse_argument("size", given.size,
                      "the size of " + actual->path + ", (" + std::to_string(width) + ", " + std::to_string(height) +
                          ")");
    picture.width = width, picture.height = height;
    if (actual->is_float() && given.srgb.is_none()) picture.transfer = Transfer::linear;
  }
  const auto within = [](const char* place, const py::object& given_at, int count) {
    return whole_number(place, given_at, 0, count - 1, "a whole number from 0 to " + std::to_string(count - 1));
  };
  const ExplainRequest request{within("x", x, picture.width),
                               within("y", y, picture.height),
                               picture.width,
                               picture.height,
                               picture.samples,
                               picture.transfer,
                               {}};
  std::optional<DeviceProfile> profile;
  if (!given.device.is_none()) profile = device_profile(path_argument("device", given.device));
  std::string json;
  run_watched(py::none(), [&](Watch&) {
    place(of.source.scene, of.source.view, picture.width, picture.height);
    PixelStory story = explain_pixel(
        of.source.scene, request, actual ? std::optional(actual_pixel(*actual, request.x, request.y)) : std::nullopt);
    story.scene = of.name;
    if (profile) story.bounds = bounds_story(of.source.scene, request, *profile);
    json = story_json(story);
  });
  return dictionary(json);
}

} // namespace

void bind_reports(py::module_& module) {
  const py::object none = py::none();
  module.def(
      "compare",
      [](const py::object& a, const py::object& b, const py::object& max_abs, const py::object& max_rms,
         const py::object& max_count, const py::object& unit, const py::object& alpha, const py::object& premultiplied,
         const py::object& layer, const py::object& scene, bool flip, bool allow_outside) {
        return compare_images(
            a, b, {max_abs, max_rms, max_count, unit, alpha, premultiplied, layer, scene, flip, allow_outside});
      },
      py::arg("a"), py::arg("b"), py::kw_only(), py::arg("max_abs") = none, py::arg("max_rms") = none,
      py::arg("max_count") = none, py::arg("unit") = "levels", py::arg("alpha") = none, py::arg("premultiplied") = none,
      py::arg("layer") = none, py::arg("scene") = none, py::arg("flip") = false, py::arg("allow_outside") = false,
      "How far two images are apart, and where: the dictionary of `refraster compare --json`, docs/reports.md. `same` "
      "says "
      "whether they are the same within the limits.\n\na, b: paths; or arrays, top row first, (height, width) or "
      "(height, "
      "width, channels), both of uint8, uint16 or floats, of which 1 is white. Limits are in `unit`: \"levels\" of "
      "1/255, or "
      "\"values\". alpha: \"ignore\", \"compare\", or (r, g, b), a background. scene: a file that names what is seen "
      "in "
      "clusters.");
  module.def(
      "verify",
      [](const py::object& scene, const py::object& actual, const py::object& device, const py::object& matrices,
         const py::object& samples, const py::object& srgb, bool flip_y, const py::object& ids, const py::object& depth,
         const py::object& layer, const py::object& alpha, const py::object& premultiplied, const py::object& fail_on,
         bool allow_outside, const py::object& progress) {
        return verify_image(
            scene, actual,
            {device, matrices, samples, srgb, ids, depth, layer, alpha, premultiplied, fail_on, flip_y, allow_outside},
            progress);
      },
      py::arg("scene"), py::arg("actual"), py::kw_only(), py::arg("device") = none, py::arg("matrices") = none,
      py::arg("samples") = none, py::arg("srgb") = none, py::arg("flip_y") = false, py::arg("ids") = none,
      py::arg("depth") = none, py::arg("layer") = none, py::arg("alpha") = none, py::arg("premultiplied") = none,
      py::arg("fail_on") = none, py::arg("allow_outside") = false, py::arg("progress") = none,
      "Whether a GPU's image of a scene is right, and where it is not: the dictionary of `refraster verify --json`, "
      "docs/reports.md. `passes` says whether each pixel is explained and no limit exceeded.\n\nscene: a Scene, or the "
      "path "
      "of one. actual: a path; or an array, top row first, (height, width, 3), uint8, uint16 or linear floats. device: "
      "a "
      "profile's name or path, by default the widest. matrices: \"one\" or \"three\", of the vertex shader. fail_on: "
      "how "
      "many pixels there may be of a class, as {\"depth\": 10}.");
  module.def(
      "explain",
      [](const py::object& scene, const py::object& x, const py::object& y, const py::object& size,
         const py::object& samples, const py::object& srgb, const py::object& actual, const py::object& layer,
         const py::object& device, bool allow_outside) {
        return explain(scene, x, y, {size, samples, srgb, actual, layer, device, allow_outside});
      },
      py::arg("scene"), py::arg("x"), py::arg("y"), py::kw_only(), py::arg("size") = none, py::arg("samples") = none,
      py::arg("srgb") = none, py::arg("actual") = none, py::arg("layer") = none, py::arg("device") = none,
      py::arg("allow_outside") = false,
      "How the pixel (x, y), from the top left, comes about: the dictionary of `refraster explain --json`, "
      "docs/reports.md.\n\nscene: a Scene, or the path of one. actual: the path of another renderer's image, which "
      "then "
      "decides the size. device: a profile's name or path, for the bounds of a right device.");
}

} // namespace refraster::python
