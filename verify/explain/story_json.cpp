#include "verify/explain/story_json.h"

#include "io/file/build_info.h"
#include "io/json/report_parts.h"

#include <array>

namespace refraster {
namespace {

std::vector<double> listed(const Double3& v) {
  return {v.x, v.y, v.z};
}
std::vector<double> listed(const Double2& v) {
  return {v.x, v.y};
}
template <class Value, std::size_t n>
std::vector<Value> listed(const std::array<Value, n>& values) {
  return {values.begin(), values.end()};
}

class StoryWriter {
public:
  std::string text(const PixelStory& s) {
    json_.object([&] {
      json_.member("schema", report_schema);
      json_.object("refraster", [&] { write_build(json_, this_build()); });
      json_.member("scene", s.scene);
      write_size(json_, s.width, s.height);
      json_.member("pixel", std::vector<int>{s.x, s.y});
      json_.member("samples", s.samples);
      json_.member("transfer", s.transfer == Transfer::srgb ? "srgb" : "linear");
      json_.array("coverage", [&] {
        for (const SampleStory& sample : s.sample_stories) write(sample);
      });
      json_.array("fragments", [&] {
        for (const FragmentStory& fragment : s.fragments) write(fragment);
      });
      json_.object("background", [&] {
        json_.member("radiance", listed(s.background));
        json_.member("samples", s.background_samples);
        json_.array("near", [&] {
          for (const NearMiss& miss : s.near_misses) write(miss);
        });
      });
      json_.object("precisions", [&] {
        for (const PrecisionStory& precision : s.precisions) write(precision);
      });
      json_.optional("bounds", s.bounds, [&](const BoundsStory& bounds) { write(bounds); });
      json_.optional("actual", s.actual, [&](const ActualStory& actual) { write(actual); });
    });
    return json_.text();
  }

private:
  void write_members(const NamedTriangle& of) {
    json_.member("object", of.object);
    json_.member("name", of.name);
    json_.member("triangle", of.triangle);
  }

  void write_undefined(const UndefinedCounts& counts) {
    json_.object("undefined", [&] {
      for (std::size_t i = 0; i < undefined_names.size(); ++i)
        if (counts.counts[i] > 0) json_.member(undefined_names[i], counts.counts[i]);
    });
  }

  void write(const SampleStory& sample) {
    json_.object([&] {
      json_.member("at", std::vector<double>{sample.x, sample.y});
      json_.array("candidates", [&] {
        for (const CoveringTriangle& c : sample.candidates)
          json_.object([&] {
            write_members(c.of);
            json_.member("fate", name_of(c.fate));
            json_.member("side", name_of(c.side));
            json_.member("depth", c.depth);
            json_.optional("weights", c.weights, [&](const auto& weights) { json_.value(listed(weights)); });
            json_.optional("radiance", c.radiance, [&](const Double3& rgb) { json_.value(listed(rgb)); });
            if (c.opacity) {
              json_.member("opacity", c.opacity->value);
              json_.member("opacity_threshold", c.opacity->threshold);
            }
          });
      });
    });
  }

  void write(const NearMiss& miss) {
    json_.object([&] {
      write_members(miss.of);
      json_.member("offset", std::vector<double>{miss.dx, miss.dy});
    });
  }

  void write(const std::vector<ParameterStory>& parameters) {
    json_.object("parameters", [&] {
      for (const ParameterStory& p : parameters)
        if (!p.word.empty()) json_.member(p.name, p.word);
        else if (p.numbers.size() == 1) json_.member(p.name, p.numbers.front());
        else json_.member(p.name, p.numbers);
    });
  }

  void write(const TextureStory& t) {
    json_.object([&] {
      json_.member("filter", name_of(t.filter));
      write_size(json_, t.width, t.height);
      json_.member("levels", t.levels);
      json_.member("level_of_detail", t.level_of_detail);
      json_.member("uv_right", listed(t.uv_right));
      json_.member("uv_down", listed(t.uv_down));
      json_.array("texels", [&] {
        for (const Texel& texel : t.texels)
          json_.object([&] {
            json_.member("level", texel.level);
            json_.member("texel", std::vector<int>{texel.i, texel.j});
            json_.member("weight", texel.weight);
            json_.member("value", listed(texel.value));
          });
      });
    });
  }

