#include "verify/explain/fragment_text.h"

#include "io/file/text.h"
#include "math/constants.h"
#include "verify/explain/story_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

namespace refraster::story {
namespace {

/// Up to so many taps and lights stand under each other; of more, those that count most.
constexpr std::size_t max_rows = 8;

std::string counted_lights(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " light" : " lights");
}

double size_of(const Double3& rgb) {
  return std::abs(rgb.x) + std::abs(rgb.y) + std::abs(rgb.z);
}

/// The numbers of the `count` items that measure() says most of, in the order of the list.
template <class Item>
std::vector<std::size_t> largest(const std::vector<Item>& items, std::size_t count, const auto& measure) {
  std::vector<std::size_t> numbers(items.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](std::size_t a, std::size_t b) { return measure(items[a]) > measure(items[b]); });
  numbers.resize(std::min(count, numbers.size()));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::string surface_text(const FragmentStory& f) {
  std::string text = heading("SURFACE at the pixel's centre, interpolated (perspective-correct)");
  text += row("weights of the corners", std::vector<double>(f.weights.begin(), f.weights.end()));
  text += row("position", f.position);
  text += row(f.turned ? "normal, turned to the eye" : "normal as interpolated", f.interpolated_normal);
  if (const auto& maps = f.maps_of_normal) {
    text += row("normal before maps, unit", maps->unmapped);
    text += row("tangent t", maps->tangent);
    text += row("handedness of the frame", std::vector<double>{maps->handedness});
    text += row("direction m of the maps", maps->direction);
    text += row("normal n, m in that frame", f.normal);
  } else {
    text += row("normal n, unit", f.normal);
  }
  text += row("to the eye v, unit", f.to_eye);
  text += row("n.v", std::vector<double>{f.n_v});
  if (f.uv) text += row("texture coordinates u v", std::vector<double>{f.uv->x, f.uv->y});
  if (f.vertex_colour) text += row("colour of the vertices", *f.vertex_colour);
  return text;
}

std::string level_text(const TextureStory& t) {
  const double detail = *t.level_of_detail, last = t.levels - 1;
  if (!(detail > 0)) return "magnified: level 0 alone";
  if (detail >= last) return "level " + general(last, 6) + " alone, the last";
  const double below = std::floor(detail);
  if (below == detail) return "level " + general(below, 6) + " alone";
  return "between levels " + general(below, 6) + " and " + general(below + 1, 6);
}

/// How one was read; `name` is its heading.
std::string reading_text(const std::string& name, const TextureStory& t) {
  std::string text = heading(name + " of " + std::to_string(t.width) + " x " + std::to_string(t.height) + " texels, " +
                             std::string(name_of(t.filter)));
  if (t.level_of_detail) {
    text += row("u v by a pixel to the right", std::vector<double>{t.uv_right.x, t.uv_right.y});
    text += row("u v by a pixel down", std::vector<double>{t.uv_down.x, t.uv_down.y});
    text += left("  level of detail", label_width) + right(number(*t.level_of_detail), number_width) + "  " +
            level_text(t) + "\n";
  }
  text += "  level  texel (i, j)      weight" + right("red", number_width) + right("green", number_width) +
          right("blue", number_width) + "\n";
  for (const Texel& texel : t.texels)
    text += "  " + left(std::to_string(texel.level), 7) +
            left("(" + std::to_string(texel.i) + ", " + std::to_string(texel.j) + ")", 14) +
            right(fixed(texel.weight, 6), 10) + right(number(texel.value.x), number_width) +
            right(number(texel.value.y), number_width) + right(number(texel.value.z), number_width) + "\n";
  return text;
}

std::string textures_text(const FragmentStory& f) {
  std::string text = f.texture ? reading_text("TEXTURE", *f.texture) + row("colour t", f.texture_colour)
                               : row("texture colour t, no texture", f.texture_colour);
  if (f.maps_of_normal && f.maps_of_normal->normal_map)
    text += reading_text("NORMAL MAP", *f.maps_of_normal->normal_map);
  if (f.maps_of_normal && f.maps_of_normal->bump_map) text += reading_text("BUMP MAP", *f.maps_of_normal->bump_map);
  if (f.specular_map) text += reading_text("SPECULAR MAP", *f.specular_map);
  if (f.specular_colour) text += row("colour that multiplies ks", *f.specular_colour);
  if (f.roughness_map) text += reading_text("ROUGHNESS MAP", *f.roughness_map);
  if (f.metallic_map) text += reading_text("METALLIC MAP", *f.metallic_map);
  if (f.emissive_map) text += reading_text("EMISSIVE MAP", *f.emissive_map);
  if (f.emission) text += row("light of its own", *f.emission);
  return text;
}

std::string parameters_text(const std::vector<ParameterStory>& parameters) {
  std::string text;
  for (const ParameterStory& parameter : parameters)
    text += parameter.word.empty() ? row(parameter.name, parameter.numbers) : row(parameter.name, parameter.word);
  return text;
}

std::string material_text(const FragmentStory& f) {
  std::string text = heading("MATERIAL " + f.function + (f.material.empty() ? "" : ", " + as_utf8(f.material)));
  text += parameters_text(f.parameters);
  if (f.user_function)
    text += sentence("  The formula is not known here: a light's term is what it makes the radiance larger by where it "
                     "is the only one, which is the light's own where the function adds them up.",
                     0);
  return text;
}

std::string taps_text(const MerlStory& m) {
  std::string text = "  theta_h theta_d phi_d      weight" + right("red", number_width) + right("green", number_width) +
                     right("blue", number_width) + "\n";
  const std::vector<std::size_t> shown =
      largest(m.taps, max_rows, [](const MerlTap& tap) { return std::abs(tap.weight) + (tap.unmeasured ? 2 : 0); });
  for (const std::size_t i : shown) {
    const MerlTap& tap = m.taps[i];
    text += right(std::to_string(tap.theta_h), 9) + right(std::to_string(tap.theta_d), 8) +
            right(std::to_string(tap.phi_d), 6) + right(fixed(tap.weight, 6), 10);
    if (tap.unmeasured) text += right("never measured", number_width) + "\n";
    else
      text += right(number(tap.f.x), number_width) + right(number(tap.f.y), number_width) +
              right(number(tap.f.z), number_width) + "\n";
  }
  if (shown.size() < m.taps.size())
    text += "  and " + std::to_string(m.taps.size() - shown.size()) + " more of smaller weight\n";
  return text;
}

std::string merl_text(const LightStory& light, const MerlStory& m) {
  std::string text = row("theta_h theta_d phi_d, degrees",
                         Double3(m.theta_h, m.theta_d, m.phi_d) * constant<double>(constants::degrees_per_radian));
  text += row("the same in bins: u v w", Double3(m.u, m.v, m.w));
  text += taps_text(m);
  text += row(m.unmeasured ? "f, nothing measured there" : "value f, 1/sr", m.f);
  const std::string term = m.lit ? "f <n.l> C" : light.n_l > 0 ? "0, since n.v <= 0" : "0, since n.l <= 0";
  return text + row(term, light.reflected);
}

std::string microfacet_text(const LightStory& light, const MicrofacetStory& m) {
  std::string text = row("alpha, the square of roughness", std::vector<double>{m.alpha});
  text += row("density D(h), 1/sr", std::vector<double>{m.density});
  text += row("G2 <n.l> / (4 n.l n.v)", std::vector<double>{m.cosine_over_divisor});
  text += row("Fresnel F(h.l)", m.fresnel);
  const std::string why = m.lit ? "" : light.n_l > 0 ? ", 0 since n.v <= 0" : ", 0 since n.l <= 0";
  text += row("diffuse" + why, *light.diffuse);
  text += row("specular  D G2 F / (4 n.v)" + why, *light.specular);
  return text + row("(diffuse + specular) C", light.reflected);
}

std::string shadow_map_text(const ShadowMapStory& map) {
  std::string text = row("place in the map" + (map.face.empty() ? "" : ", face " + map.face) + ", texels",
                         std::vector<double>{map.u, map.v});
  text += row("depth with bias, compared with", std::vector<double>{map.depth});
  for (const ShadowTapStory& tap : map.taps) {
    const std::string place = "texel " + std::to_string(tap.column) + " " + std::to_string(tap.row) + ", weight " +
                              number(tap.weight) + (tap.lit ? ", lit" : ", not lit");
    text += tap.stored ? row(place, std::vector<double>{*tap.stored}) : row(place, "beside the map");
  }
  return text;
}

std::string shadow_text(const ShadowStory& shadow) {
  std::string text = row("visibility", std::vector<double>{shadow.visibility});
  if (shadow.between)
    text += row("in the shadow of",
                "triangle " + std::to_string(shadow.between->triangle) + " of " + object_text(*shadow.between));
  if (shadow.map) text += shadow_map_text(*shadow.map);
  return text;
}

std::string light_block(const LightStory& light) {
  std::string name = light_text(light);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string text = heading(name);
  text += parameters_text(light.parameters);
  text += row("direction to it l, unit", light.direction);
  if (light.distance) text += row("distance d", std::vector<double>{*light.distance});
  if (light.attenuation) text += row("attenuation at d", std::vector<double>{*light.attenuation});
  if (light.shadow) text += shadow_text(*light.shadow);
  text += row(light.shadow        ? (light.attenuation ? "C: attenuated, times visibility" : "C: radiance x visibility")
              : light.attenuation ? "C: radiance x attenuation"
                                  : "C: the radiance, not attenuated",
              light.arriving);
  text += row("n.l", std::vector<double>{light.n_l});
  if (light.merl) return text + merl_text(light, *light.merl);
  if (light.microfacet) return text + microfacet_text(light, *light.microfacet);
  if (!light.diffuse || !light.specular) return text + row("reflected", light.reflected);
  std::string lobe_name = "highlight";
  if (light.lobe) {
    const std::string cosine(light.lobe->cosine_name), vector(light.lobe->vector_name);
    lobe_name = "<" + cosine + ">^s";
    text += row(vector == "r" ? "r = 2 (n.l) n - l" : "h = (l + v) / |l + v|", light.lobe->vector);
    text += row(cosine, std::vector<double>{light.lobe->cosine});
    text += row(lobe_name, std::vector<double>{light.lobe->value});
  }
  text += row(light.n_l > 0 ? "diffuse   kd t <n.l>" : "diffuse   kd t <n.l>, <n.l> = 0", *light.diffuse);
  text += row("specular  ks " + lobe_name + (light.specular_map == Double3(1) ? "" : ", map"), *light.specular);
  return text + row("(diffuse + specular) C", light.reflected);
}

/// Those that give most. Where not all are asked for, those that give nothing are no news.
std::vector<std::size_t> described_lights(const FragmentStory& f, std::size_t count) {
  const auto gives = [](const LightStory& light) { return size_of(light.reflected); };
  std::vector<std::size_t> numbers = largest(f.lights, count, gives);
  if (f.lights.size() > count) std::erase_if(numbers, [&](std::size_t i) { return gives(f.lights[i]) == 0; });
  return numbers;
}

std::string lights_left_out(const FragmentStory& f, std::size_t count) {
  const std::size_t described = described_lights(f, count).size();
  if (described == f.lights.size()) return {};
  const std::string which =
      described == 0 ? "None of " + counted_lights(f.lights.size()) + " is described"
      : described == 1
          ? "The light that gives most is described, of " + counted_lights(f.lights.size())
          : "The " + counted_lights(described) + " that give most are described, of " + std::to_string(f.lights.size());
  return "\n" + sentence(which + "; --lights N describes more, --json all.", 0);
}

std::string sum_text(const FragmentStory& f) {
  std::string text = heading_rgb("SUM");
  text += row(f.user_function ? "without any light" : "ambient", f.ambient);
  if (f.emission) text += row("light of its own", *f.emission);
  const auto gives = [](const LightStory& light) { return size_of(light.reflected); };
  const std::vector<std::size_t> shown = largest(f.lights, max_rows, gives);
  std::size_t dark = 0, others = 0;
  Double3 rest(0);
  for (std::size_t i = 0; i < f.lights.size(); ++i) {
    const LightStory& light = f.lights[i];
    if (gives(light) == 0) ++dark;
    else if (std::binary_search(shown.begin(), shown.end(), i)) text += row(light_text(light), light.reflected);
    else ++others, rest += light.reflected;
  }
  if (others > 0) text += row("the other " + counted_lights(others), rest);
  if (dark > 0)
    text += row(counted_lights(dark) + (dark == 1 ? " that gives nothing" : " that give nothing"), Double3(0));
  return text + row("radiance toward the eye", f.radiance);
}

} // namespace

std::string object_text(const NamedTriangle& of, std::size_t width) {
  std::string text = "object " + std::to_string(of.object);
  if (!of.name.empty()) text += " " + in_quotes(of.name);
  if (text.size() > width) text = text.substr(0, width - 2) + "..";
  return text;
}

std::string light_text(const LightStory& light) {
  return light.type + " " + std::to_string(light.index);
}

std::string fragment_text(const FragmentStory& f, const StoryTextOptions& options) {
  std::string text = surface_text(f) + textures_text(f) + material_text(f);
  for (const std::size_t i : described_lights(f, options.lights)) text += light_block(f.lights[i]);
  return text + lights_left_out(f, options.lights) + sum_text(f);
}

} // namespace refraster::story
