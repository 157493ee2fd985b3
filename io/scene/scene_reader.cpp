#include "io/scene/scene_reader.h"

#include "io/file/nearest.h"
#include "io/file/text.h"
#include "io/scene/scene_edits.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <vector>

namespace refraster {
namespace {

template <std::size_t... I>
void for_each_shape(auto&& visit, std::index_sequence<I...>) {
  (visit(std::variant_alternative_t<I, Shape>{}), ...);
}
void for_each_shape(auto&& visit) {
  for_each_shape(visit, std::make_index_sequence<std::variant_size_v<Shape>>{});
}

bool is_zero(const Double3& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
}

} // namespace

std::optional<std::size_t> fragment_function_of(const ObjectText& text) {
  if (text.fragment_function.given) return text.fragment_function.index;
  if (text.fragment_shader.given.empty() && text.material_from == MaterialFrom::file) return place_of<BlinnPhong>();
  const std::string stem = std::filesystem::path(text.fragment_shader.given).stem().string();
  std::optional<std::size_t> result;
  for_each_fragment_function([&](auto function, std::size_t index) {
    for (const std::string_view listed : function.shader_stems)
      if (stem == listed) result = index;
  });
  return result;
}

JsonIndex SceneReader::find(std::string_view key) const {
  for (JsonIndex i = document_[object_].first_child; i; i = document_[i].next)
    if (document_[i].key == key) return i;
  return 0;
}

JsonIndex SceneReader::claim(std::string_view key, Presence presence, const std::string& expected) {
  known_.push_back(key);
  const JsonIndex found = find(key);
  if (!found) {
    if (presence.need == Presence::Need::required) missing(key, expected);
    return 0;
  }
  for (JsonIndex i = document_[found].next; i; i = document_[i].next)
    if (document_[i].key == key)
      faults_.add_from([&] {
        return document_.fault_at(document_[i].key_begin, path_of(key), "the key a second time", "each key once");
      });
  return found;
}

bool SceneReader::is_known(std::string_view key) const {
  return std::find(known_.begin(), known_.end(), key) != known_.end();
}

std::string SceneReader::path_of(std::string_view key) const {
  return path_ + '/' + shown_part(key);
}

std::string SceneReader::shown_part(std::string_view key) {
  std::string result = pointer_part(key.substr(0, 60));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20) c = '?';
  return result;
}

void SceneReader::missing(std::string_view key, const std::string& expected) {
  sound_ = false;
  faults_.add_from([&] { return document_.fault_at(document_[object_].begin, path_of(key), "nothing", expected); });
}

void SceneReader::not_expected_at(JsonIndex found, std::string path, const std::string& expected) {
  faults_.add_from([&] {
    const JsonNode& node = document_[found];
    return document_.fault_at(node.begin, std::move(path), document_.describe(node), expected);
  });
}

void SceneReader::not_expected(JsonIndex found, std::string_view key, const std::string& expected) {
  sound_ = false;
  not_expected_at(found, path_of(key), expected);
}

void SceneReader::fault(std::string_view key, const std::string& found, const std::string& expected) {
  const JsonIndex at = find(key);
  faults_.add_from(
      [&] { return document_.fault_at(document_[at ? at : object_].begin, path_of(key), found, expected); });
}

void SceneReader::finish() {
  for (JsonIndex i = document_[object_].first_child; i; i = document_[i].next) {
    const JsonNode& node = document_[i];
    if (is_known(node.key)) continue;
    faults_.add_from([&] {
      return document_.fault_at(node.key_begin, path_of(node.key), "an unknown key", one_of(known_, node.key));
    });
  }
}

namespace {

/// Reads the parameters of a fragment function of the user's.
class ParameterReader final : public FieldVisitor {
public:
  ParameterReader(SceneReader& reader, Use use) : reader_(reader), use_(use) {}
  void field(std::string_view key, double& value, const Range& range, std::string_view meaning) override {
    read(key, value, range, meaning, is_required<double>(range) ? required : defaulted);
  }
  void field(std::string_view key, Double3& value, const Range& range, std::string_view meaning) override {
    read(key, value, range, meaning, is_required<Double3>(range) ? required : defaulted);
  }
  void field(std::string_view key, NamedValue& value, const Range& range, std::string_view meaning) override {
    read(key, value, range, meaning, defaulted);
  }

private:
  void read(std::string_view key, auto& value, const Range& range, std::string_view meaning, Presence own) {
    if (use_ == Use::other && reader_.is_known(key)) return;
    reader_(key, value, range, meaning, use_ == Use::own ? own : defaulted);
  }

  SceneReader& reader_;
  Use use_;
};

} // namespace

void SceneReader::parameters(UserFunction& function, Use use) {
  ParameterReader reader(*this, use);
  function.fields(reader);
}

void SceneReader::shape(std::string_view key, std::optional<Shape>& shape, std::string_view) {
  std::string names;
  std::vector<std::string_view> known;
  for_each_shape([&](auto s) {
    names += (names.empty() ? "" : " or ") + std::string(s.name);
    known.push_back(s.name);
  });
  const std::string expected = "an object with one key: " + names;
  const JsonIndex found = claim(key, defaulted, expected);
  if (!found) return;
  if (document_[found].kind != JsonKind::object || document_[found].children != 1)
    return not_expected(found, key, expected);
  const JsonIndex inner = document_[found].first_child;
  for_each_shape([&]<class S>(S listed) {
    if (document_[inner].key != S::name) return;
    read_object(inner, path_of(key) + '/' + std::string(S::name), [&](SceneReader& keys) { S::fields(listed, keys); });
    shape = listed;
  });
  if (shape) return;
  faults_.add_from([&] {
    const std::string_view word = document_[inner].key;
    return document_.fault_at(document_[inner].key_begin, path_of(key), in_quotes(word),
                              expected + did_you_mean(known, word));
  });
}

