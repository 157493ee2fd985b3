// Right images pass, wrong ones do not, and each pixel is of the class that it should be.

#include <refraster/mesh.h>

#include "tests/support/raster/window_scene.h"
#include "tests/support/scenes/half_textured.h"
#include "verify/device/read_profile.h"
#include "verify/verdict/verdict.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace refraster::test {
namespace {

constexpr int width = 96, height = 64;

Scene textured_scene(TextureFilter filter = TextureFilter::bilinear) {
  return half_textured(filter);
}

RenderOptions options_of(int samples = 1) {
  RenderOptions options;
  options.width = width, options.height = height, options.samples = samples;
  return options;
}

DeviceImage eight_bits(const Scene& scene, int samples = 1, Precision precision = Precision::double_,
                       Transfer transfer = Transfer::linear) {
  RenderOptions options = options_of(samples);
  options.precision = precision, options.transfer = transfer;
  const Frame frame = render(scene, options);
  DeviceImage image;
  image.colour = Image<float>(width, height, 3);
  std::copy(frame.rgb8.values.begin(), frame.rgb8.values.end(), image.colour.values.begin());
  image.precision = StoredPrecision::integers(255);
  image.transfer = transfer;
  return image;
}

DeviceImage floats(const Scene& scene, Precision precision = Precision::double_) {
  RenderOptions options = options_of();
  options.want_radiance = true, options.precision = precision;
  DeviceImage image;
  image.colour = render(scene, options).radiance;
  image.full_scale = 1, image.precision = StoredPrecision::floats(0x1p-24);
  return image;
}

void add_ids_and_depth(DeviceImage& image, const Scene& scene) {
  RenderOptions options = options_of();
  options.aovs = {Aov::object, Aov::triangle, Aov::depth};
  const Frame frame = render(scene, options);
  image.ids = Image<float>(width, height, 2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 2; ++c) image.ids.at(x, y)[c] = *frame.aovs[c].at(x, y);
  image.depth = frame.aovs[2];
}

/// Of a device that does as we do, in single precision.
DeviceProfile precise() {
  DeviceProfile profile = device_profile("llvmpipe-precise");
  profile.raster.setup_positions = SetupPositions::snapped;
  return profile;
}

Verdict verdict_of(const Scene& scene, const DeviceImage& image, const DeviceProfile& profile, int samples = 1) {
  JudgeOptions options;
  options.samples = samples;
  return judge(scene, image, profile, options);
}

PixelClass class_at(const Verdict& verdict, int x, int y) {
  return static_cast<PixelClass>(*verdict.classes.at(x, y));
}

const JudgedDetail& detail_at(const Verdict& verdict, int x, int y) {
  const auto found = std::find_if(verdict.details.begin(), verdict.details.end(),
                                  [&](const JudgedDetail& d) { return d.x == x && d.y == y; });
  REQUIRE(found != verdict.details.end());
  return *found;
}

} // namespace

TEST_CASE("the reference itself is exact in every pixel") {
  const Scene scene = textured_scene();
  for (const int samples : {1, 4})
    for (const Transfer transfer : {Transfer::linear, Transfer::srgb}) {
      const Verdict verdict =
          verdict_of(scene, eight_bits(scene, samples, Precision::double_, transfer), precise(), samples);
      CHECK(verdict.count(PixelClass::exact) == width * height);
      CHECK(verdict.details.empty());
      CHECK(verdict.is_explained());
    }
  CHECK(verdict_of(scene, floats(scene), precise()).count(PixelClass::exact) == width * height);
}

TEST_CASE("what is computed in single precision is explained, in 8 bits and in floats") {
  // Not trilinear: a device takes differences of neighbours, and we derivatives.
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear}) {
    const Scene scene = textured_scene(filter);
    CHECK(verdict_of(scene, eight_bits(scene, 1, Precision::float_), precise()).is_explained());
    const Verdict in_floats = verdict_of(scene, floats(scene, Precision::float_), precise());
    CHECK(in_floats.is_explained());
    CHECK(in_floats.count(PixelClass::shading) > 300);
  }
}

