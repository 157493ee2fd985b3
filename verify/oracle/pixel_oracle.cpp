#include "verify/oracle/pixel_oracle.h"

#include "verify/oracle/exact_light.h"

namespace refraster {

struct PixelOracle::State {
  const Scene& scene;
  oracle::ExactGeometry geometry;
};

PixelOracle::PixelOracle(const Scene& scene, int width, int height)
    : state_(new State{scene, oracle::ExactGeometry(scene, width, height)}) {}
PixelOracle::~PixelOracle() = default;

std::optional<std::array<Twofold<double>, 3>> PixelOracle::radiance(const SeenPixel& pixel) const {
  const auto point = state_->geometry.surface_at({pixel.x, pixel.y, pixel.object, pixel.triangle});
  if (!point) return std::nullopt;
  const auto exact = oracle::radiance(state_->scene, state_->scene.objects[pixel.object], *point);
  if (!exact) return std::nullopt;
  std::array<Twofold<double>, 3> rounded{};
  for (std::size_t c = 0; c < 3; ++c) {
    rounded[c].hi = static_cast<double>((*exact)[c]);
    rounded[c].lo = static_cast<double>((*exact)[c] - rounded[c].hi);
  }
  return rounded;
}

} // namespace refraster
