#pragma once
// A triangle as a device may have it: where it may be, how deep, and how its attributes may be interpolated.

#include "raster/shade/attribute_setup.h"
#include "verify/bounds/area_error.h"
#include "verify/bounds/device_frame.h"
#include "verify/bounds/window_triangle.h"

#include <array>
#include <cstdint>
#include <limits>

namespace refraster {

/// Whether a triangle covers a point, in whichever way a device is right. Of an ambiguous one: a bit for each edge that
/// the point may be on either side of, that opposite corner k being bit k.
struct Coverage {
  enum class Certainty : std::uint8_t { outside, ambiguous, inside } certainty = Certainty::outside;
  std::uint8_t ambiguous_edges = 0;
};

/// From lo to hi.
struct ValueRange {
  double lo = -std::numeric_limits<double>::infinity(), hi = std::numeric_limits<double>::infinity();
};

/// How far from a sample of our triangle the point may be at which a device sees the same: in subpixels, y down.
struct SampleShift {
  Double2 centre{0}, radius{0};
};

/// Of a frame's triangle; holds a reference to the frame. Points are in pixels of the window, y down.
class DeviceTriangle {
public:
  DeviceTriangle(const DeviceFrame& frame, std::uint32_t number);

  const TriangleRef& ref() const { return ref_; }
  std::uint32_t number() const { return number_; }
  /// Whether it can be seen at all: it has finite corners, and one at least in front of the eye.
  bool is_seen() const { return seen_; }
  /// The pixels that it may touch; empty if none.
  PixelRect pixels() const { return pixels_; }

  /// With edges wherever the device may have them: theory in docs/verification.md.
  Coverage coverage(double x, double y) const;
  /// Of window depth in [0, 1]; and whether the depth planes may or must cut it off.
  ValueRange depth(double x, double y) const;
  /// Whether it faces away from the eye: both, if that is open.
  bool may_face_front() const { return facing_ >= 0; }
  bool may_face_back() const { return facing_ <= 0; }

  SampleShift shift(double x, double y) const;
  /// How far the matrix that makes the device's triangle of ours may be from 1: what is linear in the window changes
  /// along its axes by as much more or less. Infinite if nothing is known.
  double turned() const;
  /// How far an interpolated component may be off at a point, beside that shift. Row as in AttributeSetup: of position,
  /// normal and texture coordinates; infinite where nothing is known.
  double attribute_error(int row, double x, double y) const;

  /// The corner's position in the mesh: two triangles share an edge if they have two of them in common.
  const Float3& mesh_position(std::size_t corner) const;

private:
  struct Plane {
    double value = 0, along_x = 0, along_y = 0, error = 0;
  };
  Plane plane(const std::array<double, 3>& corner_values, double x, double y) const;
  double area_error_at(double x, double y) const { return in_front_ ? area_error_.at({x, y}, reach_) : 0; }
  double plane_error(double most, const Double2& along, double x, double y) const;
  Coverage coverage_in_front(double x, double y) const;
  Coverage coverage_by_weights(double x, double y) const;
  void place_corners();
  /// Of samples, in pixels, where corners are moved by half a lattice step and by what the vertex stage loses.
  double reach_at(double x, double y) const;
  double snap_radius() const;
  /// How far a corner may be from its exact place, in pixels along each axis; if in front.
  double corner_reach(std::size_t corner) const;
  /// How far what the vertex stage loses moves a point, in pixels; infinite where that is not small beside the
  /// triangle.
  double vertex_shift_at(double x, double y) const;
  double exact_reach_at(double x, double y) const;
  ValueRange mean_of_corners(const std::array<ValueRange, 3>& moved, double x, double y) const;

  const DeviceFrame& frame_;
  TriangleRef ref_;
  std::uint32_t number_;
  bool seen_ = false, clipped_ = false; // clipped: a corner is behind the eye, or beyond a border of the view
  bool in_front_ = false;               // no corner is behind the eye
  int facing_ = 0;                      // 1: front, -1: back, 0: either
  WindowTriangle planes_;
  std::array<Double2, 3> corner_{Double2(0), Double2(0), Double2(0)}; // in pixels, if in front
  std::array<Double2, 3> moved_{Double2(0), Double2(0), Double2(0)};  // from ours, in pixels
  std::array<double, 3> corner_error_{};                              // of the vertex stage, in pixels
  std::array<double, 3> z_clip_{}, w_clip_{};
  // Of the vertex stage, of homogeneous coordinates: in pixels times w, in w, in w; and of the viewport, in pixels.
  std::array<double, 3> xy_error_{}, z_error_{}, w_error_{}, viewport_error_{};
  double reach_ = 0; // the most of corner_reach(); if in front
  AreaError area_error_; // if in front
  PixelRect pixels_;
};

} // namespace refraster