  void write(const MerlStory& m) {
    json_.object([&] {
      json_.member("theta_h", m.theta_h);
      json_.member("theta_d", m.theta_d);
      json_.member("phi_d", m.phi_d);
      json_.member("bins", std::vector<double>{m.u, m.v, m.w});
      json_.array("taps", [&] {
        for (const MerlTap& tap : m.taps)
          json_.object([&] {
            json_.member("bin", std::vector<int>{tap.theta_h, tap.theta_d, tap.phi_d});
            json_.member("weight", tap.weight);
            json_.member("unmeasured", tap.unmeasured);
            json_.member("f", listed(tap.f));
          });
      });
      json_.member("f", listed(m.f));
      json_.member("unmeasured", m.unmeasured);
      json_.member("lit", m.lit);
    });
  }

  void write(const MicrofacetStory& m) {
    json_.object([&] {
      json_.member("alpha", m.alpha);
      json_.member("density", m.density);
      json_.member("cosine_over_divisor", m.cosine_over_divisor);
      json_.member("fresnel", listed(m.fresnel));
      json_.member("lit", m.lit);
    });
  }

  void write(const ShadowMapStory& map) {
    json_.object([&] {
      json_.member("face", map.face);
      json_.member("place", std::vector<double>{map.u, map.v});
      json_.member("depth", map.depth);
      json_.array("taps", [&] {
        for (const ShadowTapStory& tap : map.taps)
          json_.object([&] {
            json_.member("texel", std::vector<int>{tap.column, tap.row});
            json_.member("weight", tap.weight);
            json_.member("stored", tap.stored);
            json_.member("lit", tap.lit);
          });
      });
    });
  }

  void write(const LightStory& light, const Double3& exact) {
    const auto colour = [&](std::string_view name, const std::optional<Double3>& rgb) {
      json_.optional(name, rgb, [&](const Double3& value) { json_.value(listed(value)); });
    };
    json_.object([&] {
      json_.member("type", light.type);
      json_.member("index", light.index);
      json_.member("direction", listed(light.direction));
      json_.member("distance", light.distance);
      json_.member("attenuation", light.attenuation);
      write(light.parameters);
      json_.optional("shadow", light.shadow, [&](const ShadowStory& shadow) {
        json_.object([&] {
          json_.member("visibility", shadow.visibility);
          json_.optional("between", shadow.between,
                         [&](const NamedTriangle& of) { json_.object([&] { write_members(of); }); });
          json_.optional("reflected", shadow.reflected, [&](const Double3& rgb) { json_.value(listed(rgb)); });
          json_.optional("map", shadow.map, [&](const ShadowMapStory& map) { write(map); });
        });
      });
      json_.member("arriving", listed(light.arriving));
      json_.member("n_l", light.n_l);
      json_.optional("lobe", light.lobe, [&](const LobeStory& lobe) {
        json_.object([&] {
          json_.member("of", lobe.cosine_name);
          json_.member("vector", listed(lobe.vector));
          json_.member("cosine", lobe.cosine);
          json_.member("value", lobe.value);
        });
      });
      colour("diffuse", light.diffuse);
      colour("specular", light.specular);
      json_.optional("merl", light.merl, [&](const MerlStory& merl) { write(merl); });
      if (light.microfacet) json_.optional("microfacet", light.microfacet, [&](const MicrofacetStory& m) { write(m); });
      json_.member("reflected", listed(light.reflected));
      json_.member("reflected_exact", listed(exact));
      write_undefined(light.undefined);
    });
  }

