// Reflection by microfacets: by hand, against 60 digits and other formulas, its energy, and where it is extreme.

#include "math/bounds/affine_functions.h"
#include "math/exact.h"
#include "scenes/synthesis/analytic_brdfs.h"
#include "shading/microfacet/microfacet.h"
#include "tests/support/shading/directions.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

using namespace refraster;

namespace {

constexpr double pi = std::numbers::pi;

/// f n.l of a light from i, toward o.
template <class T>
Rgb<T> lit(const Microfacet& function, const Vec3<T>& n, const Vec3<T>& i, const Vec3<T>& o) {
  const Fragment<T> at{Vec3<T>(T(0)), n, o, Rgb<T>(T(1))};
  return reflected(function, at, Incident<T>{i, Rgb<T>(T(1))});
}
template <class T>
Rgb<T> lit(const Microfacet& function, const SurfacePair& at) {
  return lit<T>(function, as<T>(at.n), as<T>(at.i), as<T>(at.o));
}

Microfacet surface(double roughness, double metallic, MicrofacetFresnel fresnel = MicrofacetFresnel::schlick) {
  Microfacet function;
  function.base_color = {0.9, 0.5, 0.2};
  function.roughness = roughness, function.metallic = metallic, function.fresnel = fresnel;
  return function;
}

/// Every law, from mirror to blackboard.
std::vector<Microfacet> all_surfaces() {
  std::vector<Microfacet> list;
  for (const auto& [fresnel, name] : EnumNames<MicrofacetFresnel>::names)
    for (const double roughness : {0.0, 1e-3, 0.03, 0.3, 1.0})
      for (const double metallic : {0.0, 0.3, 1.0}) list.push_back(surface(roughness, metallic, fresnel));
  return list;
}

SurfacePair some_pair(std::mt19937_64& random, int k) {
  SurfacePair at = k % 3 == 0   ? random_pair(random)
                   : k % 3 == 1 ? specular_pair(random)
                                : opposite_grazing_pair(random);
  if (k % 7 == 0) at.o = mirrored(at.i, at.n);
  if (k % 11 == 0) at.o = at.i;
  return at;
}

/// The formula as textbooks have it, with angles by n.h and v.h.
Rgb<Exact> textbook(const Microfacet& m, const Vec3<Exact>& n, const Vec3<Exact>& l, const Vec3<Exact>& v) {
  const auto number = [](double x) { return Exact(x); };
  const Exact one(1), n_l = dot(n, l), n_v = dot(n, v);
  if (!(n_l > number(0) && n_v > number(0))) return Rgb<Exact>(number(0));
  const Vec3<Exact> h = normalize(l + v);
  const Exact n_h = dot(n, h), v_h = dot(v, h), inverse_pi = constant<Exact>(constants::one_over_pi);
  const Exact r = number(std::max(m.roughness, 1e-4)), alpha = r * r, a = alpha * alpha;
  const Exact bracket = n_h * n_h * (a - one) + one, d = a * inverse_pi / (bracket * bracket);
  const auto lambda = [&](const Exact& cosine) {
    const Exact tangent_2 = (one - cosine * cosine) / (cosine * cosine);
    return (sqrt(one + a * tangent_2) - one) / number(2);
  };
  const Exact g = one / (one + lambda(n_l) + lambda(n_v));
  const auto fifth = [&](const Exact& c) { return (one - c) * (one - c) * (one - c) * (one - c) * (one - c); };
  const Exact ior = number(m.ior), root = (ior - one) / (ior + one), f0 = root * root;
  const auto of_dielectric = [&](const Exact& c) { // by Snell's and Fresnel's laws
    const Exact inside = sqrt(one - (one - c * c) / (ior * ior));
    const Exact s = (c - ior * inside) / (c + ior * inside), p = (ior * c - inside) / (ior * c + inside);
    return (s * s + p * p) / number(2);
  };
  const auto of_conductor = [&](int channel) { // with complex numbers: root of (eta + i k)^2 - sin^2
    const Exact eta = number(m.eta[channel]), k = number(m.k[channel]), sine_2 = one - v_h * v_h;
    const Exact re = eta * eta - k * k - sine_2, im = number(2) * eta * k, size = sqrt(re * re + im * im);
    const Exact x = sqrt((size + re) / number(2)), y = sqrt((size - re) / number(2));
    const auto squared = [](const Exact& u, const Exact& w) { return u * u + w * w; };
    const Exact s = squared(v_h - x, y) / squared(v_h + x, y);
    const Exact e_re = eta * eta - k * k, e_im = im;
    const Exact p = squared(e_re * v_h - x, e_im * v_h - y) / squared(e_re * v_h + x, e_im * v_h + y);
    return (s + p) / number(2);
  };
  Rgb<Exact> result;
  for (int c = 0; c < 3; ++c) {
    const Exact base = number(m.base_color[c]), metal = number(m.metallic);
    Exact f, through;
    if (m.fresnel == MicrofacetFresnel::schlick) {
      const Exact mixed = f0 * (one - metal) + base * metal;
      f = mixed + (one - mixed) * fifth(v_h);
      through = (one - f0 - (one - f0) * fifth(n_l)) * (one - f0 - (one - f0) * fifth(n_v));
    } else {
      const Exact of_metal =
          m.fresnel == MicrofacetFresnel::conductor ? of_conductor(c) : base + (one - base) * fifth(v_h);
      f = of_dielectric(v_h) * (one - metal) + of_metal * metal;
      through = (one - of_dielectric(n_l)) * (one - of_dielectric(n_v));
    }
    result[c] = d * g * f / (number(4) * n_v) + (one - metal) * base * inverse_pi * through * n_l;
  }
  return result;
}

/// The fraction of light from a direction at that cosine that is reflected, without the diffuse part: microfacets are
/// drawn by their density, tan^2 theta = a u / (1 - u), and each weighs f n.l 4 (v.h) / (D n.h).
double albedo_of_lobe(const Microfacet& function, double cosine, int steps) {
  const Double3 n(0, 0, 1), v(std::sqrt(1 - cosine * cosine), 0, cosine);
  const double a = std::pow(function.roughness, 4);
  double sum = 0;
  for (int r = 0; r < steps; ++r)
    for (int s = 0; s < steps; ++s) {
      const double u = (r + 0.5) / steps, phi = 2 * pi * (s + 0.5) / steps, tangent_2 = a * u / (1 - u);
      const double n_h = 1 / std::sqrt(1 + tangent_2), sine = std::sqrt(tangent_2) * n_h;
      const Double3 h(sine * std::cos(phi), sine * std::sin(phi), n_h);
      const double v_h = dot(v, h);
      if (v_h <= 0) continue;
      const Fragment<double> at{Double3(0), n, v, Double3(1)};
      const MicrofacetTerms<double> terms = microfacet_terms(function, at, h * (2 * v_h) - v);
      sum += terms.fresnel.x * terms.cosine_over_divisor * (terms.specular.x > 0 ? 4 * v_h / n_h : 0);
    }
  return sum / (steps * steps);
}

/// That of the diffuse part: midpoints of squared sines.
double albedo_of_ground(const Microfacet& function, double cosine, int steps) {
  const Double3 n(0, 0, 1), v(std::sqrt(1 - cosine * cosine), 0, cosine);
  double sum = 0;
  for (int r = 0; r < steps; ++r) {
    const double sine_2 = (r + 0.5) / steps, c = std::sqrt(1 - sine_2);
    const Fragment<double> at{Double3(0), n, v, Double3(1)};
    sum += microfacet_terms(function, at, Double3(0, std::sqrt(sine_2), c)).diffuse.x / c;
  }
  return sum * pi / steps;
}

} // namespace

