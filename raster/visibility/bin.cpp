#include "raster/visibility/bin.h"

#include "raster/parallel.h"
#include "raster/visibility/runs.h"
#include "raster/visibility/tiny/small_triangles.h"
#include "raster/visibility/tiny/tiny_bin.h"
#include "raster/visibility/touched_tiles.h"
#include "scene/scene_checks.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace refraster {

PixelRect TileGrid::tile(std::size_t index) const {
  const int column = static_cast<int>(index % static_cast<std::size_t>(columns()));
  const int row = static_cast<int>(index / static_cast<std::size_t>(columns()));
  const int left = x + column * tile_size, top = y + row * tile_size;
  return {left, top, std::min(tile_size, x + width - left), std::min(tile_size, y + height - top)};
}

TileGrid tile_grid(const FrameInput& input) {
  const PixelRect& region = input.region;
  return {region.x, region.y, region.width, region.height, input.options.tile_size};
}

const ProjectiveTriangle* Bins::find_projective(std::uint32_t number) const {
  const auto run = std::partition_point(projective.begin(), projective.end(),
                                        [number](const auto& of_run) { return of_run.back().triangle < number; });
  if (run == projective.end()) return nullptr;
  const auto at =
      std::partition_point(run->begin(), run->end(), [number](const auto& one) { return one.triangle < number; });
  return at->triangle == number ? &at->set_up : nullptr;
}

const ProjectiveTriangle& Bins::projective_triangle(std::uint32_t number) const {
  const ProjectiveTriangle* const found = find_projective(number);
  assert(found);
  return *found;
}

namespace {

constexpr int lanes = NumberTraits<Native<double>>::lanes;
using Doubles = Native<double>;
using Ints = VectorOf<std::int32_t, lanes>; // a triangle in each lane
using LaneSet = std::uint32_t;              // a bit for each lane

Ints ints(std::int32_t x) {
  return x - Ints{};
}
std::array<std::int32_t, lanes> listed(const Ints& x) {
  return std::bit_cast<std::array<std::int32_t, lanes>>(x);
}

// Calls body(lane) for each lane of a set, in order.
template <class Body>
void for_each_lane(LaneSet set, Body&& body) {
  for (; set; set &= set - 1) body(std::countr_zero(set));
}

// Bit k of a number moved to bit 4 k: so the sets of four samples become, for each triangle, four bits of its own.
constexpr auto every_fourth = [] {
  std::array<std::uint32_t, 1 << lanes> spread{};
  for (std::uint32_t set = 0; set < spread.size(); ++set)
    for (std::uint32_t lane = 0; lane < lanes; ++lane) spread[set] |= (set >> lane & 1) << 4 * lane;
  return spread;
}();

// A rectangle of pixels in each lane, counted from the grid's corner, ends included.
struct BoxLanes {
  Ints left, top, right, bottom;
  LaneSet empty() const { return negative_lanes((left > right) | (top > bottom)); }
};

class Binner {
public:
  Binner(const FrameInput& input, const Geometry& geometry, const TileGrid& grid)
      : scene_(input.scene), geometry_(geometry), grid_(grid), shape_(image_shape(input)),
        samples_(input.options.samples), columns_(grid.columns()), touched_(grid, input.samples),
        tiny_(grid, input.samples.front()) {
    tile_shift_ = std::countr_zero(static_cast<unsigned>(grid.tile_size));
  }

  // Where one run of triangles goes.
  struct Output {
    TileLists::Run& lists;
    std::vector<NumberedProjective>& projective;
    FrameCounts& counts;
  };

