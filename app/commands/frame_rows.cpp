#include "app/commands/frame_rows.h"

#include <refraster/files.h>

#include "app/output.h"
#include "io/image/exr_layers.h"
#include "raster/levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace refraster {
namespace {

bool is_number(Aov aov) {
  return kind_of(aov).values == AovValues::numbers;
}

/// Colours, and how much of each pixel is theirs: straight, or, of floats, multiplied by it.
template <class Value>
ImageRows<Value> with_alpha(const ImageRows<Value>& rgb, const ImageRows<float>& alpha) {
  return {rgb.width, rgb.height, 4, [rgb, alpha](int y, std::vector<Value>& scratch) {
            std::vector<Value> colours;
            std::vector<float> alphas;
            const Value* const from = rgb.row(y, colours);
            const float* const of = alpha.row(y, alphas);
            scratch.resize(4 * static_cast<std::size_t>(rgb.width));
            for (std::size_t i = 0; i < static_cast<std::size_t>(rgb.width); ++i) {
              const float a = of[i]; // a multiple of 1/16
              for (std::size_t c = 0; c < 3; ++c) {
                const Value value = from[3 * i + c];
                if constexpr (std::is_same_v<Value, float>) scratch[4 * i + c] = value * a;
                else scratch[4 * i + c] = value;
              }
              if constexpr (std::is_same_v<Value, float>) scratch[4 * i + 3] = a;
              else
                scratch[4 * i + 3] =
                    static_cast<Value>(std::nearbyint(a * static_cast<float>(std::numeric_limits<Value>::max())));
            }
            return static_cast<const Value*>(scratch.data());
          }};
}

ImageRows<std::uint32_t> as_numbers(const ImageRows<float>& image) {
  return {image.width, image.height, image.channels, [image](int y, std::vector<std::uint32_t>& scratch) {
            std::vector<float> floats;
            const float* const from = image.row(y, floats);
            scratch.resize(image.row_values());
            std::transform(from, from + image.row_values(), scratch.begin(),
                           [](float value) { return static_cast<std::uint32_t>(value); });
            return static_cast<const std::uint32_t*>(scratch.data());
          }};
}

void write_aov(const std::string& path, Aov aov, const ImageRows<float>& image, const WriteOptions& writing) {
  if (!is_number(aov) || !format_to_write(path, {{ImageValues::uint32, 1}}))
    return write_values(path, image, {}, writing);
  write_rows(path, as_numbers(image), writing);
}

std::vector<std::string> exr_names(Aov aov) {
  const AovKind& kind = kind_of(aov);
  return {kind.exr_names.begin(), kind.exr_names.begin() + kind.channels};
}

void write_layers(const FrameFiles& files, const std::string& output, const FrameRows& rows,
                  const ImageRows<float>& image, const WriteOptions& writing) {
  std::vector<ExrLayer> layers = {{image, default_channels(image.channels)}};
  for (const Aov aov : written_aovs(files))
    layers.push_back({rows.rows_of(aov), exr_names(aov), is_number(aov) ? LayerValues::uint32 : LayerValues::floats});
  write_exr_layers(output, layers, writing);
}

} // namespace

const ImageRows<float>& FrameRows::rows_of(Aov aov) const {
  return std::find_if(aovs.begin(), aovs.end(), [aov](const auto& one) { return one.first == aov; })->second;
}

FrameRows rows_of(const FrameFiles& files, const std::string& output, const RenderOptions& options,
                  const Frame& frame) {
  FrameRows rows{ImageRows(frame.rgb8), {}};
  switch (output_values(files, output)) {
  case ImageValues::floats:
    rows.image = ImageRows(frame.radiance);
    break;
  case ImageValues::uint16: {
    const ImageRows<double> from(frame.radiance_double);
    rows.image =
        ImageRows<std::uint16_t>(from.width, from.height, from.channels,
                                 [from, transfer = options.transfer](int y, std::vector<std::uint16_t>& scratch) {
                                   std::vector<double> unused; // the rows are in memory
                                   scratch.resize(from.row_values());
                                   levels16(from.row(y, unused), from.row_values(), transfer, scratch.data());
                                   return static_cast<const std::uint16_t*>(scratch.data());
                                 });
    break;
  }
  default:
    break;
  }
  for (std::size_t i = 0; i < options.aovs.size(); ++i) rows.aovs.emplace_back(options.aovs[i], frame.aovs[i]);
  return rows;
}

std::vector<std::string> write_frame_rows(const FrameFiles& files, const std::string& output, Transfer transfer,
                                          int threads, const FrameRows& rows) {
  const WriteOptions writing{.curve = transfer == Transfer::srgb ? StatedCurve::srgb : StatedCurve::none,
                             .jpeg_quality = files.jpeg_quality,
                             .threads = threads};
  const bool is_transparent = files.background == Background::transparent;
  std::visit(
      [&]<class Value>(const ImageRows<Value>& rgb) {
        const ImageRows<Value> image = is_transparent ? with_alpha(rgb, rows.rows_of(Aov::alpha)) : rgb;
        if constexpr (!std::is_same_v<Value, float>) write_rows(output, image, writing);
        else if (files.aov_place == AovPlace::layers) write_layers(files, output, rows, image, writing);
        else write_values(output, image, {}, writing);
      },
      rows.image);
  std::vector<std::string> paths = {output};
  const std::vector<std::string> beside = aov_paths(files, output);
  for (std::size_t i = 0; i < beside.size(); ++i)
    write_aov(beside[i], files.aovs[i], rows.rows_of(files.aovs[i]), writing);
  paths.insert(paths.end(), beside.begin(), beside.end());
  return paths;
}

} // namespace refraster