TEST_CASE("microfacets worked out by hand") {
  const Double3 n(0, 0, 1), slanted(0.6, 0, 0.8), mirror(-0.6, 0, 0.8);
  // Along n: D = 1 / (pi a), G2 = 1, F = f0; a = 0.5^4.
  CHECK(lit<double>(surface(0.5, 1), n, n, n).x == doctest::Approx(0.9 / (4 * pi * 0.0625)));
  // The rest of glass: f0 = 0.04, and 0.96^2 of what the ground reflects.
  CHECK(lit<double>(surface(0.5, 0), n, n, n).y == doctest::Approx(0.04 / (4 * pi * 0.0625) + 0.9216 * 0.5 / pi));
  CHECK(lit<double>(surface(0.5, 0, MicrofacetFresnel::dielectric), n, n, n).y ==
        doctest::Approx(0.04 / (4 * pi * 0.0625) + 0.9216 * 0.5 / pi));
  // A conductor along n: ((eta - 1)^2 + k^2) / ((eta + 1)^2 + k^2).
  Microfacet metal = surface(1, 1, MicrofacetFresnel::conductor);
  metal.eta = Double3(0.5), metal.k = Double3(2);
  CHECK(lit<double>(metal, n, n, n).z == doctest::Approx((0.25 + 4) / (2.25 + 4) / (4 * pi)));
  // Without absorption it is a dielectric.
  CHECK(conductor_reflectance(Incidence<double>{0.8, 0.36}, 1.5, 0.0) ==
        doctest::Approx(dielectric_reflectance(0.8, 1.25)));
  // Mirror direction, n.l = n.v = v.h = 0.8: D = 1 / (pi a), G2 / (4 n.v) = 0.8 / (4 * 0.8 * sqrt(0.0625 + 0.9375 *
  // 0.64)), F = 0.9 + 0.1 * 0.2^5.
  CHECK(lit<double>(surface(0.5, 1), n, slanted, mirror).x ==
        doctest::Approx(0.900032 / (pi * 0.0625) / (4 * std::sqrt(0.0625 + 0.9375 * 0.64))));
  // Below the horizon there is nothing, from neither side.
  CHECK(lit<double>(surface(0.5, 0.5), n, -slanted, mirror) == Double3(0));
  CHECK(lit<double>(surface(0.5, 0.5), n, slanted, -mirror) == Double3(0));
  // A roughness of 0 counts as the least.
  CHECK(lit<double>(surface(0, 1), n, n, n) == lit<double>(surface(1e-4, 1), n, n, n));
}