  // A run's triangles of one object: [begin, end) of the frame. `placed` is memory of this thread.
  void bin(const RunPart& part, Buffer<PlacedVertex>& placed, const Output& output) const {
    const Mesh& mesh = *scene_.objects[part.object].mesh;
    const std::uint32_t first = geometry_.first_triangle[part.object];
    if (!indices_within(std::span(mesh.triangles).subspan(part.begin - first, part.end - part.begin),
                        mesh.positions.size()))
      refuse_indices(scene_);
    const PlacedVertex* vertices = nullptr;
    if (geometry_.storage_of(part.object) == Storage::on_demand) {
      place_vertices(geometry_, part.object, placed);
      vertices = placed.data();
    } else {
      vertices = geometry_.window.placed.data() + geometry_.first_vertex[part.object];
    }
    const auto batch = [&](std::uint32_t number, std::uint32_t size) {
      return Batch{part.object, number, number - first, std::min(part.end - number, size), vertices};
    };
    for (std::uint32_t number = part.begin; number < part.end; number += TinyBinner::lanes) {
      if (samples_ == 1 && bin_tiny(batch(number, TinyBinner::lanes), output)) continue;
      bin_register(batch(number, lanes), output);
      if (part.end - number > lanes) bin_register(batch(number + lanes, lanes), output);
    }
  }

private:
  // Consecutive triangles of one object, no more than a register holds, and the vertices of its mesh.
  struct Batch {
    std::uint32_t object, number, in_mesh, count;
    const PlacedVertex* vertices;
  };
  // False, and nothing done, where not all triangles are tiny.
  [[gnu::flatten]] bool bin_tiny(const Batch& batch, const Output& output) const {
    const Mesh& mesh = *scene_.objects[batch.object].mesh;
    const auto* const triangles = &mesh.triangles[batch.in_mesh];
    const PlacedVertex* const vertices = batch.vertices;
    TinyBinner::Binned binned;
    const auto bin = [&](const auto& vertex) {
      return tiny_.bin(vertex, batch.count, scene_.objects[batch.object].cull, output.counts, binned);
    };
    const bool all = batch.count == TinyBinner::lanes;
    if (all ? !bin([&](std::size_t k, int lane) -> const PlacedVertex& { return vertices[triangles[lane][k]]; })
            : !bin([&](std::size_t k, int lane) -> const PlacedVertex& { // lanes to spare repeat the last one
                return vertices[triangles[std::min(lane, static_cast<int>(batch.count) - 1)][k]];
              }))
      return false;
    const auto add_samples = [&](std::uint64_t set) {
      for (; set; set &= set - 1) {
        const auto bit = static_cast<std::uint32_t>(std::countr_zero(set));
        const std::size_t lane = bit / 4, i = bit % 4;
        output.lists.add(
            static_cast<std::size_t>(binned.tile[i][lane]),
            {batch.number + bit / 4, static_cast<std::uint32_t>(binned.place[i][lane]), binned.z[i][lane]});
      }
    };
    if (binned.small == binned.drawn) [[likely]] {
      add_samples(binned.covered);
      return true;
    }
    for_each_lane(binned.drawn, [&](int lane) {
      const auto k = static_cast<std::size_t>(lane);
      if (binned.small >> lane & 1) add_samples(binned.covered & std::uint64_t{15} << 4 * lane);
      else
        add_box(batch, lane, {binned.left[k], binned.top[k], binned.right[k], binned.bottom[k]}, binned.z_min[k],
                output.lists);
    });
    return true;
  }

  struct Window {
    CornerLanes<lanes> corner[3];
  };

  Window window_of(const Batch& batch) const {
    const PlacedVertex* const vertices = batch.vertices;
    const auto* triangles = &scene_.objects[batch.object].mesh->triangles[batch.in_mesh];
    std::array<std::array<std::uint32_t, 3>, lanes> repeated;
    if (batch.count < lanes) { // lanes to spare repeat the last one
      for (std::uint32_t lane = 0; lane < lanes; ++lane) repeated[lane] = triangles[std::min(lane, batch.count - 1)];
      triangles = repeated.data();
    }
    const auto corner = [&](std::size_t k) {
      return gather_corners<lanes>(
          [&](int lane) -> const PlacedVertex& { return vertices[triangles[static_cast<std::size_t>(lane)][k]]; });
    };
    return {{corner(0), corner(1), corner(2)}};
  }

