#include "verify/images/colour_channels.h"

#include <refraster/notes.h>

#include "io/file/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <string_view>

namespace refraster {
namespace {

/// The last part of a name says what the channel is, what stands before it, which layer it is of.
/// https://openexr.com/en/latest/TechnicalIntroduction.html, "Layers"
std::string_view layer_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : name.substr(0, dot);
}
std::string lower_component(std::string_view name) {
  std::string component(name.substr(name.rfind('.') + 1)); // npos + 1 is 0
  for (char& letter : component) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return component;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> colour_names = {
    {{"r", "red"}, {"g", "green"}, {"b", "blue"}, {"a", "alpha"}}};

/// The place of a component of a layer.
std::optional<std::size_t> place_of(const std::vector<std::string>& channels, std::string_view layer,
                                    std::string_view name, std::string_view long_name) {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::string component = lower_component(channels[i]);
    if (layer_of(channels[i]) == layer && (component == name || component == long_name)) return i;
  }
  return std::nullopt;
}
std::optional<std::size_t> colour_place(const std::vector<std::string>& channels, std::string_view layer,
                                        std::size_t colour) {
  return place_of(channels, layer, colour_names[colour].first, colour_names[colour].second);
}

std::string listed(const std::vector<std::string>& layers) {
  std::string text;
  for (const std::string& layer : layers) text += (text.empty() ? "" : ", ") + layer;
  return one_line(text);
}

std::string chosen_layer(const std::string& path, const std::vector<std::string>& layers, const std::string& asked) {
  const auto has = [&](std::string_view name) { return std::find(layers.begin(), layers.end(), name) != layers.end(); };
  if (!asked.empty() && has(asked)) return asked;
  if (has("") || layers.empty()) return "";
  if (layers.size() == 1) return layers.front();
  std::vector<std::string> combined;
  for (const std::string& layer : layers)
    if (lower_component(layer) == "combined") combined.push_back(layer);
  if (combined.size() == 1) return combined.front();
  throw InputError(
      InputFault{path, 0, 0, "", "colours in the layers " + listed(layers), "one of them by --layer NAME"});
}

/// Those of a layer of this name, or the one channel that is called so.
std::vector<std::size_t> places_in(const std::vector<std::string>& channels, const std::string& layer) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (!layer.empty() && (layer_of(channels[i]) == layer || channels[i] == layer)) places.push_back(i);
  return places;
}

void add_others(const std::vector<std::string>& channels, ColourChannels& result) {
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (i != result.alpha && std::find(result.compared.begin(), result.compared.end(), i) == result.compared.end())
      result.others.push_back(i);
}

} // namespace

std::vector<std::string> colour_layers(const std::vector<std::string>& channels) {
  std::vector<std::string> layers;
  for (const std::string& channel : channels) {
    const std::string layer(layer_of(channel));
    const bool is_colour =
        colour_place(channels, layer, 0) && colour_place(channels, layer, 1) && colour_place(channels, layer, 2);
    if (is_colour && std::find(layers.begin(), layers.end(), layer) == layers.end()) layers.push_back(layer);
  }
  return layers;
}

ColourChannels colour_channels(const std::string& path, const ImageFile& image, const std::string& layer) {
  const std::vector<std::string>& channels = image.channels;
  const std::vector<std::string> layers = colour_layers(channels);
  ColourChannels result;
  if (std::find(layers.begin(), layers.end(), layer) == layers.end()) {
    result.compared = places_in(channels, layer);
    if (!result.compared.empty()) {
      result.kind = ColourChannels::Kind::data, result.layer = layer;
      add_others(channels, result);
      return result;
    }
  }
  result.layer = chosen_layer(path, layers, layer);
  const auto grey = place_of(channels, "", "y", "y");
  if (!layers.empty()) {
    for (std::size_t c = 0; c < 3; ++c) result.compared.push_back(*colour_place(channels, result.layer, c));
  } else if (grey && !place_of(channels, "", "x", "x")) {
    result.kind = ColourChannels::Kind::grey;
    result.compared = {*grey};
  } else {
    result.kind = ColourChannels::Kind::data;
    result.compared.resize(channels.size());
    std::iota(result.compared.begin(), result.compared.end(), std::size_t{0});
    return result;
  }
  result.alpha = colour_place(channels, result.layer, 3);
  add_others(channels, result);
  return result;
}

} // namespace refraster