  void write(const FragmentStory& f) {
    json_.object([&] {
      write_members(f.of);
      json_.member("samples", f.samples);
      json_.member("weights", listed(f.weights));
      json_.member("position", listed(f.position));
      json_.member("interpolated_normal", listed(f.interpolated_normal));
      json_.member("normal", listed(f.normal));
      if (const auto& maps = f.maps_of_normal)
        json_.object("maps_of_normal", [&] {
          json_.member("unmapped", listed(maps->unmapped));
          json_.member("tangent", listed(maps->tangent));
          json_.member("handedness", maps->handedness);
          json_.member("direction", listed(maps->direction));
          const auto reading = [&](std::string_view name, const std::optional<TextureStory>& texture) {
            if (texture) json_.optional(name, texture, [&](const TextureStory& t) { write(t); });
          };
          reading("normal_map", maps->normal_map), reading("bump_map", maps->bump_map);
        });
      if (f.turned) json_.member("turned", true);
      json_.member("to_eye", listed(f.to_eye));
      json_.member("n_v", f.n_v);
      json_.optional("uv", f.uv, [&](const Double2& uv) { json_.value(listed(uv)); });
      json_.optional("texture", f.texture, [&](const TextureStory& texture) { write(texture); });
      json_.optional("vertex_colour", f.vertex_colour, [&](const Double3& colour) { json_.value(listed(colour)); });
      json_.member("texture_colour", listed(f.texture_colour));
      const auto further = [&](std::string_view name, const std::optional<TextureStory>& texture) {
        if (texture) json_.optional(name, texture, [&](const TextureStory& t) { write(t); });
      };
      further("specular_map", f.specular_map), further("emissive_map", f.emissive_map);
      further("roughness_map", f.roughness_map), further("metallic_map", f.metallic_map);
      if (f.specular_colour) json_.member("specular_colour", listed(*f.specular_colour));
      if (f.emission) json_.member("emission", listed(*f.emission));
      json_.object("material", [&] {
        if (!f.material.empty()) json_.member("name", f.material);
        json_.member("fragment_function", f.function);
        json_.member("user_function", f.user_function);
        write(f.parameters);
      });
      json_.member("ambient", listed(f.ambient));
      json_.member("ambient_exact", listed(f.exact.ambient));
      json_.array("lights", [&] {
        for (std::size_t i = 0; i < f.lights.size(); ++i) write(f.lights[i], f.exact.reflected[i]);
      });
      json_.member("radiance", listed(f.radiance));
      json_.member("radiance_exact", listed(f.exact.radiance));
      write_undefined(f.undefined);
    });
  }

  void write(const PrecisionStory& p) {
    json_.object(name_of(p.precision), [&] {
      json_.member("radiance", listed(p.radiance));
      json_.member("levels", listed(p.levels));
      json_.member("srgb_levels", listed(p.srgb));
    });
  }

  void write(const BoundsStory& b) {
    json_.object([&] {
      json_.member("least", listed(b.least));
      json_.member("most", listed(b.most));
      json_.array("causes", [&] {
        for (const BoundsStory::Cause& cause : b.causes)
          json_.object([&] {
            json_.member("what", cause.what);
            json_.member("fraction", cause.fraction);
          });
      });
    });
  }

  void write(const ActualStory& a) {
    json_.object([&] {
      json_.member("file", a.path);
      json_.member("stored", listed(a.stored));
      json_.member("full_scale", a.full_scale);
      json_.member("least", listed(a.least));
      json_.member("most", listed(a.most));
      json_.member("levels", listed(a.levels));
      json_.member("difference", listed(a.difference));
      json_.member("same", a.same);
      json_.array("would_be", [&] {
        for (const WouldBe& w : a.would_be) write(w);
      });
    });
  }

  void write(const WouldBe& w) {
    static constexpr std::array<std::string_view, 3> kinds = {"factor", "channels", "pixel"};
    const std::size_t numbers = w.kind == WouldBe::Kind::factor ? 1 : 3;
    const auto first = [&](const std::array<double, 3>& values) {
      return std::vector<double>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(numbers));
    };
    json_.object([&] {
      json_.member("kind", kinds[static_cast<std::size_t>(w.kind)]);
      json_.member("what", w.what);
      json_.member("now", first(w.now));
      json_.member("least", first(w.least));
      json_.member("most", first(w.most));
      json_.text_or_null("remark", w.remark);
    });
  }

  JsonWriter json_;
};

} // namespace

std::string story_json(const PixelStory& story) {
  return StoryWriter().text(story);
}

} // namespace refraster