void SceneReader::map(std::string_view key, MapText& text, std::string_view, std::string_view short_form,
                      Double3* multiplied) {
  const std::string expected = expected_map();
  const JsonIndex found = claim(key, defaulted, expected);
  if (!found) return;
  if (!short_form.empty() && find(short_form))
    return fault(key, std::string(key) + " beside " + std::string(short_form), "one of the two");
  if (multiplied) *multiplied = Double3(1);
  const JsonNode& node = document_[found];
  if (node.kind == JsonKind::object)
    return read_object(found, path_of(key), [&](SceneReader& keys) { map_keys(text, keys); });
  if (!read_value(document_, node, Range{}, text.path)) return not_expected(found, key, expected);
  text.path.offset = node.begin, text.path.json_path = path_of(key);
}

void SceneReader::normals(std::string_view key, MeshNormals& normals, std::string_view) {
  const std::string expected = expected_normals();
  const JsonIndex found = claim(key, defaulted, expected);
  if (!found) return;
  if (document_[found].kind != JsonKind::object) {
    if (!read_value(document_, document_[found], Range{}, normals.from)) not_expected(found, key, expected);
    return;
  }
  normals.from = NormalsFrom::crease;
  read_object(found, path_of(key), [&](SceneReader& keys) { crease_keys(normals, keys); });
}

bool SceneReader::is_from_file(JsonIndex node) const {
  return document_[node].kind == JsonKind::string && document_[node].string == from_file_word;
}

void SceneReader::expect_material(std::string_view key, ObjectText& text) const {
  const JsonIndex found = find(key);
  const bool from_file = found ? is_from_file(found) : !text.obj_file.given.empty();
  text.material_from = from_file ? MaterialFrom::file : MaterialFrom::scene;
}

void SceneReader::check(Camera& camera, SceneView& view) {
  if (!sound_) return;
  if (is_zero(camera.up)) return fault("up", "a vector of length 0", "a direction");
  if (view.fit) return check_fit(camera, *view.fit);
  if (!find("target")) camera.target = camera.position + Double3(0, 0, -1);
  if (camera.near >= camera.far)
    fault(find("far") ? "far" : "near", "a far plane that is not beyond the near one", "near < far");

  const Double3 sight = camera.target - camera.position;
  const double distance = length(sight);
  if (!(distance > 0) || !std::isfinite(distance))
    return fault(find("target") ? "target" : "position",
                 distance > 0 ? "a line of sight too long for a double" : "the camera's position",
                 "a target away from the position");
  // Each unit vector's components are within 3 ulp (scale exact, root, reciprocal and product half an ulp each and a
  // sum), so the cross product of two that are parallel stays below 2 * 2 * 3 half-ulps of 1. Closer than that to the
  // line of sight, "up" gives no direction but rounding noise.
  constexpr double noise = 12 * std::numeric_limits<double>::epsilon();
  if (!(length(cross(normalize(sight), normalize(camera.up))) > noise))
    fault(find("up") ? "up" : "target", "an up vector along the line of sight", "up not parallel to target - position");
}

void SceneReader::check_fit(const Camera& camera, CameraFit& fit) {
  if (find("position")) fault("position", "both position and fit", "one of the two");
  if (find("target")) fit.target = camera.target;
  if (find("near")) fit.near = camera.near;
  if (find("far")) fit.far = camera.far;
  if (fit.near && fit.far && *fit.near >= *fit.far)
    fault("far", "a far plane that is not beyond the near one", "near < far");
}

void SceneReader::check_direction(std::string_view key, const Double3& value, const Range& range) {
  if (sound_ && range.zero == Zero::excluded && is_zero(value)) fault(key, "a vector of length 0", "a direction");
}

void SceneReader::check(ObjectText& text) {
  const bool has_file = find("obj_file_path"), has_shape = find("mesh");
  if (has_file && has_shape) fault("mesh", "both obj_file_path and mesh", "one of the two");
  if (!has_file && !has_shape) missing("obj_file_path", "the path of a file, or the key mesh");
  const bool any_from_file = text.material_from == MaterialFrom::file ||
                             std::any_of(text.materials.begin(), text.materials.end(),
                                         [](const ObjectText& one) { return one.material_from == MaterialFrom::file; });
  if (has_shape && text.material_from == MaterialFrom::file)
    fault("material", "\"from_file\" beside mesh", "an object: a shape has no materials of its own");
  if (has_shape && find("materials")) fault("materials", "materials beside mesh", "obj_file_path: a shape has none");
  if (const auto function = fragment_function_of(text); any_from_file && function && *function != place_of<Phong>() &&
                                                        *function != place_of<BlinnPhong>() &&
                                                        *function != place_of<Microfacet>())
    fault(find("fragment_function") ? "fragment_function" : "fragment_shader_file_path",
          "a function that files describe no materials for",
          "phong, blinn_phong or microfacet, or no material \"from_file\"");
  if (has_shape && find("normals")) fault("normals", "normals beside mesh", "obj_file_path: a shape has its own");
  if (has_shape && find("vertex_colors"))
    fault("vertex_colors", "vertex_colors beside mesh", "obj_file_path: a shape has no colours");
  if (!text.fragment_shader.given.empty() && !fragment_function_of(text) && !text.fragment_function.given) {
    std::string stems;
    for_each_fragment_function([&](auto function, std::size_t) {
      for (const std::string_view stem : function.shader_stems)
        stems += (stems.empty() ? "" : ", ") + std::string(stem);
    });
    fault("fragment_shader_file_path", in_quotes(text.fragment_shader.given),
          "a file with the stem " + stems + "; or the key fragment_function");
  }
}

} // namespace refraster
