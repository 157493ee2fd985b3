#include "raster/shade/opacity.h"

#include "raster/visibility/cut_outs.h"

namespace refraster {
namespace {

using T = DoublePrecision::Number;
static_assert(std::is_same_v<T, DepthTile::Row>);

/// A triangle set up for it.
class TriangleOpacity {
public:
  void set_up(const FrameContext& context, const VisibleTriangle& triangle) {
    uncommon_.large.clear(), uncommon_.projective.clear();
    set_up_attributes<double>(context, {&triangle, 1}, {&setup_, 1}, uncommon_);
  }

  /// Of neighbouring pixels, from (x, y) to the right.
  [[gnu::noinline]] T at(const Material& material, int x, int y, int pixels) const {
    PacketList<T> packets;
    packets.add(setup_, x * subpixels + subpixels / 2, y * subpixels + subpixels / 2, pixels);
    return opacity(material, PacketData<T, Triangles::one>(packets.packet(0)));
  }

private:
  AttributeSetup<double> setup_;
  UncommonEdges uncommon_;
};

class CutOutsByOpacity final : public CutOuts {
public:
  void enter(const FrameContext& context) override {
    context_ = &context;
    known_ = false;
  }

  bool has_cut_outs(std::uint32_t triangle) override {
    if (known_ && triangle == number_) return has_;
    known_ = true, number_ = triangle, set_up_ = false, pixels_ = 0;
    ref_ = TriangleFinder(context_->scene, context_->geometry).at(triangle);
    material_ = &material_of(context_->scene.objects[ref_.object], ref_.triangle);
    return has_ = material_->has_cut_outs();
  }

  MaskOf<T> is_there(int x, int y, int pixels) override {
    if (x == x_ && y == y_ && pixels <= pixels_) return there_; // as for another sample of the same pixel
    if (!set_up_) opacity_.set_up(*context_, {ref_, number_});
    set_up_ = true;
    x_ = x, y_ = y, pixels_ = pixels;
    return there_ = !(opacity_.at(*material_, x, y, pixels) < T(material_->opacity_threshold));
  }

private:
  const FrameContext* context_ = nullptr;
  const Material* material_ = nullptr;
  TriangleRef ref_;
  std::uint32_t number_ = 0;
  bool known_ = false, has_ = false, set_up_ = false;
  TriangleOpacity opacity_;
  int x_ = 0, y_ = 0, pixels_ = 0; // what was asked last of this triangle
  MaskOf<T> there_{};
};

} // namespace

std::unique_ptr<CutOuts> make_cut_outs() {
  return std::make_unique<CutOutsByOpacity>();
}

double opacity_at(const FrameContext& context, std::uint32_t number, int x, int y) {
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  TriangleOpacity of_triangle;
  of_triangle.set_up(context, {ref, number});
  return of_triangle.at(material_of(context.scene.objects[ref.object], ref.triangle), x, y, 1)[0];
}

} // namespace refraster