TEST_CASE("one pixel that is off by more than roundings is found") {
  const Scene scene = textured_scene();
  DeviceImage image = eight_bits(scene);
  const Verdict right = verdict_of(scene, image, precise());
  int x = 0, y = 0; // of a surface, in the middle
  for (y = height / 2, x = width / 2; *right.object.at(x, y) == 0; ++x) REQUIRE(x + 1 < width);
  image.colour.at(x, y)[1] += image.colour.at(x, y)[1] < 128 ? 2.0f : -2.0f;
  const Verdict wrong = verdict_of(scene, image, precise());
  CHECK(wrong.count(PixelClass::unexplained) == 1);
  CHECK(class_at(wrong, x, y) == PixelClass::unexplained);
  const JudgedDetail& detail = detail_at(wrong, x, y);
  CHECK(detail.objection == Objection::colour);
  CHECK(detail.object == 1);
  CHECK(detail.allowed.width() < 0.5);
  CHECK(std::abs(detail.actual.y - detail.reference.y) > 1);
  REQUIRE(wrong.clusters.size() == 1);
  CHECK(wrong.clusters[0].object == "knot");
  CHECK(wrong.clusters[0].where.pixels == 1);
}

TEST_CASE("NaN is explained by nothing") {
  const Scene scene = textured_scene();
  DeviceImage image = floats(scene);
  image.colour.at(3, 3)[0] = std::numeric_limits<float>::quiet_NaN();
  CHECK(verdict_of(scene, image, precise()).count(PixelClass::unexplained) == 1);
}

TEST_CASE("a level more or less is rounding only where the device may have rounded so") {
  const Scene scene = textured_scene();
  const DeviceImage image = eight_bits(scene);
  RenderOptions options = options_of();
  options.want_radiance = true;
  const Image<float> reference = render(scene, options).radiance;
  DeviceProfile exact = precise();
  exact.output.unorm_levels = 0.5;
  DeviceImage moved = image;
  long near_middle = 0;
  for (std::size_t i = 0; i < moved.colour.values.size(); ++i) {
    const double levels = std::clamp(255 * static_cast<double>(reference.values[i]), 0.0, 255.0);
    const float other = image.colour.values[i] + (levels > static_cast<double>(image.colour.values[i]) ? 1.0f : -1.0f);
    const double from_middle = std::abs(std::abs(levels - static_cast<double>(image.colour.values[i])) - 0.5);
    if (other < 0 || other > 255) continue;
    moved.colour.values[i] = other;
    near_middle += from_middle < 0.01;
  }
  const Verdict verdict = verdict_of(scene, moved, exact);
  CHECK(verdict.count(PixelClass::rounding) > 0);
  CHECK(verdict.count(PixelClass::unexplained) > 0.9 * width * height);
  CHECK(near_middle > 0);
}

TEST_CASE("the colour behind an edge is explained at the edge, and not a pixel farther") {
  // The edge runs through the centres of a column of pixels.
  WindowScene window(16);
  window.scene.background = {0.25, 0.25, 0.25};
  window.add({window.place(8.5, -8, 1), window.place(40, 8, 1), window.place(8.5, 24, 1)}, Double3(0.75));
  DeviceImage image;
  image.colour = window.frame().radiance;
  image.full_scale = 1, image.precision = StoredPrecision::floats(0x1p-24);
  DeviceImage other = image;
  const bool covered = image.colour.at(8, 5)[0] > 0.5f;
  for (int c = 0; c < 3; ++c) {
    other.colour.at(8, 5)[c] = covered ? 0.25f : 0.75f;
    other.colour.at(9, 6)[c] = 0.25f;
  }
  const Verdict verdict = judge(window.scene, other, precise(), {});
  CHECK(class_at(verdict, 8, 5) == PixelClass::edge);
  CHECK(class_at(verdict, 9, 6) == PixelClass::unexplained);
  // Neither colour, but between them: of one sample there is no such thing.
  for (int c = 0; c < 3; ++c) other.colour.at(8, 7)[c] = 0.5f;
  CHECK(class_at(judge(window.scene, other, precise(), {}), 8, 7) == PixelClass::unexplained);
}

