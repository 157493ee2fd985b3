#include "bench/cliffs/shapes.h"
#include "scenes/synthesis/merl_synthesis.h"

#include <cmath>

namespace refraster::cliffs {
namespace {

constexpr double first = 1 << 18; // pixels

template <class Change>
Work shaded(double size, const Change& change) {
  Work work = filled(size, object_of(Mesh{}).material);
  change(work.scene, work.scene.objects[0].material);
  return work;
}
BlinnPhong& function_of(Material& material) {
  return std::get<BlinnPhong>(material.fragment_function);
}

template <TextureFilter filter, int side, int repeats>
Work textured(double size) {
  return shaded(size, [](Scene&, Material& material) {
    material.diffuse_map = {noise(side, filter == TextureFilter::trilinear), filter};
    material.diffuse_map.scale = Double2(repeats);
  });
}
Work cut_out(double size) {
  Work work = shaded(size, [](Scene&, Material& material) { material.opacity_map = {noise(64, false)}; });
  work.layers = 2;
  return work;
}
Work normals_turned(double size) {
  Work work = shaded(size, [](Scene&, Material& material) { material.normal_map = {noise(64, false)}; });
  change_mesh(work, [](Mesh& mesh) { add_tangents(mesh); });
  return work;
}
Work vertex_colours(double size) {
  Work work = shaded(size, [](Scene&, Material&) {});
  change_mesh(work, [](Mesh& mesh) { mesh.colours.assign(mesh.positions.size(), Float3(0.5f)); });
  return work;
}
Work specular_and_emissive(double size) {
  return shaded(size, [](Scene&, Material& material) {
    material.specular_map = material.emissive_map = {noise(64, false)};
    material.emissive = Double3(0.2);
  });
}
Work from_both_sides(double size) {
  Work work = shaded(size, [](Scene&, Material&) {});
  work.scene.objects[0].two_sided = TwoSided::yes;
  work.scene.objects[0].scale = {-1, 1, -1};
  return work;
}

template <MerlLookup lookup>
Work measured(double size) {
  static const std::shared_ptr<const MerlTable> table(new MerlTable(merl_table_from(brdf_presets()[0].brdf)));
  return shaded(size, [](Scene&, Material& material) {
    Merl merl;
    merl.table = table, merl.lookup = lookup;
    material.fragment_function = merl;
  });
}

Work sharp_highlight(double size) {
  return shaded(size, [](Scene&, Material& material) { function_of(material).glossiness = 1e6; });
}
Work broken_exponent(double size) {
  return shaded(size, [](Scene&, Material& material) { function_of(material).glossiness = 20.37; });
}
Work tiny_values(double size) {
  return shaded(size, [](Scene& scene, Material& material) {
    BlinnPhong& f = function_of(material);
    f.ka = f.kd = f.ks = Double3(1e-30);
    scene.point_lights[0].radiance = Double3(1e-300);
  });
}
Work huge_values(double size) {
  return shaded(size, [](Scene& scene, Material& material) {
    function_of(material).kd = Double3(1e30);
    scene.point_lights[0].radiance = Double3(1e300);
  });
}
Work without_normals(double size) {
  Work work = shaded(size, [](Scene&, Material&) {});
  change_mesh(work, [](Mesh& mesh) { mesh.normals.assign(mesh.positions.size(), Float3(0)); });
  return work;
}
Work grazing_light(double size) {
  return shaded(size, [](Scene& scene, Material&) { scene.point_lights[0].position = {50, 0, 1e-9}; });
}

/// A ring of lights, of one type.
Work lights(double size, bool points) {
  return shaded(first, [&](Scene& scene, Material&) {
    scene.point_lights.clear();
    for (int i = 0; i < static_cast<int>(size); ++i) {
      const double a = 6.28 * i / size;
      const Double3 place(3 * std::cos(a), 3 * std::sin(a), 4);
      if (points) scene.point_lights.push_back({place, Double3(1 / size), 1, 0.1, 0.01});
      else scene.direction_lights.push_back({-place, Double3(1 / size)});
    }
  });
}
Work point_lights(double size) {
  return lights(size, true);
}
Work direction_lights(double size) {
  return lights(size, false);
}

constexpr Family families[] = {
    {"a texture's nearest texels", Grows::pixels, first, textured<TextureFilter::nearest, 256, 1>},
    {"a texture, bilinear", Grows::pixels, first, textured<TextureFilter::bilinear, 256, 1>},
    {"a texture, trilinear", Grows::pixels, first, textured<TextureFilter::trilinear, 256, 1>},
    {"a texture of 4,096 x 4,096, many texels a pixel", Grows::pixels, first,
     textured<TextureFilter::bilinear, 4096, 7>},
    {"the same with mip levels", Grows::pixels, first, textured<TextureFilter::trilinear, 4096, 7>},
    {"half of a surface cut out by opacity, at random", Grows::pixels, first, cut_out},
    {"normals turned by a map", Grows::pixels, first, normals_turned},
    {"colours of vertices", Grows::pixels, first, vertex_colours},
    {"maps of highlights and of emission", Grows::pixels, first, specular_and_emissive},
    {"two-sided surfaces seen from behind", Grows::pixels, first, from_both_sides},
    {"a measured BRDF, nearest", Grows::pixels, first, measured<MerlLookup::nearest>},
    {"a measured BRDF, trilinear", Grows::pixels, first, measured<MerlLookup::trilinear>},
    {"a measured BRDF, splines on logarithms", Grows::pixels, first, measured<MerlLookup::tricubic_log>,
     "64 samples and 21 splines of three channels"},
    {"a highlight of exponent 1,000,000", Grows::pixels, first, sharp_highlight},
    {"a highlight of exponent 20.37", Grows::pixels, first, broken_exponent},
    {"light below the smallest normal number", Grows::pixels, first, tiny_values},
    {"light beyond the largest number", Grows::pixels, first, huge_values},
    {"normals of length 0", Grows::pixels, first, without_normals},
    {"light that grazes a surface", Grows::pixels, first, grazing_light},
    {"point lights", Grows::lights, 16, point_lights},
    {"direction lights", Grows::lights, 16, direction_lights},
};

} // namespace

std::span<const Family> shading_families() {
  return families;
}

} // namespace refraster::cliffs
