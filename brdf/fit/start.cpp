#include "brdf/fit/start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace refraster {
namespace {

constexpr double max_theta_h = std::numbers::pi / 3;
constexpr int d_of_shape = 22, p_of_shape = 89; // theta_d = 22.5, phi_d = 89.5 degrees

/// Widest half width: beyond, a highlight is hardly one.
constexpr double max_half_width = 1.2; // radians

double clamped_width(double half_width) {
  return std::min(half_width, max_half_width);
}

Double3 clamped(const Rgb<double>& rgb, double least, double greatest) {
  return {std::clamp(rgb.x, least, greatest), std::clamp(rgb.y, least, greatest), std::clamp(rgb.z, least, greatest)};
}

/// How the k-th of several lobes compares with a single one.
struct LobePart {
  double width, height;
};
LobePart part_of(int k) {
  return {std::pow(3.0, k), std::pow(3.0, -k)};
}

/// kd, and ks (cos)^s / n.l: cos^s is 1/2 at the half width. angle_ratio: of the angle whose cosine that is to theta_h.
template <class Block>
std::vector<BrdfModel> start_of_phong(const HighlightShape& shape, int lobes, double width, double angle_ratio) {
  std::vector<BrdfModel> result;
  for (int k = 0; k < lobes; ++k) {
    const LobePart part = part_of(k);
    Block block;
    block.ka = Double3(0);
    block.kd = k == 0 ? Double3(shape.diffuse) : Double3(0);
    block.ks = Double3(shape.specular) * (shape.cos_theta_d * part.height);
    const double angle = clamped_width(shape.half_width * width * part.width * angle_ratio);
    block.glossiness = std::log(0.5) / std::log(std::cos(angle));
    result.push_back(block);
  }
  return result;
}

std::vector<BrdfModel> start_of_blinn_phong(const HighlightShape& shape, int lobes, double width) {
  return start_of_phong<BlinnPhong>(shape, lobes, width, 1);
}

/// At phi_d = 90 degrees a half vector that is theta_h from the normal moves the mirror direction by twice that, about
/// an axis theta_d from it.
std::vector<BrdfModel> start_of_plain_phong(const HighlightShape& shape, int lobes, double width) {
  return start_of_phong<Phong>(shape, lobes, width, 2 * shape.cos_theta_d);
}

/// D falls to a half where alpha^2 cos^2 + sin^2 = sqrt(2) alpha^2.
double alpha_of(double half_width) {
  const double sine = std::sin(clamped_width(half_width));
  return std::clamp(std::sqrt(sine * sine / (std::numbers::sqrt2 - 1 + sine * sine)), 2e-4, 0.95);
}

/// D G / (4 n.i n.o) where the half vector is the normal.
double ggx_peak(double alpha, double cosine) {
  return ggx_density(Double3(0, 0, 1), Double3(0, 0, 1), alpha) * ggx_visibility(cosine, cosine, alpha);
}

/// Reflectance at normal incidence that gives the highlight its height, over a lobe of that width.
Rgb<double> f0_of(const HighlightShape& shape, double alpha, int k) {
  return shape.specular * (part_of(k).height / ggx_peak(alpha, shape.cos_theta_d));
}

/// What lies under a boundary of that reflectance, passed twice.
Double3 ground_of(const HighlightShape& shape, double f0, double visible) {
  return clamped(shape.diffuse * (std::numbers::pi / (square(1 - f0) * visible)), 0.001, 0.99);
}

double index_of(double f0) {
  return (1 + std::sqrt(f0)) / (1 - std::sqrt(f0));
}

std::vector<BrdfModel> start_of_conductor(const HighlightShape& shape, int lobes, double width) {
  std::vector<BrdfModel> result;
  for (int k = 0; k < lobes; ++k) {
    GgxConductor block;
    block.alpha = alpha_of(shape.half_width * width * part_of(k).width);
    block.f0 = clamped(f0_of(shape, block.alpha, k), 0.01, 0.99);
    result.push_back(block);
  }
  return result;
}

std::vector<BrdfModel> start_of_dielectric(const HighlightShape& shape, int lobes, double width) {
  std::vector<BrdfModel> result;
  for (int k = 0; k < lobes; ++k) {
    GgxDielectric block;
    block.alpha = alpha_of(shape.half_width * width * part_of(k).width);
    const double f0 = std::clamp(luminance(f0_of(shape, block.alpha, k)), 0.005, 0.6);
    block.ior = index_of(f0);
    block.albedo = k == 0 ? ground_of(shape, f0, 1) : Double3(0);
    result.push_back(block);
  }
  return result;
}

/// Further lobes of a Microfacet are those of metal: what is left of the ground is the first one's.
std::vector<BrdfModel> start_of_microfacet(const HighlightShape& shape, int lobes, double width, const auto& first) {
  std::vector<BrdfModel> result;
  for (int k = 0; k < lobes; ++k) {
    Microfacet block;
    const double alpha = alpha_of(shape.half_width * width * part_of(k).width);
    block.roughness = std::sqrt(alpha);
    const Rgb<double> f0 = f0_of(shape, alpha, k);
    if (k == 0) first(block, f0);
    else block.base_color = clamped(f0, 0.01, 0.99);
    result.push_back(block);
  }
  return result;
}

/// With F the reflectance of the index, s and d the luminance of highlight and ground, and q = 1 - metallic:
///     s = q F + (1 - q) b,   d = q b,   hence F q^2 - (s + d) q + d = 0, of which this is the smaller root.
std::vector<BrdfModel> start_with_metal(const HighlightShape& shape, int lobes, double width) {
  return start_of_microfacet(shape, lobes, width, [&](Microfacet& block, const Rgb<double>& f0) {
    const double f = square((block.ior - 1) / (block.ior + 1));
    const double d = luminance(shape.diffuse) * std::numbers::pi / square(1 - f), sum = luminance(f0) + d;
    const double root = std::sqrt(std::max(sum * sum - 4 * f * d, 0.0));
    block.metallic = std::clamp(1 - 2 * d / (sum + root), 0.01, 0.99);
    const double rest = 1 - block.metallic;
    block.base_color = block.metallic > 0.5 ? clamped((f0 - Rgb<double>(rest * f)) / block.metallic, 0.01, 0.99)
                                            : ground_of(shape, f, rest);
  });
}

std::vector<BrdfModel> start_without_metal(const HighlightShape& shape, int lobes, double width) {
  return start_of_microfacet(shape, lobes, width, [&](Microfacet& block, const Rgb<double>& f0) {
    const double f = std::clamp(luminance(f0), 0.005, 0.6);
    block.metallic = 0;
    block.ior = index_of(f);
    block.base_color = ground_of(shape, f, 1);
  });
}

double theta_h_of(int h) {
  const double root = (h + 0.5) / MerlTable::theta_h_bins;
  return std::numbers::pi / 2 * root * root;
}

} // namespace

