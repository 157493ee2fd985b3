#include "verify/explain/would_be.h"

#include "io/file/text.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace refraster {
namespace {

constexpr std::size_t max_found = 20;

struct Span {
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  bool contains(double x) const { return least <= x && x <= most; }
  bool empty() const { return !(least <= most); }
};

Span both(const Span& a, const Span& b) {
  return {std::max(a.least, b.least), std::min(a.most, b.most)};
}

/// a + b r for r in a range.
Span moved(double a, double b, const Span& r) {
  const double p = a + b * r.least, q = a + b * r.most;
  return b >= 0 ? Span{p, q} : Span{q, p};
}

/// The middle, or the end that there is.
double typical(const Span& r) {
  if (std::isinf(r.least)) return r.most;
  return std::isinf(r.most) ? r.least : (r.least + r.most) / 2;
}

/// "point light 0".
std::string name_of_light(const LightStory& light) {
  return light.type + " " + std::to_string(light.index);
}

/// Kinds of explanation, likeliest first.
enum class Rank { known_mistake, other_surface, factor, parameter, term };

/// Something found, and what decides its place in the list.
struct Found {
  WouldBe would_be;
  Rank rank;
  double change; // relative
};

class Search {
public:
  Search(const PixelStory& story, const ActualStory& actual) : story_(story) {
    const Double3& radiance = story.in(Precision::double_).radiance;
    for (int c = 0; c < 3; ++c) {
      missing_[static_cast<std::size_t>(c)] = {actual.least[c] - radiance[c], actual.most[c] - radiance[c]};
      actual_[static_cast<std::size_t>(c)] = {actual.least[c], actual.most[c]};
    }
  }

  std::vector<WouldBe> found() {
    if (story_.background_samples < story_.samples)
      try_pixel(story_.background, "the background", "as if nothing were drawn here");
    for (const CoveringTriangle& candidate : story_.sample_stories.front().candidates) try_candidate(candidate);
    const std::vector<Group> all = groups();
    for (const Group& group : all) {
      of_ = all.size() > 1 ? " (object " + std::to_string(group.first().of.object) + ")" : "";
      try_group(group);
    }
    std::stable_sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
      return a.rank != b.rank ? a.rank < b.rank : a.change < b.change;
    });
    std::vector<WouldBe> result;
    for (Found& each : found_)
      if (result.size() < max_found) result.push_back(std::move(each.would_be));
    return result;
  }

