#include "bench/precision/inputs.h"

#include "bench/precision/errors.h"
#include "math/elementary/cosine_power.h"
#include "tests/support/shading/directions.h"

#include <cassert>
#include <cmath>

namespace refraster::precision {

namespace {

using Engine = std::mt19937_64;

// The order in which a call's arguments are made is the compiler's. The inputs shall not depend on it: no call here
// has two that are drawn.

Inputs ordinary_surface(const SurfacePair& pair, Engine& random) {
  Inputs in;
  in.n = pair.n, in.l = pair.i, in.v = pair.o;
  in.kd = uniform(random, 0.2, 1);
  in.ks = uniform(random, 0.2, 1);
  in.texture = uniform(random, 0.2, 1);
  in.radiance = uniform(random, 0.5, 1);
  in.glossiness = random_scale(random, 0, std::log10(128.0));
  return in;
}

/// Light and eye at least 6 degrees above the horizon.
SurfacePair high_pair(Engine& random) {
  for (;;) {
    const SurfacePair pair = random_pair(random);
    if (dot(pair.n, pair.i) >= 0.1 && dot(pair.n, pair.o) >= 0.1) return pair;
  }
}

/// Light and eye with cosines below 0.05, to 1e-6.
SurfacePair grazing_pair(Engine& random) {
  const Double3 n = random_direction(random);
  const auto low = [&] {
    const Double3 aside = normalize(cross(n, random_direction(random)));
    return normalize(aside + n * random_scale(random, -6, std::log10(0.05)));
  };
  const Double3 i = low();
  return {n, i, low()};
}

/// n, l and v in one plane.
SurfacePair plane_pair(Engine& random) {
  const Double3 n = random_direction(random);
  const Double3 aside = normalize(cross(n, random_direction(random)));
  const auto leaning = [&] {
    const double angle = uniform(random, -1.5, 1.5);
    return normalize(n * std::cos(angle) + aside * std::sin(angle));
  };
  const Double3 i = leaning();
  return {n, i, leaning()};
}

/// The half vector within three radii of the highlight from the normal: there the power is about exp(-x^2), x in [0,
/// 3].
Inputs in_highlight(Engine& random, double min_decade, double max_decade) {
  Inputs in = ordinary_surface({}, random);
  in.glossiness = random_scale(random, min_decade, max_decade);
  const double angle = std::min(std::sqrt(2 / in.glossiness) * uniform(random, 0, 3), 0.6);
  for (;;) {
    const Double3 n = random_direction(random), h = turned(n, angle, random);
    const Double3 i = random_direction_above(n, random), o = mirrored(i, h);
    if (dot(n, i) < 0.1 || dot(n, o) < 0.1) continue;
    in.n = n, in.l = i, in.v = o;
    return in;
  }
}

/// A point within 10 of the origin; light and eye 0.1 to 10 away from it; all lengths times `scale`.
Inputs in_space(Engine& random, Path path, double scale, double normal_scale) {
  Inputs in = ordinary_surface(high_pair(random), random);
  in.path = path;
  in.normal = in.n * random_scale(random, -1, 1) * normal_scale;
  const double distance = uniform(random, 0, 10);
  in.position = random_direction(random) * distance * scale;
  in.eye = in.position + in.v * (random_scale(random, -1, 1) * scale);
  in.point.position = in.position + in.l * (random_scale(random, -1, 1) * scale);
  in.direction.direction = -in.l * random_scale(random, -1, 1) * scale;
  return in;
}

Inputs ordinary(Engine& random, double) {
  return ordinary_surface(high_pair(random), random);
}
Inputs retro(Engine& random, double) {
  return ordinary_surface(retro_reflective_pair(random), random);
}
Inputs grazing(Engine& random, double) {
  return ordinary_surface(grazing_pair(random), random);
}
Inputs opposite(Engine& random, double) {
  return ordinary_surface(opposite_grazing_pair(random), random);
}
Inputs plane(Engine& random, double) {
  return ordinary_surface(plane_pair(random), random);
}
Inputs uniform_pair(Engine& random, double) {
  return ordinary_surface(random_pair(random), random);
}
Inputs specular(Engine& random, double) {
  return ordinary_surface(specular_pair(random), random);
}
Inputs soft(Engine& random, double) {
  Inputs in = ordinary_surface(high_pair(random), random);
  in.glossiness = random_scale(random, -3, 0);
  return in;
}
Inputs highlight(Engine& random, double) {
  return in_highlight(random, 0, 4);
}
Inputs sharp(Engine& random, double) {
  return in_highlight(random, 4, 6);
}
Inputs whole(Engine& random, double) {
  Inputs in = in_highlight(random, 0, std::log10(max_whole_exponent + 1.0));
  in.glossiness = std::floor(in.glossiness);
  return in;
}
Inputs point_light(Engine& random, double) {
  Inputs in = in_space(random, Path::point_light, 1, 1);
  in.point.constant = uniform(random, 0, 1);
  in.point.linear = uniform(random, 0, 1);
  in.point.quadratic = uniform(random, 0, 1);
  return in;
}
Inputs direction_light(Engine& random, double) {
  return in_space(random, Path::direction_light, 1, 1);
}
Inputs huge(Engine& random, double decades) {
  const double normal_scale = random_scale(random, 0, decades), scale = random_scale(random, 0, decades);
  return in_space(random, Path::point_light, scale, normal_scale);
}
Inputs tiny(Engine& random, double decades) {
  const double normal_scale = random_scale(random, -decades, 0), scale = random_scale(random, -decades, 0);
  return in_space(random, Path::point_light, scale, normal_scale);
}

constexpr Family for_phong[] = {
    {"ordinary", "light and eye with cosines of at least 0.1 to the normal, glossiness 1 to 128", ordinary},
    {"highlight", "glossiness 1 to 1e4, within three radii of the middle of the highlight", highlight},
    {"sharp highlight", "the same, glossiness 1e4 to 1e6", sharp},
    {"whole glossiness", "1 to 1921, within three radii of the middle of the highlight", whole},
    {"soft", "glossiness 1e-3 to 1", soft},
    {"grazing", "light and eye with cosines of 1e-6 to 0.05", grazing},
    {"opposite", "light and eye 1e-6 to 0.1 above opposite horizons: l + v as short", opposite},
    {"retro", "light within 1e-7 to 0.1 of the eye's direction", retro},
    {"point light", "whole path, as ordinary: lengths of 0.1 to 10, attenuation", point_light},
    {"direction light", "whole path, as ordinary: lengths of 0.1 to 10", direction_light},
    {"huge", "whole path, lengths up to 1e30 (float) or 1e150 (double)", huge},
    {"tiny", "whole path, lengths down to 1e-30 or 1e-150", tiny},
};

constexpr Family for_merl[] = {
    {"ordinary", "light and eye with cosines of at least 0.1 to the normal", ordinary},
    {"uniform", "U: light and eye uniform above the horizon", uniform_pair},
    {"specular", "S: half vector 1e-7 to 0.1 from the normal", specular},
    {"retro", "R: light within 1e-7 to 0.1 of the eye's direction", retro},
    {"grazing", "G: light and eye with cosines of 1e-6 to 0.05", grazing},
    {"plane", "P: light, eye and normal in one plane, up to 1.5 from the normal", plane},
    {"point light", "whole path, as ordinary: lengths of 0.1 to 10, attenuation", point_light},
    {"direction light", "whole path, as ordinary: lengths of 0.1 to 10", direction_light},
};

} // namespace

std::string text(const Inputs& in, Glossiness glossiness) {
  std::string all;
  const auto say = [&](const char* name, const auto& value) {
    all += (all.empty() ? "" : ", ") + (name + (" = " + hex(value)));
  };
  if (in.path == Path::directions) {
    say("n", in.n), say("l", in.l), say("v", in.v);
  } else {
    say("position", in.position), say("normal", in.normal), say("eye", in.eye);
    if (in.path == Path::direction_light) say("direction", in.direction.direction);
    if (in.path == Path::point_light) {
      say("light", in.point.position);
      say("Kc", in.point.constant), say("Kl", in.point.linear), say("Kq", in.point.quadratic);
    }
  }
  say("C", in.radiance);
  if (glossiness == Glossiness::unused) return all;
  say("kd", in.kd), say("ks", in.ks), say("t", in.texture), say("s", in.glossiness);
  return all;
}

std::span<const Family> phong_families() {
  return for_phong;
}
std::span<const Family> merl_families() {
  return for_merl;
}

const Family& family(std::span<const Family> families, std::string_view name) {
  for (const Family& one : families)
    if (one.name == name) return one;
  assert(false);
  return families.front();
}

} // namespace refraster::precision
