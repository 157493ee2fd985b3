// From triangles to fragments: set-up, visibility, and interpolation, on one tile of 64 x 64 pixels.

#include "bench/micro/micro.h"
#include "raster/shade/shade_packet.h"
#include "raster/visibility/visibility.h"
#include "scenes/synthesis/waves.h"

#include <memory>

namespace refraster::micro {
namespace {

constexpr int side = 64; // pixels

/// A tile and what it sees of a sea of triangles, or of two large ones.
struct TileScene {
  Scene scene;
  Geometry geometry;
  Bins bins;
  RenderOptions options;
  TileVisibility visibility{side};
  PixelRect tile{0, 0, side, side};

  explicit TileScene(const Quads& quads) {
    Object object;
    object.mesh = std::make_shared<const Mesh>(waves(quads));
    object.material.fragment_function = Phong{};
    scene.objects.push_back(object);
    scene.camera.position = {0, 0, 3};
    options.width = options.height = options.tile_size = side;
    options.threads = 1;
    transform(context(), geometry);
    FrameCounts counts;
    bin_triangles(context(), geometry, bins, counts);
    decide();
  }

  std::span<const std::uint32_t> triangles() const { return visibility.triangles(); }
  FrameContext context() const { return {{scene, options}, geometry, bins}; }
  void decide() { visibility.decide(context(), 0, tile); }
};

/// The tile's fragments in the number of a precision.
template <class T>
struct TileFragments {
  TileAttributes<RealOf<T>> setups;
  std::vector<FragmentRun> runs;
  UndefinedCounts undefined;
  std::uint32_t fragments = 0;

  explicit TileFragments(const TileScene& on) { collect(on); }

  void collect(const TileScene& on) {
    list_runs(on.visibility, on.tile, 1, runs);
    fragments = setups.collect(on.context(), on.triangles(), runs);
  }

  template <Triangles triangles>
  [[gnu::flatten, gnu::noinline]] void surface(const TileScene& on, const Packet<T>& packet) {
    constexpr int lanes = NumberTraits<T>::lanes;
    const UndefinedTally<T> tally(undefined, first_lanes<RealOf<T>, lanes>(packet.count));
    PacketSurface<T> result;
    packet_surface(on.context(), on.scene.objects[0].material, PacketData<T, triangles>(packet), tally, result);
    benchmark::DoNotOptimize(result);
  }
  void interpolate(const TileScene& on) {
    for (const auto& group : setups.groups())
      for_each_packet<T>(setups, group, on.tile, [&](const Packet<T>& packet, std::uint32_t) {
        if (packet.triangles == Triangles::one) surface<Triangles::one>(on, packet);
        else surface<Triangles::many>(on, packet);
      });
  }
};

void add_tile(const std::string& name, const std::shared_ptr<TileScene>& on) {
  const std::size_t triangles = on->triangles().size(), samples = std::size_t{side} * side;
  add("set-up/" + name, triangles, [on] {
    TriangleFinder finder(on->scene, on->geometry);
    for (const std::uint32_t number : on->triangles()) {
      auto result = set_up_snapped(window_corners(on->geometry, finder.at(number)));
      benchmark::DoNotOptimize(result);
    }
  });
  add("visibility, a triangle/" + name, triangles, [on] { on->decide(); });
  add("visibility, a sample/" + name, samples, [on] { on->decide(); });
  const auto precision = [&]<class R>(R) {
    using T = typename R::Number;
    const auto fragments = std::make_shared<TileFragments<T>>(*on);
    const std::string number = name + "/" + std::string(R::name) + " x" + std::to_string(NumberTraits<T>::lanes);
    add("attribute set-up, a triangle/" + number, triangles, [on, fragments] { fragments->collect(*on); });
    add("interpolation/" + number, fragments->fragments, [on, fragments] { fragments->interpolate(*on); });
  };
  std::apply([&](auto... each) { (precision(each), ...); }, LanePrecisions{});
}

} // namespace

void add_triangles() {
  add_tile("2 large triangles", std::make_shared<TileScene>(Quads{1, 1}));
  add_tile("triangles of 64 pixels", std::make_shared<TileScene>(Quads{20, 11}));
  add_tile("triangles of a pixel", std::make_shared<TileScene>(Quads{114, 64}));
}

} // namespace refraster::micro
