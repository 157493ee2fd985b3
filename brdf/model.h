#pragma once
// Reflectance by a formula, with parameters that have names: the declared list.

#include <refraster/fields.h>
#include <refraster/material.h>

#include "scenes/synthesis/merl_synthesis.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace refraster {

/// Every model that the commands of `refraster brdf` take by name. A row is either
///   a formula            f(n, i, o) in 1/sr: scenes/synthesis/analytic_brdfs.h
///   a fragment function  <refraster/material.h>: f is what it reflects of one light of radiance 1, by n.i; without its
///                        ambient term, with a white texture
/// and has `name`, `fields` and, in model.cpp, a line of help. Reading, help, `brdf synth` and the tests follow.
using BrdfModel = std::variant<Lambert, Phong, BlinnPhong, Microfacet, GgxConductor, GgxDielectric>;

/// Calls use(Block{}) for each of the list, with the parameters that it has by default.
template <class Use>
void for_each_model(const Use& use) {
  [&]<class... Models>(const std::variant<Models...>*) { (use(Models{}), ...); }(static_cast<BrdfModel*>(nullptr));
}

/// False of a parameter on which no f depends: ambient light is no reflection.
constexpr bool is_of_f(std::string_view parameter) {
  return parameter != "ka";
}

/// The same of a block as it is: the indices of a metal count only where its law is that of conductors.
template <class Block>
bool is_of_f(const Block& block, std::string_view parameter) {
  if constexpr (std::is_same_v<Block, Microfacet>)
    if (block.fresnel != MicrofacetFresnel::conductor && (parameter == "eta" || parameter == "k")) return false;
  return is_of_f(parameter);
}

/// f in 1/sr toward o of light from i, unit vectors over a surface with normal (0, 0, 1); 0 unless both are above it.
Rgb<double> model_value(const BrdfModel& model, const DirectionPair& at);

std::string_view model_name(const BrdfModel& model);

/// A phrase: "rough metal".
std::string_view model_meaning(const BrdfModel& model);

/// What is wrong with the words for a model: "blinn_phong:ks: found "x", expected …". found: as it is to be printed.
struct ModelFault {
  std::string place, found, expected;
};

/// Lobes that add up, or why they cannot be read.
struct ReadModels {
  std::vector<BrdfModel> lobes;
  std::vector<ModelFault> faults; // one, or none
};

/// Reads "NAME", "NAME:KEY=VALUE,KEY=VALUE", or several of these with '+' between them, whose values add up. NAME is
/// that of a model, "diffuse" for lambert, or that of a preset (brdf_presets()); '-' and '_' are the same. A colour is
/// one number, or three with commas between them. What is not given is as by default.
ReadModels read_models(std::string_view text);

/// Whether a user who writes this means a model, and no file: its name is that of a model or a preset, or ':' follows
/// a name that is no path.
bool means_model(std::string_view text);

/// Names of models and presets, in the order of the lists.
std::vector<std::string_view> model_names();

// Values of parameters as text. `read_parameter` is false if the text is not what `expected_parameter` says.
bool read_parameter(double& value, std::string_view text, const Range& range);
/// One number for all channels, or three with commas between them.
bool read_parameter(Double3& value, std::string_view text, const Range& range);
std::string expected_parameter(const double& value, const Range& range);
std::string expected_parameter(const Double3& value, const Range& range);

/// "0.5"; of a colour that is no grey "0.5,0.4,0.3". The shortest that reads back as the same numbers.
std::string parameter_text(double value);
std::string parameter_text(const Double3& value);

/// "blinn_phong:kd=0.5,ks=0.1,glossiness=32": read_models reads the same values back, but for parameters on which f
/// does not depend, which are left out.
std::string model_text(const BrdfModel& model);
/// The same of several that add up.
std::string model_text(const std::vector<BrdfModel>& lobes);

} // namespace refraster
