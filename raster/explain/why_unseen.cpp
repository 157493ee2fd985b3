#include "raster/explain/why_unseen.h"

#include "raster/vertex/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <vector>

namespace refraster {
namespace {

/// Why an object is not seen. Of several reasons the one that stands first holds, in the order of `fate_of`.
enum class Fate {
  no_triangle,
  not_finite,
  no_area,
  behind,
  beyond_far,
  before_near,
  left,
  right,
  below,
  above,
  around, // outside the view, but not on one side of it
  culled,
  cut_out,
  too_small,
  cropped
};

/// What is the same for all objects. A point p is inside a plane where dot(plane, p) >= 0, in clip space.
struct View {
  Double4x4 clip_from_world;
  std::array<Double4, 5> in_front_and_sides; // near, left, right, bottom, top
  Double4 far{0, 0, -1, 1};
  std::array<Double4, 4> crop_sides;
  bool is_cropped;
};

View view_of(const Scene& scene, int width, int height, const PixelRect& region) {
  View view{clip_from_world(scene.camera, static_cast<double>(width) / height),
            {{{0, 0, 1, 1}, {1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}}},
            {0, 0, -1, 1},
            {},
            region.width < width || region.height < height};
  const auto ndc = [](int pixels, int size) { return 2.0 * pixels / size - 1; };
  const double left = ndc(region.x, width), right = ndc(region.x + region.width, width);
  const double top = -ndc(region.y, height), bottom = -ndc(region.y + region.height, height);
  view.crop_sides = {{{1, 0, 0, -left}, {-1, 0, 0, right}, {0, 1, 0, -bottom}, {0, -1, 0, top}}};
  return view;
}

double dot4(const Double4& a, const Double4& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

using Polygon = std::vector<Double4>;

/// The part inside, by Sutherland and Hodgman, "Reentrant polygon clipping", 1974.
void clip(Polygon& polygon, const Double4& plane, Polygon& scratch) {
  scratch.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Double4 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = dot4(plane, a), at_b = dot4(plane, b);
    if (at_a >= 0) scratch.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) {
      const double t = at_a / (at_a - at_b);
      scratch.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), a.w + t * (b.w - a.w)});
    }
  }
  polygon.swap(scratch);
}

template <class Planes>
void clip_by_all(Polygon& polygon, const Planes& planes, Polygon& scratch) {
  for (const Double4& plane : planes) clip(polygon, plane, scratch);
}

bool is_finite(const Double4& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

/// Whether the triangle is a line or a point once it is scaled; rotation does not change that.
bool has_no_area(const Float3& a, const Float3& b, const Float3& c, const Double3& scale) {
  const auto edge = [&](const Float3& to) { return (Double3(to) - Double3(a)) * scale; };
  const Double3 u = edge(b), v = edge(c);
  // A component is the difference of two products of two scaled differences each: five roundings a product and one for
  // the difference, each of half an ulp. What is no larger than that is 0.
  const auto is_zero = [](double p, double q) {
    constexpr double roundings = 6 * std::numeric_limits<double>::epsilon() / 2;
    return std::abs(p - q) <= roundings * (std::abs(p) + std::abs(q));
  };
  return is_zero(u.y * v.z, u.z * v.y) && is_zero(u.z * v.x, u.x * v.z) && is_zero(u.x * v.y, u.y * v.x);
}

/// Counter-clockwise as seen from the eye, also with corners behind it: the sign of det(x, y, w).
bool faces_the_eye(const std::array<Double4, 3>& p) {
  return p[0].x * (p[1].y * p[2].w - p[2].y * p[1].w) - p[0].y * (p[1].x * p[2].w - p[2].x * p[1].w) +
             p[0].w * (p[1].x * p[2].y - p[2].x * p[1].y) >
         0;
}

struct ObjectFate {
  Fate fate;
  double nearest = std::numeric_limits<double>::infinity(); // depth of what lies beyond the far plane
};

/// All vertices on the outer side of one plane: so is the whole object.
std::optional<ObjectFate> outside_as_a_whole(const std::vector<Double4>& vertices) {
  const auto all = [&](auto&& test) { return std::all_of(vertices.begin(), vertices.end(), test); };
  if (all([](const Double4& p) { return p.w <= 0; })) return ObjectFate{Fate::behind};
  if (all([](const Double4& p) { return p.z > p.w; })) {
    const auto nearer = [](const Double4& p, const Double4& q) { return p.w < q.w; };
    return ObjectFate{Fate::beyond_far, std::min_element(vertices.begin(), vertices.end(), nearer)->w};
  }
  if (all([](const Double4& p) { return p.z < -p.w; })) return ObjectFate{Fate::before_near};
  if (all([](const Double4& p) { return p.x < -p.w; })) return ObjectFate{Fate::left};
  if (all([](const Double4& p) { return p.x > p.w; })) return ObjectFate{Fate::right};
  if (all([](const Double4& p) { return p.y < -p.w; })) return ObjectFate{Fate::below};
  if (all([](const Double4& p) { return p.y > p.w; })) return ObjectFate{Fate::above};
  return {};
}

/// What became of the triangles that lie within the view's sides is what counts: others are outside of any picture.
ObjectFate fate_by_triangles(const Object& object, const std::vector<Double4>& clip_position, const View& view) {
  std::uint64_t culled = 0, cut_out = 0, too_small = 0, cropped = 0;
  ObjectFate far{Fate::around};
  Polygon polygon, scratch;
  for (std::uint32_t i = 0; i < object.mesh->triangles.size(); ++i) {
    const auto& corners = object.mesh->triangles[i];
    const std::array<Double4, 3> triangle{clip_position[corners[0]], clip_position[corners[1]],
                                          clip_position[corners[2]]};
    if (!std::all_of(triangle.begin(), triangle.end(), is_finite)) continue;
    polygon.assign(triangle.begin(), triangle.end());
    clip_by_all(polygon, view.in_front_and_sides, scratch);
    if (polygon.empty()) continue;
    for (const Double4& p : polygon)
      if (p.z > p.w) far = {Fate::beyond_far, std::min(far.nearest, p.w)};
    clip(polygon, view.far, scratch);
    if (polygon.empty()) continue;
    if (view.is_cropped) clip_by_all(polygon, view.crop_sides, scratch);
    if (polygon.empty()) ++cropped;
    else if (object.cull == Cull::back && !faces_the_eye(triangle)) ++culled;
    else if (material_of(object, i).has_cut_outs()) ++cut_out;
    else ++too_small;
  }
  if (culled + cut_out + too_small > 0)
    return {culled >= std::max(cut_out, too_small) ? Fate::culled
            : cut_out >= too_small                 ? Fate::cut_out
                                                   : Fate::too_small};
  if (cropped > 0) return {Fate::cropped};
  return far;
}

ObjectFate fate_of(const Object& object, const View& view) {
  const Mesh& mesh = *object.mesh;
  if (mesh.triangles.empty()) return {Fate::no_triangle};
  const ObjectTransform transform = object_transform(object, view.clip_from_world);
  std::vector<Double4> vertices;
  vertices.reserve(mesh.positions.size());
  for (const Float3& position : mesh.positions) vertices.push_back(clip_position(transform, position));
  const auto of_all_triangles = [&](auto&& test) {
    return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), test);
  };
  if (of_all_triangles([&](const auto& corners) {
        return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t c) { return !is_finite(vertices[c]); });
      }))
    return {Fate::not_finite};
  if (of_all_triangles([&](const auto& c) {
        return has_no_area(mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]], object.scale);
      }))
    return {Fate::no_area};
  std::vector<Double4> finite = vertices;
  std::erase_if(finite, [](const Double4& p) { return !is_finite(p); });
  if (const auto outside = outside_as_a_whole(finite)) return *outside;
  return fate_by_triangles(object, vertices, view);
}