TEST_CASE("any colour is explained where a surface without normals may be in front, and only there") {
  constexpr int side = 16;
  for (const bool has_normals : {false, true}) {
    WindowScene made(side);
    for (const float behind : {0.0f, 0x1p-23f}) { // nearer than two depths of 24 bits can tell apart
      const double w = static_cast<double>(1 + behind);
      made.add({made.place(4, 4, w), made.place(12, 4, w), made.place(4, 12, w)});
    }
    auto mesh = std::make_shared<Mesh>(*made.scene.objects[1].mesh);
    if (!has_normals) mesh->normals.assign(3, Float3(0));
    made.scene.objects[1].mesh = mesh;
    DeviceImage image;
    image.colour = made.frame().radiance;
    image.full_scale = 1, image.precision = StoredPrecision::floats(0x1p-24);
    for (const int at : {6, 14}) image.colour.at(at, 6)[0] = 0.75f; // on both triangles, and on none
    const Verdict verdict = verdict_of(made.scene, image, precise());
    CHECK(class_at(verdict, 6, 6) == (has_normals ? PixelClass::unexplained : PixelClass::undefined));
    CHECK(class_at(verdict, 14, 6) == PixelClass::unexplained);
  }
}

TEST_CASE("with several samples a pixel at an edge shows a mean, in steps of a sample") {
  WindowScene window(16);
  window.scene.background = {0.25, 0.25, 0.25};
  window.add({window.place(8.375, -8, 1), window.place(40, 8, 1), window.place(8.375, 24, 1)}, Double3(0.75));
  DeviceImage image; // 4 samples: at 3, 7, 11 and 15 sixteenths less one: one of them lies at 8.375
  image.colour = window.frame({}, 4).radiance;
  image.full_scale = 1, image.precision = StoredPrecision::floats(0x1p-24);
  JudgeOptions options;
  options.samples = 4;
  CHECK(judge(window.scene, image, precise(), options).count(PixelClass::exact) == 256);
  const float there = image.colour.at(8, 5)[0], step = 0.125f;
  const auto with = [&](float value) {
    DeviceImage other = image;
    for (int c = 0; c < 3; ++c) other.colour.at(8, 5)[c] = value;
    return class_at(judge(window.scene, other, precise(), options), 8, 5);
  };
  const bool may_be_less = with(there - step) == PixelClass::edge, may_be_more = with(there + step) == PixelClass::edge;
  CHECK(may_be_less != may_be_more); // that one sample
  CHECK(with(there + 3 * step) == PixelClass::unexplained);
  CHECK(with(there + step / 2) == PixelClass::unexplained);
}

TEST_CASE("ids and depth that are right change nothing; wrong ones are found though the colour is right") {
  const Scene scene = textured_scene();
  DeviceImage image = eight_bits(scene);
  add_ids_and_depth(image, scene);
  const Verdict right = verdict_of(scene, image, precise());
  CHECK(right.is_explained());
  CHECK(right.count(PixelClass::exact) == width * height);
  int x = width / 2, y = height / 2;
  while (*right.object.at(x, y) == 0) ++x;
  DeviceImage ids = image;
  ids.ids.at(x, y)[1] += 700; // of the far side
  const Verdict wrong_ids = verdict_of(scene, ids, precise());
  CHECK(wrong_ids.count(PixelClass::unexplained) == 1);
  CHECK(detail_at(wrong_ids, x, y).objection == Objection::surface);
  ids.ids.at(x, y)[0] = 9; // of no object
  CHECK(verdict_of(scene, ids, precise()).count(PixelClass::unexplained) == 1);
  DeviceImage depth = image;
  *depth.depth.at(x, y) -= 0.001f;
  const Verdict wrong_depth = verdict_of(scene, depth, precise());
  CHECK(wrong_depth.count(PixelClass::unexplained) == 1);
  CHECK(detail_at(wrong_depth, x, y).objection == Objection::depth);
}

