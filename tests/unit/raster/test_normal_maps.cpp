// Normals that maps turn: by the formula in 60 digits at chosen pixels, and by what they look like.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "math/exact.h"
#include "raster/render_in.h"

#include "tests/support/scenes/poster.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <memory>

namespace refraster::test {
namespace {

constexpr int side = 16;

/// A square that fills the image: weights of its corners at a pixel's centre are whole 32nds. It reflects red, green
/// and blue of three lights from three sides, without a highlight: <n.l> each.
Scene poster() {
  Phong dull;
  dull.ka = dull.ks = Double3(0), dull.kd = Double3(1);
  Scene scene = poster_scene(dull);
  scene.direction_lights = {
      {{-1, -2, -3}, {1, 0, 0}}, {{2, -1, -4}, {0, 1, 0}}, {{0.5, 3, -2}, {0, 0, 1}}}; // the first travels to -x
  change_mesh(scene, [](Mesh& mesh) { mesh.tangents.assign(4, Float4(1, 0, 0, 1)); });
  return scene;
}

/// All sorts of directions that are not away from the light.
std::shared_ptr<const Texture> some_texture(int width, int height, int number) {
  auto texture = std::make_shared<Texture>();
  TextureLevel& image = texture->levels.emplace_back();
  image.width = width, image.height = height;
  for (int i = 0; i < width * height; ++i)
    for (int c = 0; c < 3; ++c)
      image.rgb.push_back(
          static_cast<float>(c == 2 ? 200 + (i * 13 + number) % 56 : 96 + (i * 37 + c * 11 + number) % 64));
  return texture;
}

/// The same colour everywhere; of 1 where it is 1.
std::shared_ptr<const Texture> plain_texture(float r, float g, float b) {
  auto texture = std::make_shared<Texture>();
  texture->full_scale = 1;
  texture->levels.push_back({1, 1, {r, g, b}});
  return texture;
}

// The formula, once more, by hand.

using E3 = std::array<Exact, 3>;
E3 exact(const auto& v) {
  return {Exact(static_cast<double>(v.x)), Exact(static_cast<double>(v.y)), Exact(static_cast<double>(v.z))};
}
E3 sum(const E3& a, const Exact& s, const E3& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
E3 cross_of(const E3& a, const E3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Exact dot_of(const E3& a, const E3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
E3 unit_of(const E3& a) {
  const Exact size(Exact::Value(sqrt(dot_of(a, a).value())));
  return {a[0] / size, a[1] / size, a[2] / size};
}

/// Between the centres of four texels, of an image that repeats.
E3 bilinear(const Texture& texture, const Exact& u, const Exact& v) {
  const TextureLevel& image = texture.levels[0];
  const Exact x = u * Exact(image.width) - Exact(0.5), y = v * Exact(image.height) - Exact(0.5);
  const Exact::Value i = floor(x.value()), j = floor(y.value());
  const Exact s(Exact::Value(x.value() - i)), t(Exact::Value(y.value() - j));
  const auto texel = [&](int di, int dj) {
    const auto wrapped = [](int k, int n) { return (k % n + n) % n; };
    const int column = wrapped(static_cast<int>(i) + di, image.width),
              row = wrapped(static_cast<int>(j) + dj, image.height);
    const float* const rgb = &image.rgb[static_cast<std::size_t>(3 * (row * image.width + column))];
    return E3{Exact(static_cast<double>(rgb[0])), Exact(static_cast<double>(rgb[1])),
              Exact(static_cast<double>(rgb[2]))};
  };
  E3 result{Exact(0), Exact(0), Exact(0)};
  const Exact one(1), scale(Exact(1) / Exact(texture.full_scale));
  result = sum(result, (one - s) * (one - t) * scale, texel(0, 0)),
  result = sum(result, s * (one - t) * scale, texel(1, 0));
  result = sum(result, (one - s) * t * scale, texel(0, 1)), result = sum(result, s * t * scale, texel(1, 1));
  return result;
}

/// What the three lights make of the poster at a pixel.
E3 expected(const Scene& scene, int x, int y) {
  const Object& object = scene.objects[0];
  const Mesh& mesh = *object.mesh;
  const Material& material = object.material;
  const Exact u = Exact(2 * x + 1) / Exact(2 * side), v = Exact(2 * (side - 1 - y) + 1) / Exact(2 * side);
  const Exact one(1);
  const std::array<Exact, 4> weight =
      u >= v ? std::array{one - u, u - v, v, Exact(0)} : std::array{one - v, Exact(0), u, v - u};
  E3 n{Exact(0), Exact(0), Exact(0)}, t = n;
  Exact w(0);
  for (std::size_t k = 0; k < 4; ++k) {
    n = sum(n, weight[k], exact(mesh.normals[k])), t = sum(t, weight[k], exact(mesh.tangents[k]));
    w += weight[k] * Exact(static_cast<double>(mesh.tangents[k].w));
  }
  n = unit_of(n);
  E3 m{Exact(0), Exact(0), Exact(1)};
  if (material.normal_map.texture) {
    const E3 colour = bilinear(*material.normal_map.texture, u, v);
    for (std::size_t c = 0; c < 3; ++c) m[c] = (Exact(2) * colour[c] - one) * Exact(c < 2 ? material.normal_scale : 1);
  }
  if (const auto& heights = material.bump_map.texture) {
    const TextureLevel& image = heights->levels[0];
    const Exact du = one / Exact(image.width), dv = one / Exact(image.height),
                k = Exact(material.bump_scale) / Exact(2);
    m[0] -= k * (bilinear(*heights, u + du, v)[0] - bilinear(*heights, u - du, v)[0]);
    m[1] -= k * (bilinear(*heights, u, v + dv)[0] - bilinear(*heights, u, v - dv)[0]);
  }
  const E3 b = cross_of(n, t);
  E3 turned{Exact(0), Exact(0), Exact(0)};
  turned = sum(turned, m[0], t), turned = sum(turned, m[1] * w, b), turned = sum(turned, m[2], n);
  turned = unit_of(turned);
  E3 radiance;
  for (std::size_t c = 0; c < 3; ++c) {
    const E3 l = exact(-normalize(scene.direction_lights[c].direction)); // a parameter, which is a double
    const Exact cosine = dot_of(turned, l);
    radiance[c] = cosine > Exact(0) ? cosine : Exact(0);
  }
  return radiance;
}

/// Largest difference of the pixels from the formula, relative to 1, the radiance of the lights.
double largest_error(const Scene& scene, Precision precision) {
  RenderOptions options;
  options.width = options.height = side;
  options.precision = precision;
  options.want_radiance = options.want_radiance_double = true;
  const Frame frame = render(scene, options);
  double largest = 0;
  for (const auto& [x, y] : {std::pair(3, 4), std::pair(12, 9), std::pair(8, 2), std::pair(1, 14), std::pair(15, 0)}) {
    const E3 right = expected(scene, x, y);
    for (std::size_t c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(static_cast<double>(Exact(frame.radiance_double.at(x, y)[c]) - right[c])));
  }
  return largest;
}

Image<float> normals(const Scene& scene) {
  RenderOptions options;
  options.width = options.height = side;
  options.aovs = {Aov::normal};
  return render(scene, options).aovs[0];
}
Double3 middle_normal(const Scene& scene) {
  const Image<float> image = normals(scene);
  const float* const n = image.at(side / 2, side / 2);
  return {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
}

/// AOVs are floats: half of 2^-24, of each component.
constexpr double of_floats = 0x1p-24;

} // namespace

TEST_CASE("a normal map, a bump map and both make of the interpolated frame what the formula says in 60 digits") {
  Scene scene = poster();
  change_mesh(scene, [](Mesh& mesh) {
    mesh.normals = {{0.25f, 0, 1}, {0, -0.5f, 2}, {-0.5f, 0.125f, 1.5f}, {0.25f, 0.5f, 1}};
    mesh.tangents = {{1, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, -1}, {0, 0, -1, -1}}; // unit, so that nothing is rounded
  });
  Material& material = scene.objects[0].material;
  for (int which = 1; which < 4; ++which) {
    CAPTURE(which);
    material.normal_map.texture = which & 1 ? some_texture(5, 7, 3) : nullptr;
    material.bump_map.texture = which & 2 ? some_texture(8, 4, 21) : nullptr;
    material.normal_scale = 0.75, material.bump_scale = 1.5;
    // Some forty operations, each of which rounds values of up to 4 once: interpolation, 8; a texture, 12; the frame,
    // 12; lengths, 8; the light, 6.
    const double roundings = 46 * 4;
    CHECK(largest_error(scene, Precision::double_) <= roundings * 0x1p-53);
    CHECK(largest_error(scene, Precision::float_) <= roundings * 0x1p-24);
    CHECK(largest_error(scene, Precision::float_) > 0x1p-40); // it is another number, and not the same picture
    CHECK(largest_error(scene, Precision::exact) <= 0x1p-53); // a double is made of it at the end
    // The test can fail: without the map, or with another sign of the bitangent.
    Scene other = scene;
    change_mesh(other, [](Mesh& mesh) {
      for (Float4& tangent : mesh.tangents) tangent.w = -tangent.w;
    });
    const E3 right = expected(scene, 3, 4), wrong = expected(other, 3, 4);
    CHECK(std::abs(static_cast<double>(right[0] - wrong[0])) > 2 * roundings * 0x1p-24);
  }
  SampleRequest<Exact> request;
  RenderOptions options;
  options.width = options.height = side, options.threads = 1;
  int compared = 0;
  request.take = [&](int x, int y, const Rgb<Exact>& rgb) {
    if ((x + y) % 5 != 0) return;
    const E3 right = expected(scene, x, y);
    for (int c = 0; c < 3; ++c) CHECK(abs(rgb[c] - right[static_cast<std::size_t>(c)]) <= Exact(1e-55)); // of 60 digits
    ++compared;
  };
  shade_in(scene, options, request);
  CHECK(compared > 40);
}

TEST_CASE("red leans a normal to where u grows, green to where v does, whatever the model's matrix") {
  for (const Double3& scale :
       {Double3(1), Double3(-1, 1, 1), Double3(1, -1, 1), Double3(3, -2, -0.5), Double3(1, 2, -1)})
    for (const float u_grows : {1.0f, -1.0f}) {
      Scene scene = poster();
      CAPTURE(u_grows);
      change_mesh(scene, [&](Mesh& mesh) {
        for (Float2& uv : mesh.uvs) uv.x *= u_grows;
        add_tangents(mesh);
      });
      Object& object = scene.objects[0];
      object.scale = scale;
      const Double3 before = middle_normal(scene); // it may face away: normals stay on their side of the model
      const auto leaning = [&](float r, float g) {
        object.material.normal_map.texture = plain_texture(r, g, 0.9f); // 0.6, 0, 0.8
        return middle_normal(scene);
      };
      const double along_x = static_cast<double>(scale.x > 0 ? u_grows : -u_grows), along_y = scale.y > 0 ? 1 : -1;
      const auto near = [](const Double3& a, const Double3& b) { return length(a - b) < 4 * of_floats; };
      CHECK(near(leaning(0.8f, 0.5f), Double3(0.6 * along_x, 0, 0.8 * before.z)));
      CHECK(near(leaning(0.5f, 0.8f), Double3(0, 0.6 * along_y, 0.8 * before.z)));
      // Of an image that is seen from behind along u, what rises to its right falls with u.
      object.material.normal_map.scale.x = -2;
      CHECK(near(leaning(0.8f, 0.5f), Double3(-0.6 * along_x, 0, 0.8 * before.z)));
      object.material.normal_map.scale = {0, 1};
      CHECK(near(leaning(0.8f, 0.5f), before));
    }
}

TEST_CASE("a surface that is seen from behind has the opposite of the normal that it has in front") {
  Scene scene = poster();
  scene.objects[0].material.normal_map.texture = some_texture(4, 4, 1);
  scene.objects[0].rotate_degrees.y = 180;
  const Image<float> front = normals(scene);
  scene.objects[0].two_sided = TwoSided::yes;
  const Image<float> turned = normals(scene);
  REQUIRE(turned.values.size() == front.values.size());
  for (std::size_t i = 0; i < front.values.size(); ++i) CHECK(turned.values[i] == -front.values[i]);
}

TEST_CASE("heights that grow with u lean normals against it, by the slope a texel times bump_scale") {
  Scene scene = poster();
  auto texture = std::make_shared<Texture>();
  TextureLevel& image = texture->levels.emplace_back();
  image.width = 8, image.height = 1;
  for (int i = 0; i < 8; ++i)
    for (int c = 0; c < 3; ++c)
      image.rgb.push_back(static_cast<float>(c == 0 ? 17 * i : 255 - 30 * i)); // red alone counts
  Material& material = scene.objects[0].material;
  material.bump_map.texture = texture;
  material.bump_scale = 7.5; // 17 / 255 * 7.5 = 1 / 2
  const Double3 n = middle_normal(scene);
  CHECK(length(n - normalize(Double3(-0.5, 0, 1))) < 4 * of_floats);
  material.bump_map.scale.x = -1;
  CHECK(length(middle_normal(scene) - normalize(Double3(0.5, 0, 1))) < 4 * of_floats);
  material.bump_scale = 0;
  CHECK(length(middle_normal(scene) - Double3(0, 0, 1)) < 4 * of_floats);
}

TEST_CASE("triangles without texture coordinates, and meshes without tangents, keep their normals") {
  Scene scene = poster();
  scene.objects[0].material.normal_map.texture = plain_texture(0.8f, 0.5f, 0.9f);
  CHECK(length(middle_normal(scene) - Double3(0, 0, 1)) > 0.5);
  change_mesh(scene, [](Mesh& mesh) { mesh.uvs.resize(2); });
  CHECK(length(middle_normal(scene) - Double3(0, 0, 1)) < 4 * of_floats);
  scene = poster();
  scene.objects[0].material.normal_map.texture = plain_texture(0.8f, 0.5f, 0.9f);
  change_mesh(scene, [](Mesh& mesh) { mesh.tangents.clear(); });
  CHECK(middle_normal(scene) == Double3(0, 0, 1));
}

TEST_CASE("a map that says no direction leaves the normal, and is counted") {
  Scene scene = poster();
  scene.objects[0].material.normal_map.texture = plain_texture(0.5f, 0.5f, 0.5f);
  RenderOptions options;
  options.width = options.height = side, options.aovs = {Aov::normal};
  Frame frame = render(scene, options);
  CHECK(frame.counts.undefined[Undefined::zero_normal] == side * side);
  CHECK(frame.aovs[0].at(3, 3)[2] == 1);
}

TEST_CASE("every fragment function shades by the normal that maps have turned") {
  Scene scene = poster();
  scene.objects[0].material.fragment_function = BlinnPhong{};
  scene.objects[0].material.normal_map.texture = some_texture(4, 4, 1);
  RenderOptions options;
  options.width = options.height = side;
  Scene without = scene;
  without.objects[0].material.normal_map = {};
  CHECK(render(scene, options).rgb8.values != render(without, options).rgb8.values);
}

} // namespace refraster::test
