#include "brdf/model.h"

#include "shading/fragment_functions.h"

namespace refraster {
namespace {

template <class Block>
concept Formula = requires(const Block& model, const Double3& direction) {
  { model(direction, direction, direction) } -> std::convertible_to<Rgb<double>>;
};

constexpr Double3 normal{0, 0, 1};

/// A formula says what it is itself; of fragment functions the library has no such line.
template <class Block>
constexpr std::string_view meaning_of() {
  if constexpr (requires { Block::meaning; }) return Block::meaning;
  else if constexpr (std::is_same_v<Block, Phong>) return "kd + ks (r.v)^s / n.l, as the fragment function shades";
  else if constexpr (std::is_same_v<Block, BlinnPhong>) return "kd + ks (n.h)^s / n.l, as the fragment function shades";
  else if constexpr (std::is_same_v<Block, Microfacet>)
    return "metal or a dielectric over its ground, as glTF has them";
  else static_assert(!std::is_same_v<Block, Block>, "the model needs a line of help");
}

} // namespace

Rgb<double> model_value(const BrdfModel& model, const DirectionPair& at) {
  if (!(at.i.z > 0 && at.o.z > 0)) return Rgb<double>(0);
  return std::visit(
      [&]<class Block>(const Block& block) {
        if constexpr (Formula<Block>) return block(normal, at.i, at.o);
        else {
          const Fragment<double> fragment{{}, normal, at.o, Rgb<double>(1)};
          return reflected(block, fragment, Incident<double>{at.i, Rgb<double>(1)}) / at.i.z;
        }
      },
      model);
}

std::string_view model_name(const BrdfModel& model) {
  return std::visit([](const auto& block) { return std::string_view(block.name); }, model);
}

std::string_view model_meaning(const BrdfModel& model) {
  return std::visit([]<class Block>(const Block&) { return meaning_of<Block>(); }, model);
}

} // namespace refraster