TEST_CASE("where a texel's border runs through a pixel either texel is right, and nothing between them") {
  WindowScene window(16);
  // Two texels, 0 and 1, side by side; their border at x = 8.5, where pixel centres are.
  const auto texture = std::make_shared<Texture>();
  texture->full_scale = 1;
  texture->levels.push_back({2, 1, {}});
  for (const float value : {0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f}) texture->levels[0].rgb.push_back(value);
  Object& object = window.add({window.place(0.5, -8, 1), window.place(0.5, 24, 1), window.place(16.5, -8, 1),
                               window.place(16.5, -8, 1), window.place(0.5, 24, 1), window.place(16.5, 24, 1)},
                              Double3(0.5), {{0, 0}, {0, 1}, {1, 0}, {1, 0}, {0, 1}, {1, 1}});
  object.material.diffuse_map.texture = texture, object.material.diffuse_map.filter = TextureFilter::nearest;
  DeviceImage image;
  image.colour = window.frame().radiance;
  image.full_scale = 1, image.precision = StoredPrecision::floats(0x1p-24);
  const float here = image.colour.at(8, 4)[0];
  const auto with = [&](int x, float value) {
    DeviceImage other = image;
    for (int c = 0; c < 3; ++c) other.colour.at(x, 4)[c] = value;
    return class_at(judge(window.scene, other, precise(), {}), x, 4);
  };
  CHECK(with(8, 0.5f - here) == PixelClass::texel);
  CHECK(with(8, 0.25f) == PixelClass::unexplained);
  CHECK(with(9, 0.0f) == PixelClass::unexplained);
}

TEST_CASE("a light at the horizon of a cut highlight makes a branch: one side or the other") {
  WindowScene window(16);
  Object& object = window.add({window.place(-16, -16, 1), window.place(-16, 48, 1), window.place(48, -16, 1)});
  Phong shining;
  shining.ka = Double3(0.1), shining.kd = Double3(0), shining.ks = Double3(0.5), shining.glossiness = 0;
  shining.specular_gate = SpecularGate::cut_below_horizon;
  object.material.fragment_function = shining;
  // Along the surface, as far as floats tell.
  window.scene.direction_lights = {{Double3(-0.9f, 0, 0.3f), Double3(1)}};
  Mesh mesh = *object.mesh;
  mesh.normals.assign(3, Float3(0.3f, 0, 0.9f));
  object.mesh = std::make_shared<const Mesh>(mesh);
  DeviceImage image;
  image.colour = Image<float>(16, 16, 3, 0.1f);
  image.full_scale = 1, image.precision = StoredPrecision::floats(0x1p-24);
  const Verdict without = judge(window.scene, image, precise(), {});
  std::fill(image.colour.values.begin(), image.colour.values.end(), 0.6f);
  const Verdict with = judge(window.scene, image, precise(), {});
  std::fill(image.colour.values.begin(), image.colour.values.end(), 0.35f);
  const Verdict between = judge(window.scene, image, precise(), {});
  const PixelClass without_it = class_at(without, 8, 8), with_it = class_at(with, 8, 8);
  CHECK(without_it != PixelClass::unexplained);
  CHECK(with_it != PixelClass::unexplained);
  CHECK((without_it == PixelClass::branch || with_it == PixelClass::branch));
  CHECK(class_at(between, 8, 8) == PixelClass::unexplained);
}

TEST_CASE("a wider profile never takes an explanation away") {
  const Scene scene = textured_scene(TextureFilter::trilinear);
  DeviceImage image = eight_bits(scene, 1, Precision::float_);
  for (std::size_t i = 0; i < image.colour.values.size(); i += 7)
    image.colour.values[i] = std::clamp(image.colour.values[i] + static_cast<float>(i % 5) - 2, 0.0f, 255.0f);
  const Verdict narrow = verdict_of(scene, image, device_profile("llvmpipe-precise"));
  const Verdict wide = verdict_of(scene, image, device_profile("llvmpipe"));
  const Verdict widest = verdict_of(scene, image, device_profile("gl-generic"));
  CHECK(narrow.count(PixelClass::unexplained) > wide.count(PixelClass::unexplained));
  CHECK(wide.count(PixelClass::unexplained) >= widest.count(PixelClass::unexplained));
  for (std::size_t i = 0; i < narrow.classes.values.size(); ++i) {
    const auto unexplained = static_cast<std::uint8_t>(PixelClass::unexplained);
    if (narrow.classes.values[i] != unexplained) REQUIRE(wide.classes.values[i] != unexplained);
    if (wide.classes.values[i] != unexplained) REQUIRE(widest.classes.values[i] != unexplained);
  }
}

