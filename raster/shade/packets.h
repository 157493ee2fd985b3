#pragma once
// Fragments of one material, packed into registers.

#include "raster/lanes.h"
#include "raster/shade/attribute_setup.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace refraster {

/// Whether a packet's fragments lie in one triangle: its data are then broadcast to all lanes, else read for each.
enum class Triangles : std::uint8_t { one, many };

/// As many fragments as T has lanes: a place in a PacketList, as long as that stays as it is.
template <class T>
struct Packet {
  static constexpr int lanes = NumberTraits<T>::lanes;
  using Real = RealOf<T>;
  using Ints = VectorOf<std::int32_t, lanes>;

  const AttributeSetup<Real>* const* triangle_of_lane = nullptr;
  const std::int32_t *x_of_lane = nullptr, *y_of_lane = nullptr;
  int count = 0; // lanes in use; the others repeat the last one
  Triangles triangles = Triangles::one;
  EdgeKind edges = EdgeKind::wrapped; // the greatest of all lanes

  const AttributeSetup<Real>& triangle(int lane) const { return *triangle_of_lane[lane]; }
  /// Pixel centres, subpixels of the window.
  Ints x() const { return load_lanes<Ints>(x_of_lane); }
  Ints y() const { return load_lanes<Ints>(y_of_lane); }
};

/// Packets that go through shading together. Fragments are appended a run at a time, whole registers being stored, so
/// that a run costs little more than a pixel of it.
template <class T>
class PacketList {
public:
  static constexpr int lanes = NumberTraits<T>::lanes, capacity = 16; // packets
  using Real = RealOf<T>;

  int fragments() const { return fragments_; }
  int packets() const { return (fragments_ + lanes - 1) / lanes; }
  /// For further fragments.
  int room() const { return capacity * lanes - fragments_; }
  void clear() { fragments_ = 0; }

  /// Appends `pixels` neighbours, x_first and on: at least one, no more than there is room for. Part of the loop over
  /// runs, whatever else a precision instantiates: called, it costs small triangles 4 % of a frame.
  [[gnu::always_inline]] void add(const AttributeSetup<Real>& triangle, std::int32_t x_first, std::int32_t y,
                                  int pixels) {
    using Ints = VectorOf<std::int32_t, lanes>;
    const Ints lane = int_lane_numbers<lanes>();
    const int in_packet = fragments_ % lanes;
    kind_of_last_ = in_packet == 0 ? Kind(triangle) : kind_of_last_.with(triangle, &triangle != last_);
    last_ = &triangle;
    // Packet by packet, all but the first as registers lie in memory; to the end of the last, where the last pixel is
    // repeated.
    auto at = static_cast<std::size_t>(fragments_);
    for (int done = 0, here = lanes - in_packet;; here = lanes, kind_of_last_ = Kind(triangle)) {
      kind_[at / lanes] = kind_of_last_;
      store_pointers(&triangle, &triangle_[at]);
      store_lanes(&x_[at], x_first + lesser(lane + done, pixels - 1 - Ints{}) * subpixels);
      store_lanes(&y_[at], y - Ints{});
      done += here, at += static_cast<std::size_t>(here);
      if (done >= pixels) break;
    }
    fragments_ += pixels;
  }

  Packet<T> packet(int i) const {
    const auto at = static_cast<std::size_t>(i * lanes);
    const Kind kind = kind_[static_cast<std::size_t>(i)];
    return {&triangle_[at],   &x_[at],    &y_[at], std::min(lanes, fragments_ - i * lanes),
            kind.triangles(), kind.edges()};
  }

  /// The end of the packets from `begin` on of which the same is known: as packets of many triangles or of one, and of
  /// their edges.
  int stretch_end(int begin) const {
    int end = begin + 1;
    while (end < packets() && kind_[static_cast<std::size_t>(end)] == kind_[static_cast<std::size_t>(begin)]) ++end;
    return end;
  }

private:
  // What is known of a packet, in one byte: of two, written apart and read together, a processor waits for the first to
  // have left its store buffer.
  class Kind {
  public:
    Kind() = default;
    explicit Kind(const AttributeSetup<Real>& triangle) : value_(static_cast<std::uint8_t>(triangle.kind())) {}
    Kind with(const AttributeSetup<Real>& triangle, bool is_another) const {
      Kind both;
      both.value_ = std::max<std::uint8_t>(value_ & edges_bits, Kind(triangle).value_);
      both.value_ |= is_another ? many_bit : value_ & many_bit;
      return both;
    }
    Triangles triangles() const { return value_ & many_bit ? Triangles::many : Triangles::one; }
    EdgeKind edges() const { return EdgeKind(value_ & edges_bits); }
    bool operator==(const Kind&) const = default;

  private:
    static constexpr std::uint8_t edges_bits = 0x7F, many_bit = 0x80;
    std::uint8_t value_ = 0;
  };
  // By registers: of more than one, compilers make scalars.
  static void store_pointers(const AttributeSetup<Real>* pointer, const AttributeSetup<Real>** to) {
    using Pointers = VectorOf<std::int64_t, native_vector_bytes / sizeof(std::int64_t)>;
    const Pointers all = reinterpret_cast<std::int64_t>(pointer) - Pointers{};
    for (std::size_t lane = 0; lane < lanes; lane += sizeof all / sizeof pointer) store_lanes(to + lane, all);
  }
  static constexpr std::size_t places = (capacity + 1) * lanes; // a register may be stored at the last fragment
  static_assert(sizeof(const AttributeSetup<Real>*) == sizeof(std::int64_t));

  int fragments_ = 0;
  const AttributeSetup<Real>* last_ = nullptr;
  Kind kind_of_last_; // packet
  std::array<Kind, capacity> kind_;
  // So that no packet's register lies across two lines of the cache.
  alignas(native_vector_bytes) std::array<const AttributeSetup<Real>*, places> triangle_;
  alignas(native_vector_bytes) std::array<std::int32_t, places> x_, y_;
};

} // namespace refraster
