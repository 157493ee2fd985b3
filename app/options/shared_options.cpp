#include "app/options/shared_options.h"

#include "app/arguments.h"
#include "app/memory_limit.h"

namespace refraster {
namespace {

/// The numbers behind "over:".
std::optional<std::array<double, 3>> colour_over(std::string_view text) {
  constexpr std::string_view over = "over:";
  if (!text.starts_with(over)) return std::nullopt;
  const std::vector<std::string_view> parts = split(text.substr(over.size()), ',');
  std::array<double, 3> colour{};
  if (parts.size() != colour.size()) return std::nullopt;
  for (std::size_t c = 0; c < colour.size(); ++c) {
    const std::optional<double> value = distance_from(parts[c]);
    if (!value) return std::nullopt;
    colour[c] = *value;
  }
  return colour;
}

} // namespace

Option alpha_option(AlphaUse& use, std::array<double, 3>& background, ComparedAlpha compared) {
  const bool offered = compared == ComparedAlpha::offered;
  const std::string words = offered ? "ignore|compare|over:R,G,B" : "ignore|over:R,G,B";
  const auto read = [&use, &background, offered](const std::string& text) -> std::optional<ValueFault> {
    if (text == "ignore") use = AlphaUse::ignored;
    else if (text == "compare" && offered) use = AlphaUse::compared;
    else if (const auto colour = colour_over(text)) use = AlphaUse::composited, background = *colour;
    else
      return ValueFault{std::string(offered ? "ignore, compare" : "ignore") +
                        " or over:R,G,B (numbers >= 0; 1 is white)"};
    return std::nullopt;
  };
  return value_option("--alpha", words,
                      std::string("what to do with an alpha that is not 1 everywhere: leave it out, ") +
                          (offered ? "compare it too, or compare colours over this background"
                                   : "or judge colours over this background"),
                      read);
}

Option premultiplied_option(AlphaEncoding& encoding) {
  return word_option(
      "--premultiplied", {"yes", "no"},
      [&encoding](std::size_t i) { encoding = i == 0 ? AlphaEncoding::premultiplied : AlphaEncoding::straight; },
      "whether colours are stored multiplied by alpha; by default those of .exr files are, others not");
}

Option scene_argument(std::string& path) {
  return argument("SCENE", path, "scene file or OBJ model; docs/scene-format.md");
}

Option outside_option(Outside& outside) {
  return flag(
      "--allow-outside", [&outside] { outside = Outside::allowed; },
      "let the scene name files outside its own folder: only for scenes that you trust");
}

Option exposure_option(double& stops) {
  constexpr double most = 64; // beyond, there is nothing to be seen but black and white
  return number_option("--exposure", stops, Range{-most, most},
                       "make the picture 2^EV times as bright: radiance is multiplied before it is cut off at 1 or "
                       "encoded, EV in stops; AOVs stay as they are");
}

Option shadow_option(SceneOptions& reading) {
  const Range sizes = ShadowMap::sizes;
  const std::string expected =
      "none, exact, map or map:SIZE, " + number_text(sizes.min) + " to " + number_text(sizes.max) + " texels a side";
  const auto read = [&reading, sizes, expected](const std::string& text) -> std::optional<ValueFault> {
    const std::size_t colon = text.find(':');
    const std::optional<Shadow> kind = value_named<Shadow>(std::string_view(text).substr(0, colon));
    if (!kind) return ValueFault{expected};
    reading.shadow = kind;
    if (colon == std::string::npos) return std::nullopt;
    const std::optional<int> size = number_from<int>(std::string_view(text).substr(colon + 1));
    if (!size || !sizes.contains(*size) || kind != Shadow::map) return ValueFault{expected};
    reading.shadow_map_size = size;
    return std::nullopt;
  };
  return value_option("--shadow", "none|exact|map[:SIZE]",
                      "draw every light that has a shadow with this one: without, exact, or by a shadow map, which has "
                      "as many texels a side; maps of the scene keep what else they are",
                      read);
}

Option cache_option(std::string& folder) {
  return folder_option("--cache", folder,
                       "folder, made if need be, where the triangles of large OBJ files are cached, so that they are "
                       "read faster the next time");
}

Option memory_option(std::uint64_t& bytes) {
  return parsed_option("--max-memory", "SIZE", bytes, memory_from, "a size of at least 64M, as 512M or 2G",
                       "most memory that the run may take; what needs more is refused (exit code 3)");
}

Option strict_option(Diagnostics& diagnostics) {
  return flag(
      "--strict", [&diagnostics] { diagnostics.file_notes = FileNotes::refused; },
      "a note on an input file is an error: exit code 3");
}

Option quiet_option(Diagnostics& diagnostics, const std::string& meaning) {
  return flag(
      "-q,--quiet", [&diagnostics] { diagnostics.verbosity = Verbosity::quiet; }, meaning);
}

} // namespace refraster