std::optional<HighlightShape> highlight_shape(const Brdf& brdf) {
  std::vector<std::pair<double, Rgb<double>>> line; // theta_h, f
  HighlightShape shape;
  shape.cos_theta_d = std::cos((d_of_shape + 0.5) * std::numbers::pi / 180);
  shape.diffuse = Rgb<double>(std::numeric_limits<double>::infinity());
  for (int h = 0; h < MerlTable::theta_h_bins; ++h) {
    const DirectionPair pair = directions_at_centre(h, d_of_shape, p_of_shape);
    const BrdfValue value = brdf.value(pair);
    if (!value.measured) continue;
    line.emplace_back(theta_h_of(h), value.f);
    // Near the horizon n.l divides what fragment functions shade, and dielectrics let no light through.
    if (theta_h_of(h) > max_theta_h) continue;
    for (int c = 0; c < 3; ++c) shape.diffuse[c] = std::min(shape.diffuse[c], std::max(value.f[c], 0.0));
  }
  if (line.empty() || line.front().first > max_theta_h) return std::nullopt;
  // A lobe without any height would have no width to fit: one so broad that it is not seen begins with a tenth.
  for (int c = 0; c < 3; ++c) {
    const double floor = std::max(shape.diffuse[c] / 10, std::numeric_limits<double>::min());
    shape.specular[c] = std::max(line.front().second[c] - shape.diffuse[c], floor);
  }
  const double ground = luminance(shape.diffuse), half = ground + luminance(shape.specular) / 2;
  shape.half_width = line.back().first;
  // So broad that nothing stands out, or so narrow that it is not there: the first is what fits have to find.
  if (luminance(line.front().second) <= half) return shape;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const double f = luminance(line[k].second);
    if (f > half) continue;
    // Between two bins, in theta_h.
    const double before = luminance(line[k - 1].second), from = line[k - 1].first;
    shape.half_width = from + (line[k].first - from) * (before - half) / (before - f);
    break;
  }
  return shape;
}

const std::vector<FittedModel> fitted_models = {{Phong::name, {start_of_plain_phong}},
                                                {BlinnPhong::name, {start_of_blinn_phong}},
                                                {Microfacet::name, {start_with_metal, start_without_metal}},
                                                {GgxConductor::name, {start_of_conductor}},
                                                {GgxDielectric::name, {start_of_dielectric}}};

const FittedModel* find_fitted_model(std::string_view name) {
  const auto found = std::find_if(fitted_models.begin(), fitted_models.end(),
                                  [&](const FittedModel& model) { return model.name == name; });
  return found == fitted_models.end() ? nullptr : &*found;
}

} // namespace refraster