  // The pixels p whose samples may lie in the bounding box: 256 p + last >= min and 256 p + first <= max.
  BoxLanes bounding_box(const Window& window) const {
    const auto& [v0, v1, v2] = window.corner;
    const auto ceiling = [](const Ints& a) { return (a + (subpixels - 1)) >> 8; };
    return {ceiling(lesser(v0.x_subpixel, lesser(v1.x_subpixel, v2.x_subpixel)) - touched_.last_x) - grid_.x,
            ceiling(lesser(v0.y_subpixel, lesser(v1.y_subpixel, v2.y_subpixel)) - touched_.last_y) - grid_.y,
            ((greater(v0.x_subpixel, greater(v1.x_subpixel, v2.x_subpixel)) - touched_.first_x) >> 8) - grid_.x,
            ((greater(v0.y_subpixel, greater(v1.y_subpixel, v2.y_subpixel)) - touched_.first_y) >> 8) - grid_.y};
  }

  [[gnu::flatten]] void bin_register(const Batch& batch, const Output& output) const {
    const Window window = window_of(batch);
    const auto& [v0, v1, v2] = window.corner;
    using Words = VectorOf<std::int32_t, 2 * lanes>;
    const Words all = v0.words & v1.words & v2.words, any = v0.words | v1.words | v2.words;
    const auto split_words = [](const Words& words) {
      return [&]<int... I>(std::integer_sequence<int, I...>) {
        return std::pair<Ints, Ints>(__builtin_shufflevector(words, words, (2 * I)...),
                                     __builtin_shufflevector(words, words, (2 * I + 1)...));
      }
      (std::make_integer_sequence<int, lanes>{});
    };
    const auto [any_side, any_state] = split_words(any);
    const Ints all_sides = split_words(all).first;
    constexpr int not_finite = outcode::not_finite >> 6, unsnapped = outcode::unsnapped >> 6;

    // Each lane leaves at the first reason to.
    LaneSet left = (1u << batch.count) - 1;
    const auto leave = [&left](LaneSet set) {
      const LaneSet leaving = left & set;
      left &= ~set;
      return leaving;
    };
    const auto count = [](LaneSet set) { return static_cast<std::uint64_t>(std::popcount(set)); };
    FrameCounts& counts = output.counts;
    counts.not_finite += count(leave(negative_lanes((any_state & not_finite) != 0)));
    counts.outside += count(leave(negative_lanes((all_sides & outcode::sides) != 0)));
    const LaneSet projective = leave(negative_lanes((any_state & unsnapped) != 0));

    const Doubles area = (v1.x - v0.x) * (v2.y - v0.y) - (v2.x - v0.x) * (v1.y - v0.y); // twice; > 0 seen from behind
    counts.degenerate += count(leave(lane_set(area == Doubles(0.0))));
    if (scene_.objects[batch.object].cull == Cull::back) counts.culled += count(leave(lane_set(area > Doubles(0.0))));
    BoxLanes box = bounding_box(window);
    counts.between_samples += count(leave(box.empty()));
    box.left = greater(box.left, Ints{}), box.right = lesser(box.right, ints(grid_.width - 1));
    box.top = greater(box.top, Ints{}), box.bottom = lesser(box.bottom, ints(grid_.height - 1));
    counts.outside += count(leave(box.empty()));

    counts.drawn += count(left);
    counts.clipped += count(left & negative_lanes((any_side & (outcode::near | outcode::far)) != 0));
    const LaneSet small =
        samples_ == 1 ? left & ~negative_lanes(((box.right - box.left) > 1) | ((box.bottom - box.top) > 1)) : 0;
    if (small == left && projective == 0) {
      if (small) add_samples(covered_samples(window, box, small), batch, output);
    } else {
      add_one_by_one(batch, window, box, {projective, left, small}, output);
    }
  }