std::string text_of(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

/// As few digits as show that it is beyond the plane, three at least; "1234" rather than "1.23e+03".
std::string distance_text(double distance, double far) {
  int digits = 3;
  for (double power = 1000; power <= distance && digits < 9; power *= 10) ++digits;
  while (digits < 17 && !(std::stod(text_of(distance, digits)) > far)) ++digits;
  return text_of(distance, digits);
}

/// Objects of one fate, as the subject of a sentence.
struct Group {
  Fate fate;
  std::size_t count = 0;
  std::string name; // of the first
  double nearest = std::numeric_limits<double>::infinity();
};

std::string subject(const Group& group, std::size_t objects) {
  if (objects == 1) return "the only object, \"" + group.name + "\",";
  if (group.count == objects) return objects == 2 ? "both objects" : "all " + std::to_string(objects) + " objects";
  return group.count == 1 ? "the object \"" + group.name + "\"" : std::to_string(group.count) + " objects";
}

std::string sentence(const Group& group, std::size_t objects, const Camera& camera) {
  const bool one = group.count == 1;
  const std::string who = subject(group, objects) + " ", lies = who + (one ? "lies " : "lie "),
                    has = who + (one ? "has " : "have ");
  switch (group.fate) {
  case Fate::no_triangle:
    return has + "no triangle";
  case Fate::not_finite:
    return has + "no vertex within the range of a double";
  case Fate::no_area:
    return has + "no area: each triangle is a line or a point";
  case Fate::behind:
    return lies + "behind the camera";
  case Fate::beyond_far:
    return lies + "beyond the far plane, " + text_of(camera.far, 6) + "; " + (one ? "it" : "the nearest") + " is " +
           distance_text(group.nearest, camera.far) + " away";
  case Fate::before_near:
    return lies + "nearer than the near plane, " + text_of(camera.near, 6);
  case Fate::left:
    return lies + "outside the view to the left";
  case Fate::right:
    return lies + "outside the view to the right";
  case Fate::below:
    return lies + "outside the view, below it";
  case Fate::above:
    return lies + "outside the view, above it";
  case Fate::around:
    return lies + "outside the view";
  case Fate::culled:
    return (group.count == objects ? std::string("all triangles") : "all triangles of " + subject(group, objects)) +
           " face away and are culled (\"cull\": \"back\")";
  case Fate::cut_out:
    return (group.count == objects ? std::string("all that would be seen") : "all of " + subject(group, objects)) +
           " is cut out: its opacity is below the threshold at the pixels' centres (\"opacity_map\")";
  case Fate::too_small:
    return who + (one ? "covers" : "cover") + " no pixel's centre: too small or too thin in the image";
  case Fate::cropped:
    return lies + "outside the crop";
  }
  return {};
}

} // namespace

std::string why_unseen(const Scene& scene, int width, int height, const PixelRect& region) {
  if (scene.objects.empty()) return "the scene has no objects";
  const View view = view_of(scene, width, height, region);
  std::vector<Group> groups; // in the order of their first objects
  for (const Object& object : scene.objects) {
    const ObjectFate found = fate_of(object, view);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.fate == found.fate; });
    if (group == groups.end()) group = groups.insert(group, {found.fate, 0, object.name});
    ++group->count;
    group->nearest = std::min(group->nearest, found.nearest);
  }
  std::string text;
  for (const Group& group : groups)
    text += (text.empty() ? "" : "; ") + sentence(group, scene.objects.size(), scene.camera);
  return text;
}

} // namespace refraster
