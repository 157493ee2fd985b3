#pragma once
// What of a scene file depends on the image that is made of it: from where it is seen, and lights that move with the
// camera. A Scene is plain data of one world; it is made once the image's size is known.

#include <refraster/render.h>
#include <refraster/scene.h>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace refraster {

/// What the position or direction of a light is relative to.
enum class LightSpace {
  world, // the scene: the light stays where it is, wherever it is seen from
  camera // the camera, x to the right, y up, z toward the viewer, 0 the eye: the light moves with it
};

template <>
struct EnumNames<LightSpace> {
  static constexpr std::pair<LightSpace, std::string_view> names[] = {{LightSpace::world, "world"},
                                                                      {LightSpace::camera, "camera"}};
};

template <>
struct EnumNames<Transfer> {
  static constexpr std::pair<Transfer, std::string_view> names[] = {{Transfer::linear, "false"},
                                                                    {Transfer::srgb, "true"}};
};

/// From which side a camera looks at what a scene shows.
struct CameraFit {
  double azimuth_degrees = 30; // about the camera's up vector, counter-clockwise seen from above; 0: from the front, +z
                               // where +y is up
  double elevation_degrees = 20;       // above the plane across the up vector: -90 to 90
  double margin = 0.05;                // part of the image's width and height that stays free on each side: 0 to 0.49
  std::optional<double> distance = {}; // from the target, in place of the nearest one; > 0
  std::optional<Double3> target = {};  // in the middle of the image; by default the middle of what is seen
  std::optional<double> near = {};     // in place of a plane before the nearest vertex; > 0
  std::optional<double> far = {};      // in place of a plane behind the farthest vertex; > near
  bool operator==(const CameraFit&) const = default;
};

/// The image that a scene is meant to be made into: what commands take where no option says otherwise.
struct Picture {
  int width = 1280, height = 720; // pixels
  int samples = 1;                // a pixel
  Transfer transfer = Transfer::linear;
  bool operator==(const Picture&) const = default;
};

/// How fast a camera is moved by hand, as the lecture's framework reads it; nothing where the scene does not say it.
struct CameraHandling {
  std::optional<double> movement_speed;    // world units a second
  std::optional<double> mouse_sensitivity; // degrees a pixel
};

/// What is left to be done.
struct SceneView {
  std::optional<CameraFit> fit; // gives the camera its place; none: it has one
  CameraHandling handling = {};
  std::vector<std::size_t> moving_point_lights, moving_direction_lights; // those of camera space, by their number
  Picture picture;

  /// Of one type of light.
  template <class Light>
  std::vector<std::size_t>& moving() {
    if constexpr (std::is_same_v<Light, PointLight>) return moving_point_lights;
    else return moving_direction_lights;
  }
};

/// Places the camera, where the view has a fit, and lights of camera space, for an image of this size; both >= 1. Of
/// the scene's camera the field of view and the up vector count; it gets position, target, up vector and planes.
///
/// With r to the right, u up and d toward the viewer, unit vectors that azimuth and elevation give, and k the tangents
/// of half the angles of view less the margin, the eye at (x, y, z) sees a point p if
///
///     |p.r - x| <= kx (z - p.d)   and   |p.u - y| <= ky (z - p.d).
///
/// So z >= (max(p.r + kx p.d) + max(-p.r + kx p.d)) / (2 kx) over all vertices, likewise for y, and the greater of both
/// is as near as it gets; but no vertex is nearer than a tenth of the model's extent. x and y are so that the model's
/// image touches two opposite margins, or is as far from the one as from the other. The near plane lies before the
/// nearest vertex and the far plane behind the farthest, by a hundredth of their distance. Vertices that are not finite
/// do not count. A model of a single point is seen from a distance of 1, or more where its coordinates are so large
/// that this would be lost in rounding.
void place(Scene& scene, const SceneView& view, int width, int height);

} // namespace refraster