TEST_CASE("power says how sharp the check was, and why") {
  const Scene scene = textured_scene(TextureFilter::trilinear);
  const DeviceImage image = eight_bits(scene);
  const Verdict narrow = verdict_of(scene, image, precise()),
                widest = verdict_of(scene, image, device_profile("gl-generic"));
  for (const Verdict* verdict : {&narrow, &widest}) {
    const JudgePower& power = verdict->power;
    CHECK(power.pixels > 50);
    CHECK(power.below_tenth <= power.below_one);
    CHECK(power.below_one <= power.below_four);
    double sum = 0;
    for (const double share : verdict->causes) sum += share;
    CHECK(sum == doctest::Approx(1));
  }
  CHECK(narrow.power.median < widest.power.median);
  CHECK(widest.causes[static_cast<std::size_t>(BoundCause::texture)] +
            widest.causes[static_cast<std::size_t>(BoundCause::level_of_detail)] >
        0.2);
}

TEST_CASE("a drift that no pixel shows is found in the whole, and none where there is none") {
  Scene scene = textured_scene();
  scene.objects[0].material.diffuse_map.texture = nullptr;
  scene.objects[0].mesh = std::make_shared<const Mesh>(sphere_mesh(96, 48));
  scene.objects[0].scale = Double3(1.6);
  DeviceProfile profile = precise();
  profile.output.unorm_levels = 0.6; // a level is right that is a tenth beyond the middle
  const auto judged = [&](double factor) {
    Scene other = scene;
    std::get<BlinnPhong>(other.objects[0].material.fragment_function).kd *= factor;
    RenderOptions options = options_of();
    options.width *= 4, options.height *= 4;
    const Frame frame = render(other, options);
    DeviceImage image;
    image.colour = Image<float>(options.width, options.height, 3);
    std::copy(frame.rgb8.values.begin(), frame.rgb8.values.end(), image.colour.values.begin());
    image.precision = StoredPrecision::integers(255);
    return judge(scene, image, profile, {});
  };
  const Verdict right = judged(1), drifted = judged(1 - 0x1p-11);
  REQUIRE(right.biases.size() == 1);
  CHECK(!right.biases[0].is_biased());
  CHECK(right.biases[0].values > 10'000);
  CHECK(drifted.count(PixelClass::unexplained) < 100); // at most 0.12 levels
  REQUIRE(drifted.biases.size() == 1);
  CHECK(drifted.biases[0].is_biased());
  CHECK(drifted.biases[0].mean < 0);
}

TEST_CASE("images of other sizes are refused") {
  const Scene scene = textured_scene();
  DeviceImage image = eight_bits(scene);
  image.ids = Image<float>(width, height - 1, 2);
  CHECK_THROWS_AS(verdict_of(scene, image, precise()), std::invalid_argument);
  image.ids = {};
  image.colour = Image<float>(width, height, 4);
  CHECK_THROWS_AS(verdict_of(scene, image, precise()), std::invalid_argument);
}

TEST_CASE("the same verdict for any number of threads") {
  const Scene scene = textured_scene(TextureFilter::trilinear);
  DeviceImage image = eight_bits(scene, 1, Precision::float_);
  for (std::size_t i = 0; i < image.colour.values.size(); i += 11)
    image.colour.values[i] = 255 - image.colour.values[i];
  JudgeOptions options;
  options.threads = 1;
  const Verdict one = judge(scene, image, precise(), options);
  options.threads = 3;
  const Verdict three = judge(scene, image, precise(), options);
  CHECK(one.classes.values == three.classes.values);
  CHECK(one.width_levels.values == three.width_levels.values);
  CHECK(one.causes == three.causes);
  CHECK(one.power.median == three.power.median);
}

} // namespace refraster::test