  // The samples that small triangles cover, as list entries: those of one triangle side by side.
  struct SampleLanes {
    std::uint32_t covered; // bit 4 lane + i: sample i of SmallCoverage
    std::array<std::array<std::int32_t, lanes>, 4> tile, place;
    std::array<std::array<double, lanes>, 4> z;
  };
  SampleLanes covered_samples(const Window& window, const BoxLanes& box, LaneSet small) const {
    const auto sample = [](const Ints& pixel, int corner, int offset) {
      return numbers<lanes>((pixel + corner) * subpixels + offset);
    };
    const auto coverage =
        cover_small(set_up_snapped(window.corner[0], window.corner[1], window.corner[2]),
                    sample(box.left, grid_.x, touched_.first_x), sample(box.top, grid_.y, touched_.first_y));
    // Beyond the box, which the grid may have cut, there is nothing.
    const LaneSet two_wide = negative_lanes(box.left < box.right), two_high = negative_lanes(box.top < box.bottom);
    const std::array<LaneSet, 4> within{small, small & two_wide, small & two_high, small & two_wide & two_high};
    SampleLanes result;
    result.covered = 0;
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Ints x = box.left + (i & 1), y = box.top + (i >> 1), in_tile = ints(grid_.tile_size - 1);
      result.tile[at] = listed((y >> tile_shift_) * columns_ + (x >> tile_shift_));
      result.place[at] = listed((x & in_tile) | (y & in_tile) << 8 |
                                static_cast<std::int32_t>(TileEntry::bytes(0, 0, TileEntry::sample_mark, 0)));
      result.z[at] = refraster::listed(coverage.z[at]);
      result.covered |= every_fourth[coverage.lanes[at] & within[at]] << i;
    }
    return result;
  }
  static void add_samples(const SampleLanes& samples, const Batch& batch, const Output& output) {
    for (std::uint32_t set = samples.covered; set; set &= set - 1) {
      const auto bit = static_cast<std::uint32_t>(std::countr_zero(set));
      const std::size_t lane = bit / 4, i = bit % 4;
      output.lists.add(
          static_cast<std::size_t>(samples.tile[i][lane]),
          {batch.number + bit / 4, static_cast<std::uint32_t>(samples.place[i][lane]), samples.z[i][lane]});
    }
  }

  struct Sets {
    LaneSet projective, snapped, small;
  };
  [[gnu::noinline]] void add_one_by_one(const Batch& batch, const Window& window, const BoxLanes& box, const Sets& sets,
                                        const Output& output) const {
    const auto& [v0, v1, v2] = window.corner;
    const auto left = listed(box.left), right = listed(box.right);
    const auto top = listed(box.top), bottom = listed(box.bottom);
    const auto z_min = refraster::listed(min(v0.z, min(v1.z, v2.z)));
    SampleLanes samples;
    if (sets.small) samples = covered_samples(window, box, sets.small);
    const std::uint32_t covered = sets.small ? samples.covered : 0;
    for_each_lane(sets.projective | sets.snapped, [&](int lane) {
      const auto k = static_cast<std::size_t>(lane);
      const std::uint32_t number = batch.number + static_cast<std::uint32_t>(lane);
      if (sets.projective >> lane & 1) {
        add_projective(batch, number, output);
      } else if (sets.small >> lane & 1) {
        samples.covered = covered & 15u << 4 * lane;
        add_samples(samples, batch, output);
      } else {
        add_box(batch, lane, {left[k], top[k], right[k], bottom[k]}, z_min[k], output.lists);
      }
    });
  }