TEST_CASE("roughness and metallic are multiplied by green and blue of their maps") {
  const Double3 n(0, 0, 1), l(0.6, 0, 0.8), v(-0.48, 0.36, 0.8);
  const FragmentMaps<double> maps{Double3(7, 0.5, 0.25), Double3(0)};
  const Fragment<double> at{Double3(0), n, v, Double3(1), nullptr, &maps};
  const Incident<double> light{l, Double3(1)};
  CHECK(reflected(surface(0.8, 1), at, light) == lit<double>(surface(0.4, 0.25), n, l, v));
}

TEST_CASE("tables are synthesised from the same formulas") {
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    const SurfacePair at = random_pair(random);
    const double n_l = dot(at.n, at.i);
    const Rgb<double> metal = GgxConductor{0.25, {0.9, 0.5, 0.2}}(at.n, at.i, at.o) * n_l;
    const Rgb<double> plastic = GgxDielectric{0.09, 1.5, {0.9, 0.5, 0.2}}(at.n, at.i, at.o) * n_l;
    const Rgb<double> as_metal = lit<double>(surface(0.5, 1), at);
    const Rgb<double> as_plastic = lit<double>(surface(0.3, 0, MicrofacetFresnel::dielectric), at);
    for (int c = 0; c < 3; ++c) {
      REQUIRE(as_metal[c] == doctest::Approx(metal[c]).epsilon(1e-11));
      REQUIRE(as_plastic[c] == doctest::Approx(plastic[c]).epsilon(1e-11));
    }
  }
}

TEST_CASE("60 digits of the formula are those of the textbook, and double has nearly all of its own") {
  // Units in the last place; directions that are not quite of length 1 have other textbook sines and cosines.
  double largest = 0, largest_grazing = 0;
  for (const Microfacet& function : all_surfaces()) {
    CAPTURE(function.roughness);
    CAPTURE(function.metallic);
    CAPTURE(name_of(function.fresnel));
    std::mt19937_64 random(2);
    for (int k = 0; k < 60; ++k) {
      const SurfacePair at = some_pair(random, k);
      const Vec3<Exact> n = normalize(as<Exact>(at.n)), i = normalize(as<Exact>(at.i)), o = normalize(as<Exact>(at.o));
      const Rgb<Exact> exact = lit<Exact>(function, n, i, o), known = textbook(function, n, i, o);
      const Rgb<Exact> of_inputs = lit<Exact>(function, at);
      const Rgb<double> computed = lit<double>(function, at);
      const bool grazing = std::min(dot(at.n, at.i), dot(at.n, at.o)) < 0.1;
      for (int c = 0; c < 3; ++c) {
        REQUIRE(static_cast<double>(abs(exact[c] - known[c]) / max(known[c], Exact(1e-300))) < 1e-25);
        if (computed[c] == 0) continue;
        const double apart = static_cast<double>(abs(Exact(computed[c]) - of_inputs[c]) / of_inputs[c]);
        const double ulps = apart / std::numeric_limits<double>::epsilon();
        (grazing ? largest_grazing : largest) = std::max(grazing ? largest_grazing : largest, ulps);
      }
    }
  }
  if (std::getenv("REFRASTER_PRINT")) MESSAGE(largest << " and, at grazing angles, " << largest_grazing << " ulp");
  CHECK(largest <= 40);
}

TEST_CASE("light and eye may be exchanged") {
  for (const Microfacet& function : all_surfaces()) {
    std::mt19937_64 random(3);
    for (int k = 0; k < 200; ++k) {
      const SurfacePair at = some_pair(random, k);
      const double n_i = dot(at.n, at.i), n_o = dot(at.n, at.o);
      if (!(n_i > 0 && n_o > 0)) continue;
      const Rgb<double> there = lit<double>(function, at), back = lit<double>(function, at.n, at.o, at.i);
      for (int c = 0; c < 3; ++c)
        REQUIRE(there[c] * n_o == doctest::Approx(back[c] * n_i).epsilon(16 * std::numeric_limits<double>::epsilon()));
    }
  }
}

