// Scene.render, refraster.Frame

#include "io/file/limits.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"
#include "io/json/run_report.h"
#include "io/scene/triangle_numbers.h"
#include "python/arrays.h"
#include "python/scene/scenes.h"
#include "python/work.h"
#include "raster/samples.h"
#include "raster/stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <mutex>

namespace refraster::python {
namespace {

/// refraster.Frame
struct LiveFrame {
  Frame frame;
  RenderOptions options; ///< but for progress and cancel
  std::string scene;     ///< path

  const Image<float>& aov(std::size_t i) const { return frame.aovs[i]; }
};

std::vector<std::string_view> aov_names() {
  std::vector<std::string_view> names;
  for (const AovKind& kind : aov_kinds) names.push_back(kind.name);
  return names;
}

/// Floats as they are; numbers as uint32, copied.
py::array aov_array(const LiveFrame& self, std::size_t i, py::handle owner) {
  const Image<float>& image = self.aov(i);
  const py::array floats = image_view(image, owner);
  if (kind_of(self.options.aovs[i]).values == AovValues::floats) return floats;
  return floats.attr("astype")("uint32");
}

py::dict aovs_of(const py::object& self) {
  const auto& live = py::cast<const LiveFrame&>(self);
  py::dict dict;
  for (std::size_t i = 0; i < live.options.aovs.size(); ++i) {
    const std::string_view name = kind_of(live.options.aovs[i]).name;
    dict[py::str(name.data(), name.size())] = aov_array(live, i, self);
  }
  return dict;
}

/// The place of an AOV among those that were asked for.
std::size_t aov_index(const LiveFrame& self, const std::string& place, const py::object& name) {
  std::vector<std::string_view> names;
  for (const Aov aov : self.options.aovs) names.push_back(kind_of(aov).name);
  if (names.empty()) refuse_argument(place, name, "none: render was asked for no AOVs");
  const std::vector<std::size_t> found = words_argument(place, name, names);
  if (found.size() != 1) refuse_argument(place, name, "a single name");
  return found.front();
}

void save_frame(const LiveFrame& self, const py::object& path, const py::object& aov, const py::object& quality) {
  const std::string file = path_argument("path", path);
  WriteOptions writing{.curve = self.options.transfer == Transfer::srgb ? StatedCurve::srgb : StatedCurve::none,
                       .threads = self.options.threads};
  read_argument("quality", quality, Range{1, 100}, writing.jpeg_quality);
  const auto check = [&](std::initializer_list<ImageContent> contents) {
    if (!format_to_write(file, contents))
      throw ArgumentError("path", in_quotes(file), "a name ending in " + writable_extensions(contents));
  };
  if (!aov.is_none()) {
    const Image<float>& image = self.aov(aov_index(self, "aov", aov));
    check({{ImageValues::floats, image.channels}});
    const auto names = image.channels == 2 ? std::vector<std::string>{"U", "V"} : std::vector<std::string>{};
    return run_watched(py::none(), [&](Watch&) { write_image(file, image, names, writing); });
  }
  check({rgb8_image, float_rgb_image});
  const bool floats = format_to_write(file, {float_rgb_image}) != nullptr;
  run_watched(py::none(), [&](Watch&) {
    if (floats) write_image(file, self.frame.radiance, {}, writing);
    else write_image(file, self.frame.rgb8, writing);
  });
}

py::object report_of(const LiveFrame& self) {
  return dictionary(report_json({.scene = self.scene,
                                 .outputs = {},
                                 .width = self.options.width,
                                 .height = self.options.height,
                                 .crop = self.options.crop,
                                 .precision = std::string(name_of(self.options.precision)),
                                 .samples = self.options.samples,
                                 .tile_size = self.options.tile_size,
                                 .threads = self.frame.threads,
                                 .seconds = self.frame.seconds,
                                 .counts = self.frame.counts,
                                 .notes = {}}));
}

std::optional<PixelRect> crop_argument(const py::object& given, int width, int height) {
  if (given.is_none()) return std::nullopt;
  const std::string expected = "(x, y, width, height) in pixels from the top left, within the image of " +
                               std::to_string(width) + "x" + std::to_string(height);
  if (!py::isinstance<py::sequence>(given) || py::len(given) != 4) refuse_argument("crop", given, expected);
  const auto items = py::reinterpret_borrow<py::sequence>(given);
  const auto number = [&](std::size_t i, int least, int most) {
    return whole_number("crop", py::object(items[i]), least, most, expected);
  };
  const int x = number(0, 0, width - 1), y = number(1, 0, height - 1);
  return PixelRect{x, y, number(2, 1, width - x), number(3, 1, height - y)};
}

struct RenderArguments {
  py::object size, precision, samples, aovs, aov_filter, crop, srgb, threads, tile_size;
  bool color64;
};

RenderOptions options_of(const Picture& picture, const RenderArguments& given) {
  RenderOptions options;
  options.width = picture.width, options.height = picture.height;
  if (!given.size.is_none()) std::tie(options.width, options.height) = size_argument("size", given.size);
  read_argument("precision", given.precision, Range{}, options.precision);
  options.samples = picture.samples;
  if (!given.samples.is_none())
    options.samples =
        whole_number("samples", given.samples, 1, 16, expected_value(SampleCount{options.samples}, Range{}));
  if (!is_sample_count(options.samples))
    throw ArgumentError("samples", std::to_string(options.samples),
                        expected_value(SampleCount{options.samples}, Range{}));
  for (const std::size_t i : words_argument("aovs", given.aovs, aov_names()))
    options.aovs.push_back(static_cast<Aov>(i));
  read_argument("aov_filter", given.aov_filter, Range{}, options.aov_filter);
  options.crop = crop_argument(given.crop, options.width, options.height);
  options.transfer = picture.transfer;
  if (!given.srgb.is_none()) read_argument("srgb", given.srgb, Range{}, options.transfer);
  read_argument("threads", given.threads, Range{0, double(limit::threads.value)}, options.threads);
  read_argument("tile_size", given.tile_size, Range{8, 128}, options.tile_size);
  options.want_radiance = true, options.want_radiance_double = given.color64;
  const PixelRect part = options.crop.value_or(PixelRect{0, 0, options.width, options.height});
  const std::uint64_t all = static_cast<std::uint64_t>(part.width) * static_cast<std::uint64_t>(part.height) *
                            static_cast<std::uint64_t>(options.samples);
  if (all > limit::frame_samples.value)
    throw ArgumentError("samples", found_of(limit::frame_samples, all), at_most(limit::frame_samples));
  return options;
}

std::shared_ptr<LiveFrame> render_scene(const LiveScene& self, const RenderArguments& given,
                                        const py::object& progress) {
  const auto source = std::make_shared<SceneSource>(source_of(self));
  const auto live = std::make_shared<LiveFrame>();
  live->options = options_of(self.picture, given);
  live->scene = self.path;
  if (const auto& aovs = live->options.aovs; std::find(aovs.begin(), aovs.end(), Aov::triangle) != aovs.end())
    check_triangle_numbers(self.path, source->scene, "the AOV triangle");
  const auto work = [source, live, renderer = self.renderer](Watch& watch) {
    RenderOptions options = live->options;
    options.cancel = &watch.stop;
    options.progress = [&watch](double done) { watch.fraction = done; };
    place(source->scene, source->view, options.width, options.height);
    // One frame at a time has the memory of those before; others, of other threads of Python, take their own.
    const std::unique_lock lock(renderer->mutex, std::try_to_lock);
    if (lock.owns_lock()) renderer->renderer.render(source->scene, options, live->frame);
    else live->frame = render(source->scene, options);
  };
  run_or_leave(progress, work);
  return live;
}

std::string render_doc() {
  std::string doc =
      "Renders the scene and gives a Frame. Ctrl-C ends it within half a second; other threads of Python go on.\n\n"
      "size: (width, height) in pixels; by default scene.size. precision: \"double\", \"float\", \"fast\" or "
      "\"exact\". "
      "samples: a pixel, 1, 2, 4, 8 or 16. crop: (x, y, width, height), only these pixels. srgb: whether rgb8 has the "
      "sRGB "
      "curve. threads: 0: as many as the machine has. color64: color in float64 too. progress: called with the "
      "fraction "
      "done, in the calling thread.\n\naovs: names of further images (arbitrary output variables):\n";
  for (const AovKind& kind : aov_kinds) doc += "  " + std::string(kind.name) + ": " + std::string(kind.meaning) + "\n";
  return doc;
}

} // namespace

void bind_frames(py::module_& module) {
  py::class_<LiveFrame, std::shared_ptr<LiveFrame>> type(module, "Frame",
                                                         "The images of a scene, top row first. Arrays are the frame's "
                                                         "own memory: no copy, but of AOVs that are numbers.");
  const auto def_image = [&](const char* name, auto Frame::*image, const char* doc) {
    type.def_property_readonly(
        name,
        [image](const py::object& self) -> py::object {
          const auto& pixels = py::cast<const LiveFrame&>(self).frame.*image;
          return pixels.empty() ? py::object(py::none()) : image_view(pixels, self);
        },
        doc);
  };
  def_image("color", &Frame::radiance, "Linear radiance: float32, shape (height, width, 3), unclamped.");
  def_image("color64", &Frame::radiance_double,
            "The same before it is rounded to float32: float64; None unless asked for.");
  def_image("rgb8", &Frame::rgb8, "What a screen shows: uint8, shape (height, width, 3).");
  type.def_property_readonly("aovs", &aovs_of,
                             "Those that were asked for, by name: float32, or uint32 of numbers (object, triangle, "
                             "material: from 1, 0 for none); shape (height, width) or (height, width, channels).");
  type.def(
      "__getitem__",
      [](const py::object& self, const py::object& name) {
        const auto& live = py::cast<const LiveFrame&>(self);
        return aov_array(live, aov_index(live, "Frame[…]", name), self);
      },
      py::arg("name"), "One AOV.");
  type.def_property_readonly(
      "size", [](const LiveFrame& self) { return std::pair(self.frame.rgb8.width, self.frame.rgb8.height); },
      "(width, height) of the arrays, in pixels.");
  type.def_property_readonly("report", &report_of,
                             "The run report as a dictionary, docs/reports.md: sizes, seconds, what the frame met.");
  type.def(
      "save", &save_frame, py::arg("path"), py::arg("aov") = py::none(), py::arg("quality") = 95,
      "Writes an image, whole or not at all: rgb8 as .png or .jpg (of this quality, 1 to 100), color as .exr, .hdr, "
      ".pfm or .npy; or one of the AOVs.");
  type.def("__repr__", [](const LiveFrame& self) {
    return "<refraster.Frame of " + std::to_string(self.frame.rgb8.width) + "x" +
           std::to_string(self.frame.rgb8.height) + " pixels in " + std::string(name_of(self.options.precision)) + ">";
  });

  auto scene = py::reinterpret_borrow<py::class_<LiveScene, std::shared_ptr<LiveScene>>>(module.attr("Scene"));
  scene.def(
      "render",
      [](const LiveScene& self, const py::object& size, const py::object& precision, const py::object& samples,
         const py::object& aovs, const py::object& aov_filter, const py::object& crop, const py::object& srgb,
         const py::object& threads, const py::object& tile_size, bool color64, const py::object& progress) {
        return render_scene(self, {size, precision, samples, aovs, aov_filter, crop, srgb, threads, tile_size, color64},
                            progress);
      },
      py::arg("size") = py::none(), py::arg("precision") = "double", py::arg("samples") = py::none(),
      py::arg("aovs") = py::tuple(), py::kw_only(), py::arg("aov_filter") = "nearest", py::arg("crop") = py::none(),
      py::arg("srgb") = py::none(), py::arg("threads") = 0, py::arg("tile_size") = 64, py::arg("color64") = false,
      py::arg("progress") = py::none(), render_doc().c_str());
}

} // namespace refraster::python