  struct Box {
    int left, top, right, bottom; // pixels of the grid
  };
  // On the lattice.
  std::array<WindowVertex, 3> corners_of(const Batch& batch, int lane) const {
    std::array<WindowVertex, 3> corners;
    const auto& triangle =
        scene_.objects[batch.object].mesh->triangles[batch.in_mesh + static_cast<std::uint32_t>(lane)];
    for (std::size_t k = 0; k < 3; ++k) {
      const PlacedVertex& v = batch.vertices[triangle[k]];
      corners[k] = {v.x(), v.y(), v.z, 0, v.outcode()};
    }
    return corners;
  }
  // Lists a triangle with each tile that it may touch. Where the bounding box holds many tiles, its edge functions rule
  // out those beside a long thin triangle.
  void add_box(const Batch& batch, int lane, const Box& box, double z_min, TileLists::Run& lists) const {
    const std::uint32_t number = batch.number + static_cast<std::uint32_t>(lane);
    const int left = box.left >> tile_shift_, right = box.right >> tile_shift_;
    const int top = box.top >> tile_shift_, bottom = box.bottom >> tile_shift_;
    const auto add = [&](int column, int row) {
      const int x = column << tile_shift_, y = row << tile_shift_, last = grid_.tile_size - 1;
      lists.add(index(column, row),
                TileEntry::box(number, std::max(box.left - x, 0), std::max(box.top - y, 0),
                               std::min(box.right - x, last), std::min(box.bottom - y, last), z_min));
    };
    if (left == right && top == bottom) return add(left, top);
    if ((right - left) * (bottom - top) >= 2) {
      if (const auto set_up = set_up_snapped(corners_of(batch, lane)))
        touched_.for_each(set_up->edge, {left, top, right, bottom}, add);
      return;
    }
    for (int row = top; row <= bottom; ++row)
      for (int column = left; column <= right; ++column) add(column, row);
  }

  void add_projective(const Batch& batch, std::uint32_t number, const Output& output) const {
    const Object& object = scene_.objects[batch.object];
    const TriangleRef ref = TriangleFinder(scene_, geometry_).at(number);
    std::array<Double4, 3> clip;
    const auto& corners = object.mesh->triangles[ref.triangle];
    for (std::size_t k = 0; k < 3; ++k)
      clip[k] = clip_position(geometry_.transforms[batch.object], object.mesh->positions[corners[k]]);
    const auto set_up = set_up_projective(window_corners(geometry_, ref), clip, shape_);
    if (!set_up) {
      ++output.counts.degenerate;
    } else if (object.cull == Cull::back && set_up->facing == Facing::back) {
      ++output.counts.culled;
    } else {
      ++output.counts.drawn, ++output.counts.clipped;
      // What a GPU whose lattice is coarser may see beside a pixel of the image is still known to `verify`: hence a
      // pixel more.
      const PixelRect around{grid_.x - 1, grid_.y - 1, grid_.width + 2, grid_.height + 2};
      if (!touched_.touches(*set_up, around)) return;
      output.projective.push_back({number, *set_up});
      touched_.for_each(
          *set_up, [&](int column, int row) { output.lists.add(index(column, row), TileEntry::projective(number)); });
    }
  }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  const Scene& scene_;
  const Geometry& geometry_;
  const TileGrid& grid_;
  ImageShape shape_;
  int samples_, columns_;
  int tile_shift_ = 0; // tile_size is a power of two
  TouchedTiles touched_;
  TinyBinner tiny_;
};

} // namespace

void bin_triangles(const FrameInput& input, const Geometry& geometry, Bins& bins, FrameCounts& counts) {
  const TileGrid grid = tile_grid(input);
  const Binner binner(input, geometry, grid);
  const int threads = input.threads;
  counts.triangles = geometry.triangles();

  for (std::uint32_t o = 0; o < input.scene.objects.size(); ++o)
    if (geometry.storage_of(o) == Storage::outside)
      counts.outside += geometry.first_triangle[o + 1] - geometry.first_triangle[o];
  const std::vector<std::vector<RunPart>> parts = runs_of(geometry, threads);
  const std::size_t runs = parts.size();
  bins.projective.resize(runs);
  for (std::vector<NumberedProjective>& of_run : bins.projective) of_run.clear();
  std::vector<FrameCounts> run_counts(runs);
  std::vector<Buffer<PlacedVertex>> placed(static_cast<std::size_t>(threads));
  bins.lists.reset(runs, grid.tiles());
  parallel_for(threads, runs, [&](std::size_t run, int thread) {
    for (const RunPart& part : parts[run])
      binner.bin(part, placed[static_cast<std::size_t>(thread)],
                 {bins.lists.run(run), bins.projective[run], run_counts[run]});
  });

  for (const FrameCounts& of_run : run_counts) counts += of_run;
  std::erase_if(bins.projective, [](const auto& of_run) { return of_run.empty(); });
}

} // namespace refraster