private:
  void try_pixel(const Double3& radiance, const std::string& what, const std::string& remark) {
    WouldBe found{WouldBe::Kind::pixel, what, {}, {}, {}, {}, remark};
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = radiance[static_cast<int>(c)];
      if (!actual_[c].contains(value)) return;
      found.now[c] = found.least[c] = found.most[c] = value;
    }
    found_.push_back({found, Rank::other_surface, 0});
  }

  void try_candidate(const CoveringTriangle& candidate) {
    if (!candidate.radiance || candidate.fate == CandidateFate::seen) return;
    const std::string what = "triangle " + std::to_string(candidate.of.triangle) + " of object " +
                             std::to_string(candidate.of.object) + ", which is " + std::string(name_of(candidate.fate));
    switch (candidate.fate) {
    case CandidateFate::hidden:
      return try_pixel(*candidate.radiance, what, "as if the depth test were off or turned round");
    case CandidateFate::culled:
      return try_pixel(*candidate.radiance, what, "as if backs were not culled");
    case CandidateFate::cut_out:
      return try_pixel(*candidate.radiance, what, "as if its opacity were not looked at");
    case CandidateFate::before_near:
    case CandidateFate::beyond_far:
      return try_pixel(*candidate.radiance, what, "as if nothing were cut off there");
    case CandidateFate::seen:
      return;
    }
  }

  /// The fragments of one object, which share its material and its lights, with their weights in the pixel: a term is
  /// another in all of them.
  struct Group {
    std::vector<std::pair<const FragmentStory*, double>> fragments;

    const FragmentStory& first() const { return *fragments.front().first; }
    bool is_one() const { return fragments.size() == 1; }
    /// Of part(fragment), in the pixel.
    Double3 sum(const auto& part) const {
      Double3 all(0);
      for (const auto& [fragment, weight] : fragments) all += part(*fragment) * weight;
      return all;
    }
    /// Of part(light) of light i; and of all lights.
    Double3 sum_of_light(std::size_t i, const auto& part) const {
      return sum([&](const FragmentStory& fragment) { return part(fragment.lights[i]); });
    }
    Double3 sum_of_lights(const auto& part) const {
      return sum([&](const FragmentStory& fragment) {
        Double3 all(0);
        for (const LightStory& light : fragment.lights) all += part(light);
        return all;
      });
    }
    bool has_lobes() const { return !first().lights.empty() && first().lights.front().lobe.has_value(); }
  };

  static Double3 diffuse(const LightStory& l) { return l.diffuse ? *l.diffuse * l.arriving : Double3(0); }
  static Double3 specular(const LightStory& l) { return l.specular ? *l.specular * l.arriving : Double3(0); }
  static Double3 reflected(const LightStory& l) { return l.reflected; }
  static Double3 arriving(const LightStory& l) { return l.arriving; }

  std::vector<Group> groups() const {
    std::vector<Group> result;
    for (const FragmentStory& fragment : story_.fragments) {
      auto group = std::find_if(result.begin(), result.end(),
                                [&](const Group& g) { return g.first().of.object == fragment.of.object; });
      if (group == result.end()) group = result.insert(group, Group{});
      group->fragments.emplace_back(&fragment, static_cast<double>(fragment.samples) / story_.samples);
    }
    return result;
  }

  void try_group(const Group& group) {
    const Double3 ambient = group.sum([](const FragmentStory& f) { return f.ambient; });
    try_factor("the ambient term, times", 1, ambient, {0, infinity_});
    if (!group.has_lobes()) try_channels("the ambient term", ambient, Double3(1), infinity_);
    if (group.is_one() && group.first().texture) {
      const Double3 coloured = ambient + group.sum_of_lights(diffuse), &t = group.first().texture_colour;
      Double3 per_unit(0); // of the texture's colour
      for (int c = 0; c < 3; ++c) per_unit[c] = t[c] > 0 ? coloured[c] / t[c] : 0;
      try_channels("the texture's colour t", t, per_unit, 1);
    }
    const std::size_t lights = group.first().lights.size();
    if (lights > 1) {
      try_factor("the diffuse terms of all lights, times", 1, group.sum_of_lights(diffuse), {0, infinity_});
      try_factor("the specular terms of all lights, times", 1, group.sum_of_lights(specular), {0, infinity_});
      try_factor("all lights together, times", 1, group.sum_of_lights(reflected), {0, infinity_});
    }
    if (group.has_lobes()) try_parameters(group);
    for (std::size_t i = 0; i < lights; ++i) try_light(group, i);
  }

  /// What is told of a light is that of the first fragment.
  void try_light(const Group& group, std::size_t i) {
    const LightStory& light = group.first().lights[i];
    const std::string of_light = " of " + name_of_light(light);
    if (story_.fragments.size() == 1 && story_.background_samples == 0 && light.shadow && light.shadow->reflected)
      try_pixel(group.first().radiance + *light.shadow->reflected, "the pixel with the light" + of_light,
                "as if it had no shadow");
    const Double3 all = group.sum_of_light(i, reflected), matt = group.sum_of_light(i, diffuse),
                  shining = group.sum_of_light(i, specular), incident = group.sum_of_light(i, arriving);
    if (light.attenuation && *light.attenuation > 0)
      try_factor("the attenuation" + of_light, *light.attenuation, all, {0, infinity_},
                 [](Span r) { return r.contains(1) ? "as if it were not attenuated" : ""; });
    else try_factor("all" + of_light + ", times", 1, all, {0, infinity_});
    if (light.diffuse) {
      try_factor("the diffuse term" + of_light + ", times", 1, matt, {0, infinity_});
      const std::string term = light.microfacet ? "the diffuse term" : "the diffuse term kd t <n.l>";
      if (group.is_one()) try_channels(term + of_light, *light.diffuse, incident, infinity_);
    }
    if (light.specular) {
      try_factor("the specular term" + of_light + ", times", 1, shining, {0, infinity_});
      if (group.is_one()) try_channels("the specular term" + of_light, *light.specular, incident, infinity_);
    }
    if (light.merl && light.merl->lit) {
      try_factor("n.l" + of_light, light.n_l, all, {0, 1},
                 [](Span r) { return r.contains(1) ? "as if the cosine were left out" : ""; });
      if (group.is_one()) try_channels("the value f" + of_light, light.merl->f, incident * light.n_l, infinity_);
    } else if (light.diffuse && !light.microfacet && light.n_l > 0) {
      try_factor("n.l" + of_light, light.n_l, matt, {0, 1});
    }
  }

  /// The parameters of Phong and Blinn-Phong, all lights together.
  void try_parameters(const Group& group) {
    const auto parameter = [&](std::string_view name) {
      for (const ParameterStory& each : group.first().parameters)
        if (each.name == name) return each.numbers;
      return std::vector<double>{};
    };
    const auto colour = [&](std::string_view name) {
      const std::vector<double> rgb = parameter(name);
      return Double3(rgb.at(0), rgb.at(1), rgb.at(2));
    };
    const Double3 kd = colour("kd"), ks = colour("ks"), matt = group.sum_of_lights(diffuse);
    Double3 per_kd(0);
    for (int c = 0; c < 3; ++c) per_kd[c] = kd[c] > 0 ? matt[c] / kd[c] : 0;
    const auto per_ks = [](const LightStory& light) { return light.arriving * light.specular_map * light.lobe->value; };
    try_channels("ka", colour("ka"), group.sum([](const FragmentStory& f) { return f.texture_colour; }), infinity_,
                 Rank::parameter);
    try_channels("kd", kd, per_kd, infinity_, Rank::parameter);
    try_channels("ks", ks, group.sum_of_lights(per_ks), infinity_, Rank::parameter);
    try_glossiness(group, ks, parameter("glossiness").at(0));
  }

  /// The glossiness s' that gives each highlight its power of s' / s: all of them fall as it rises, so that the ends of
  /// what is right are found by bisection.
  void try_glossiness(const Group& group, const Double3& ks, double s) {
    if (!(s > 0)) return;
    constexpr double widest = 10;   // a thousandth to a thousand times of s: beyond, it is another material
    constexpr int steps = 64;       // of a bisection: beyond a double's digits
    Span exponent{-widest, widest}; // log2(s' / s)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<int>(c);
      const auto change = [&](double log_times) {
        return group.sum_of_lights([&](const LightStory& light) {
          const double lobe = light.lobe->value;
          const bool falls = lobe > 0 && lobe < 1;
          return light.arriving * ks * (falls ? std::pow(lobe, std::exp2(log_times)) - lobe : 0);
        })[i];
      };
      const auto where_it_falls_to = [&](double target) {
        double lo = -widest, hi = widest;
        for (int step = 0; step < steps; ++step) {
          const double middle = (lo + hi) / 2;
          (change(middle) > target ? lo : hi) = middle;
        }
        return lo;
      };
      if (change(-widest) < missing_[c].least || change(widest) > missing_[c].most) return;
      exponent = both(exponent, {where_it_falls_to(missing_[c].most), where_it_falls_to(missing_[c].least)});
    }
    if (exponent.empty() || (exponent.least <= -widest && exponent.most >= widest)) return;
    WouldBe found{WouldBe::Kind::factor, "the glossiness" + of_, {s}, {}, {}, {true, true, true}, {}};
    found.least[0] = s * std::exp2(exponent.least), found.most[0] = s * std::exp2(exponent.most);
    found_.push_back({found, Rank::factor, std::abs(typical(exponent)) / widest});
  }

  /// `part` of the pixel is proportional to a factor, which is `now` and may lie in `allowed`.
  void try_factor(
      const std::string& what, double now, const Double3& part, const Span& allowed,
      const std::function<std::string(Span)>& remark = [](Span) { return std::string(); }) {
    Span times; // what it would have to be multiplied by
    for (std::size_t c = 0; c < 3; ++c) {
      const double in_pixel = part[static_cast<int>(c)];
      if (in_pixel != 0) times = both(times, moved(1, 1 / in_pixel, missing_[c]));
      else if (!missing_[c].contains(0)) return;
    }
    const Span value = both(moved(0, now, times), allowed);
    if (value.empty() || !std::isfinite(typical(value))) return;
    WouldBe found{WouldBe::Kind::factor, what + of_, {now}, {value.least}, {value.most}, {true, true, true}, {}};
    found.remark = remark(value);
    bool is_known = !found.remark.empty();
    if (value.contains(0)) found.remark = "as if it were left out", is_known = true;
    else if (found.remark.empty() && value.contains(2 * now))
      found.remark = "as if it were added twice", is_known = true;
    found_.push_back({found, is_known ? Rank::known_mistake : Rank::factor, std::abs(typical(times) - 1)});
  }

  /// The pixel is per_unit times a colour, which is `now`, and something else.
  void try_channels(const std::string& what, const Double3& now, const Double3& per_unit, double largest,
                    Rank rank = Rank::term) {
    WouldBe found{WouldBe::Kind::channels, what + of_, {}, {}, {}, {}, {}};
    double change = 0, size = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<int>(c);
      const double in_pixel = per_unit[i];
      found.now[c] = now[i];
      found.differs[c] = !missing_[c].contains(0);
      if (!found.differs[c]) {
        found.least[c] = found.most[c] = now[i];
        continue;
      }
      if (in_pixel == 0) return;
      const Span value = both(moved(now[i], 1 / in_pixel, missing_[c]), {0, largest});
      if (value.empty() || !std::isfinite(typical(value))) return;
      found.least[c] = value.least, found.most[c] = value.most;
      change += std::abs(typical(value) - now[i]), size += std::abs(now[i]);
    }
    found_.push_back({found, rank, size > 0 ? change / size : infinity_});
  }

  static constexpr double infinity_ = std::numeric_limits<double>::infinity();
  const PixelStory& story_;
  std::array<Span, 3> missing_, actual_; // by channel: what is to be added; what the pixel is to be
  std::string of_;                       // of which object, where there are several
  std::vector<Found> found_;
};

} // namespace

std::vector<WouldBe> what_would_be(const PixelStory& story) {
  return Search(story, story.actual.value()).found();
}

} // namespace refraster
