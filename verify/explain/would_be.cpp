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
    for (const Candidate& candidate : story_.sample_stories.front().candidates) try_candidate(candidate);
    for (const FragmentStory& fragment : story_.fragments) try_fragment(fragment);
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

  void try_candidate(const Candidate& candidate) {
    if (!candidate.radiance || candidate.fate == CandidateFate::seen) return;
    const std::string what = "triangle " + std::to_string(candidate.of.triangle) + " of object " +
                             std::to_string(candidate.of.object) + ", which is " + std::string(name_of(candidate.fate));
    switch (candidate.fate) {
    case CandidateFate::hidden:
      return try_pixel(*candidate.radiance, what, "as if the depth test were off or turned round");
    case CandidateFate::culled:
      return try_pixel(*candidate.radiance, what, "as if backs were not culled");
    case CandidateFate::before_near:
    case CandidateFate::beyond_far:
      return try_pixel(*candidate.radiance, what, "as if nothing were cut off there");
    case CandidateFate::seen:
      return;
    }
  }

  void try_fragment(const FragmentStory& fragment) {
    weight_ = static_cast<double>(fragment.samples) / story_.samples;
    of_ = story_.fragments.size() > 1 ? " (object " + std::to_string(fragment.of.object) + ")" : "";
    const auto sum = [&](const std::function<Double3(const LightStory&)>& part) {
      Double3 all(0);
      for (const LightStory& light : fragment.lights) all += part(light);
      return all;
    };
    const auto diffuse = [](const LightStory& l) { return l.diffuse ? *l.diffuse * l.arriving : Double3(0); };
    const auto specular = [](const LightStory& l) { return l.specular ? *l.specular * l.arriving : Double3(0); };
    const auto reflected = [](const LightStory& l) { return l.reflected; };

    try_factor("the ambient term, times", 1, fragment.ambient, {0, infinity_});
    if (!has_lobes(fragment)) try_channels("the ambient term", fragment.ambient, Double3(1), infinity_);
    if (fragment.texture) {
      const Double3 coloured = fragment.ambient + sum(diffuse), &t = fragment.texture_colour;
      Double3 per_unit(0); // of the texture's colour
      for (int c = 0; c < 3; ++c) per_unit[c] = t[c] > 0 ? coloured[c] / t[c] : 0;
      try_channels("the texture's colour t", t, per_unit, 1);
    }
    if (fragment.lights.size() > 1) {
      try_factor("the diffuse terms of all lights, times", 1, sum(diffuse), {0, infinity_});
      try_factor("the specular terms of all lights, times", 1, sum(specular), {0, infinity_});
      try_factor("all lights together, times", 1, sum(reflected), {0, infinity_});
    }
    try_parameters(fragment, sum(diffuse));
    for (const LightStory& light : fragment.lights) try_light(light);
  }

  void try_light(const LightStory& light) {
    const std::string of_light = " of " + name_of_light(light);
    const Double3& c = light.arriving;
    if (light.attenuation && *light.attenuation > 0)
      try_factor("the attenuation" + of_light, *light.attenuation, light.reflected, {0, infinity_},
                 [](Span r) { return r.contains(1) ? "as if it were not attenuated" : ""; });
    else try_factor("all" + of_light + ", times", 1, light.reflected, {0, infinity_});
    if (light.diffuse) {
      try_factor("the diffuse term" + of_light + ", times", 1, *light.diffuse * c, {0, infinity_});
      try_channels("the diffuse term kd t <n.l>" + of_light, *light.diffuse, c, infinity_);
    }
    if (light.specular) {
      try_factor("the specular term" + of_light + ", times", 1, *light.specular * c, {0, infinity_});
      try_channels("the specular term" + of_light, *light.specular, c, infinity_);
    }
    if (light.merl && light.merl->lit) {
      try_factor("n.l" + of_light, light.n_l, light.reflected, {0, 1},
                 [](Span r) { return r.contains(1) ? "as if the cosine were left out" : ""; });
      try_channels("the value f" + of_light, light.merl->f, c * light.n_l, infinity_);
    } else if (light.diffuse && light.n_l > 0) {
      try_factor("n.l" + of_light, light.n_l, *light.diffuse * c, {0, 1});
    }
  }

  static bool has_lobes(const FragmentStory& fragment) {
    return !fragment.lights.empty() && fragment.lights.front().lobe.has_value();
  }

  /// The parameters of Phong and Blinn-Phong, all lights together.
  void try_parameters(const FragmentStory& fragment, const Double3& diffuse) {
    const auto parameter = [&](std::string_view name) -> const ParameterStory* {
      for (const ParameterStory& each : fragment.parameters)
        if (each.name == name) return &each;
      return nullptr;
    };
    const ParameterStory *const ka = parameter("ka"), *const kd = parameter("kd"), *const ks = parameter("ks"),
                                *const s = parameter("glossiness");
    if (!has_lobes(fragment) || !ka || !kd || !ks || !s) return;
    const auto colour = [](const ParameterStory& p) { return Double3(p.numbers[0], p.numbers[1], p.numbers[2]); };
    try_channels("ka", colour(*ka), fragment.texture_colour, infinity_, Rank::parameter);
    Double3 per_kd(0), per_ks(0);
    for (int c = 0; c < 3; ++c) per_kd[c] = colour(*kd)[c] > 0 ? diffuse[c] / colour(*kd)[c] : 0;
    for (const LightStory& light : fragment.lights) per_ks += light.arriving * light.lobe->value;
    try_channels("kd", colour(*kd), per_kd, infinity_, Rank::parameter);
    try_channels("ks", colour(*ks), per_ks, infinity_, Rank::parameter);
    try_glossiness(fragment, colour(*ks), s->numbers.front());
  }

  /// The glossiness s' that gives each highlight its power of s' / s: all of them fall as it rises, so that the ends of
  /// what is right are found by bisection.
  void try_glossiness(const FragmentStory& fragment, const Double3& ks, double s) {
    if (!(s > 0)) return;
    constexpr double widest = 10;   // a thousandth to a thousand times of s: beyond, it is another material
    Span exponent{-widest, widest}; // log2(s' / s)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto i = static_cast<int>(c);
      const auto change = [&](double log_times) {
        double sum = 0;
        for (const LightStory& light : fragment.lights)
          if (const double lobe = light.lobe->value; lobe > 0 && lobe < 1)
            sum += (std::pow(lobe, std::exp2(log_times)) - lobe) * ks[i] * light.arriving[i];
        return weight_ * sum;
      };
      const auto where_it_falls_to = [&](double target) {
        double lo = -widest, hi = widest;
        for (int step = 0; step < 100; ++step) {
          const double middle = (lo + hi) / 2;
          (change(middle) > target ? lo : hi) = middle;
        }
        return lo;
      };
      if (change(-widest) < missing_[c].least || change(widest) > missing_[c].most) return;
      exponent = both(exponent, {where_it_falls_to(missing_[c].most), where_it_falls_to(missing_[c].least)});
    }
    if (exponent.empty() || (exponent.least <= -widest && exponent.most >= widest)) return;
    found_.push_back({{WouldBe::Kind::factor,
                       "the glossiness" + of_,
                       {s},
                       {s * std::exp2(exponent.least)},
                       {s * std::exp2(exponent.most)},
                       {true, true, true},
                       {}},
                      Rank::factor,
                      std::abs(typical(exponent)) / widest});
  }

  /// `part` of the pixel is proportional to a factor, which is `now` and may lie in `allowed`.
  void try_factor(
      const std::string& what, double now, const Double3& part, const Span& allowed,
      const std::function<std::string(Span)>& remark = [](Span) { return std::string(); }) {
    Span times; // what it would have to be multiplied by
    for (std::size_t c = 0; c < 3; ++c) {
      const double in_pixel = weight_ * part[static_cast<int>(c)];
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
      const double in_pixel = weight_ * per_unit[i];
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
  double weight_ = 1;                    // of the fragment in the pixel
  std::string of_;                       // which fragment, where there are several
  std::vector<Found> found_;
};

} // namespace

std::vector<WouldBe> what_would_be(const PixelStory& story) {
  return Search(story, story.actual.value()).found();
}

} // namespace refraster