TEST_CASE("no more is reflected than arrives, and by a white mirror all of it") {
  for (const auto& named : EnumNames<MicrofacetFresnel>::names)
    for (const double roughness : {0.02, 0.1, 0.3, 0.5, 0.7, 1.0})
      for (const double metallic : {0.0, 0.5, 1.0})
        for (const double cosine : {1.0, 0.7, 0.4, 0.1, 0.02}) {
          const MicrofacetFresnel fresnel = named.first;
          Microfacet function = surface(roughness, metallic, fresnel);
          function.base_color = Double3(1);
          const double lobe = albedo_of_lobe(function, cosine, 100);
          const double ground = albedo_of_ground(function, cosine, 100), all = lobe + ground;
          CAPTURE(named.second);
          CAPTURE(roughness);
          CAPTURE(metallic);
          CAPTURE(cosine);
          CHECK(all <= 1);
          if (metallic == 1 && fresnel == MicrofacetFresnel::schlick) {
            CHECK(ground == 0);
            if (roughness <= 0.1 && cosine >= 0.4) CHECK(all >= 0.9997);
            // Of alpha 1 D is 1 / pi, and the integral of c / (1 + c) over the cosine remains.
            if (roughness == 1 && cosine == 1) CHECK(all == doctest::Approx(1 - std::log(2)).epsilon(1e-3));
          }
          if (std::getenv("REFRASTER_PRINT") && metallic != 0.5 && fresnel != MicrofacetFresnel::conductor)
            MESSAGE(named.second << ", roughness " << roughness << ", metallic " << metallic << ", n.v " << cosine
                                 << ": " << lobe << " + " << ground);
        }
}

TEST_CASE_TEMPLATE("the formula is finite and not negative for directions of any kind", F, double, float) {
  const std::array<Vec3<F>, 9> directions{{{0, 0, 1},
                                           {0, 0, -1},
                                           {0, 0, 0},
                                           {1, 0, 0},
                                           {-1, 0, 0},
                                           {1, 0, F(1e-30)},
                                           {-1, 0, F(1e-38)},
                                           {F(0.6), 0, F(0.8)},
                                           {1, 0, F(1e-7)}}};
  for (Microfacet function : all_surfaces())
    for (const double ior : {1.0, 1.5, 10.0}) {
      function.ior = ior;
      for (const Vec3<F>& n : directions)
        for (const Vec3<F>& l : directions)
          for (const Vec3<F>& v : directions) {
            const Rgb<F> colour = lit<F>(function, n, l, v);
            for (int c = 0; c < 3; ++c) REQUIRE((colour[c] >= 0 && std::isfinite(colour[c])));
          }
    }
}

TEST_CASE_TEMPLATE("bounds hold what numbers may be", Bounds, Interval<DoubleArithmetic>, Affine<DoubleArithmetic>,
                   Affine<FloatArithmetic>) {
  for (const double half_width : {0.0, 1e-5})
    for (const Microfacet& function : all_surfaces()) {
      CAPTURE(half_width);
      CAPTURE(function.roughness);
      CAPTURE(function.metallic);
      CAPTURE(name_of(function.fresnel));
      std::mt19937_64 random(4);
      for (int k = 0; k < 40; ++k) {
        const SurfacePair at = some_pair(random, k);
        Fragment<Bounds> fragment{Vec3<Bounds>(Bounds(0)), {}, {}, Rgb<Bounds>(Bounds(1))};
        const double more = half_width == 0 ? 0 : half_width * 1.001 + 0x1p-24;
        for (int axis = 0; axis < 3; ++axis) {
          fragment.normal[axis] = {at.n[axis] - more, at.n[axis] + more};
          fragment.to_eye[axis] = {at.o[axis] - more, at.o[axis] + more};
        }
        const Rgb<Bounds> bounds = reflected(function, fragment, {as<Bounds>(at.i), Rgb<Bounds>(Bounds(1))});
        for (int inside = 0; inside < 4; ++inside) {
          SurfacePair moved = at;
          for (int axis = 0; axis < 3; ++axis) {
            moved.n[axis] += uniform(random, -half_width, half_width);
            moved.o[axis] += uniform(random, -half_width, half_width);
          }
          const Rgb<double> point = lit<double>(function, moved);
          for (int c = 0; c < 3; ++c) REQUIRE(bounds[c].contains(point[c]));
          if constexpr (std::is_same_v<Bounds, Affine<FloatArithmetic>>) {
            if (half_width == 0) continue; // a point of doubles is none of floats
            const Rgb<float> single = lit<float>(function, moved);
            for (int c = 0; c < 3; ++c) REQUIRE(bounds[c].contains(static_cast<double>(single[c])));
          }
        }
      }
    }
}
