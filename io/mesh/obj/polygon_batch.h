#pragma once
// Several polygons of an OBJ file side by side in registers.

#include "io/mesh/obj/polygon.h"
#include "io/mesh/obj_text.h"
#include "math/lanes/wide.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <span>

namespace refraster {

/// Polygons with equally many corners, at most max_corners, as many as a register has lanes.
class PolygonBatch {
public:
  static constexpr int lanes = native_vector_bytes / static_cast<int>(sizeof(double));
  static constexpr std::size_t max_corners = 8;
  using Lanes = Wide<double, lanes>;

  bool is_full() const { return count_ == lanes; }
  int count() const { return count_; }
  std::size_t corners() const { return corners_; }
  std::size_t face(int lane) const { return faces_[static_cast<std::size_t>(lane)]; }
  /// Whether a polygon of so many corners may be added.
  bool takes(std::size_t corners) const {
    return corners <= max_corners && !is_full() && (count_ == 0 || corners == corners_);
  }
  void add(std::size_t face, std::span<const ObjCorner> corners, const RawVector<Float3>& v) {
    corners_ = corners.size();
    const auto lane = static_cast<std::size_t>(count_);
    for (std::size_t i = 0; i < corners_; ++i) {
      const Float3& point = v[static_cast<std::size_t>(corners[i].v)];
      for (std::size_t c = 0; c < 3; ++c)
        coordinates_[i][c][lane] = static_cast<double>(point[static_cast<glm::length_t>(c)]);
    }
    faces_[lane] = face;
    ++count_;
  }
  void clear() { count_ = 0; }

  /// Corners and their rounding_of; lanes beyond count() have what they had, some numbers.
  void load() {
    for (std::size_t i = 0; i < corners_; ++i) {
      points_[i] = {lanes_of(coordinates_[i][0]), lanes_of(coordinates_[i][1]), lanes_of(coordinates_[i][2])};
      roundings_[i] = rounding_of(points_[i]);
    }
  }
  std::span<const Vec3<Lanes>> points() const { return std::span(points_).first(corners_); }
  std::span<const Lanes> roundings() const { return std::span(roundings_).first(corners_); }

  static Lanes lanes_of(const std::array<double, lanes>& numbers) {
    Lanes result;
    std::memcpy(&result.v, numbers.data(), sizeof result.v);
    return result;
  }

private:
  int count_ = 0;
  std::size_t corners_ = 0;
  std::array<std::size_t, lanes> faces_{};
  std::array<std::array<std::array<double, lanes>, 3>, max_corners> coordinates_{};
  std::array<Vec3<Lanes>, max_corners> points_;
  std::array<Lanes, max_corners> roundings_;
};

} // namespace refraster
