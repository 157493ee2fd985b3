#pragma once
// The reading of scene_keys.h that takes values out of a JSON file.

#include "io/file/fault_list.h"
#include "io/file/limits.h"
#include "io/scene/value_kinds.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

/// Reads one object of the file. Whatever is wrong with it becomes a fault, and its value keeps its default.
/// Call the keys in any order, then finish().
class SceneReader {
public:
  SceneReader(const JsonDocument& document, JsonIndex object, std::string path, FaultList& faults)
      : document_(document), object_(object), path_(std::move(path)), faults_(faults) {}

  template <class Value>
  void operator()(std::string_view key, Value&& value, const Range& range, std::string_view, Presence presence) {
    const std::string expected = expected_value(value, range);
    const JsonIndex found = claim(key, presence, expected);
    if (found && !read_value(document_, document_[found], range, value)) not_expected(found, key, expected);
    if constexpr (std::is_same_v<Value, PathText&>)
      if (found) value.offset = document_[found].begin, value.json_path = path_of(key);
  }

  template <class Declare>
  void object(std::string_view key, Presence presence, std::string_view, Declare&& declare) {
    const JsonIndex found = claim(key, presence, "an object");
    if (found) read_object(found, path_of(key), declare);
  }

  template <class Content, class Declare>
  void optional_object(std::string_view key, std::optional<Content>& content, std::string_view, Declare&& declare) {
    const JsonIndex found = claim(key, defaulted, "an object");
    if (found) read_object(found, path_of(key), [&](SceneReader& keys) { declare(content.emplace(), keys); });
  }

  template <class Item, class Declare>
  void list(std::string_view key, Presence presence, const Limit& most, std::string_view, std::vector<Item>& items,
            Declare&& declare) {
    const JsonIndex found = claim(key, presence, "an array");
    if (!found) return;
    if (document_[found].kind != JsonKind::array) return not_expected(found, key, "an array");
    if (document_[found].children > most.value) return not_expected(found, key, at_most(most));
    items.reserve(document_[found].children);
    int count = 0;
    for (JsonIndex i = document_[found].first_child; i; i = document_[i].next)
      read_object(i, path_of(key) + '/' + std::to_string(count++),
                  [&](SceneReader& keys) { declare(items.emplace_back(), keys); });
  }

  void shape(std::string_view key, std::optional<Shape>& shape, std::string_view);
  void normals(std::string_view key, MeshNormals& normals, std::string_view);
  template <class Declare>
  void shadow(std::string_view key, CastShadow& shadow, std::string_view, Declare&& declare) {
    const std::string expected = expected_shadow();
    const JsonIndex found = claim(key, defaulted, expected);
    if (!found) return;
    if (document_[found].kind != JsonKind::object) {
      if (!read_value(document_, document_[found], Range{}, shadow.kind)) not_expected(found, key, expected);
      return;
    }
    shadow.kind = Shadow::map;
    read_object(found, path_of(key), [&](SceneReader& keys) { declare(shadow.map, keys); });
  }
  /// `short_form`: a key that says the same, if there is one, of which not both may be there. What is multiplied, if
  /// that is not null, is 1 beside a texture, unless it is said.
  void map(std::string_view key, MapText& text, std::string_view, std::string_view short_form, Double3* multiplied);

  /// Looks ahead: other keys may be left out where the materials are those of a file.
  void expect_material(std::string_view key, ObjectText& text) const;

  /// declare(text, keys) has the keys of an object that stands there.
  template <class Declare>
  void material(std::string_view key, ObjectText& text, std::string_view, Declare&& declare) {
    const Presence presence = text.material_from == MaterialFrom::file ? defaulted : required;
    const JsonIndex found = claim(key, presence, std::string(expected_material));
    if (found && text.material_from == MaterialFrom::scene)
      read_material(found, path_of(key), [&](SceneReader& keys) { declare(text, keys); });
  }

  template <class Declare>
  void materials(std::string_view key, ObjectText& text, std::string_view, Declare&& declare) {
    const std::string expected = "an object: materials by their names";
    const JsonIndex found = claim(key, defaulted, expected);
    if (!found) return;
    if (document_[found].kind != JsonKind::object) return not_expected(found, key, expected);
    if (document_[found].children > limit::materials.value) return not_expected(found, key, at_most(limit::materials));
    for (JsonIndex i = document_[found].first_child; i; i = document_[i].next) {
      ObjectText& one = text.materials.emplace_back();
      one.fragment_function = text.fragment_function, one.fragment_shader = text.fragment_shader;
      one.material_from = text.material_from; // as long as the fragment function is asked for
      one.object.material.name = document_[i].key;
      one.material_place = {one.object.material.name, document_[i].key_begin,
                            path_of(key) + '/' + shown_part(document_[i].key)};
      if (!is_from_file(i))
        read_material(i, one.material_place.json_path, [&](SceneReader& keys) { declare(one, keys); });
      one.material_from = is_from_file(i) ? MaterialFrom::file : MaterialFrom::scene;
    }
  }

  template <class M>
  void parameters(M& function, Use use) {
    M::fields(
        function, [&]<class Value>(std::string_view key, Value& value, const Range& range, std::string_view meaning) {
          if (use == Use::other && is_known(key)) return; // a parameter of the same name has been read
          (*this)(key, value, range, meaning, use == Use::own && is_required<Value>(range) ? required : defaulted);
        });
  }

  void parameters(UserFunction& function, Use use);

  // Judged only where every key is sound by itself.
  void check(Camera& camera, SceneView& view);
  void check(ObjectText& text);
  template <class Light>
  void check_light(const Light& light) {
    Light::fields(light, [&](std::string_view key, const auto& value, const Range& range, std::string_view) {
      if constexpr (std::is_same_v<decltype(value), const Double3&>) check_direction(key, value, range);
    });
  }

  /// Whether the key was called.
  bool is_known(std::string_view key) const;

  /// Every key that was not called is a fault.
  void finish();

  // For readings of other files' keys.

  /// The value of a key, which is from now on known; 0 if it is not there, or there twice. Missing and double keys are
  /// faults.
  JsonIndex claim(std::string_view key, Presence presence, const std::string& expected);
  void not_expected(JsonIndex found, std::string_view key, const std::string& expected);
  void not_expected_at(JsonIndex found, std::string path, const std::string& expected);
  std::string path_of(std::string_view key) const;
  const JsonDocument& document() const { return document_; }
  JsonIndex object_node() const { return object_; }
  const std::string& path() const { return path_; }

private:
  static constexpr std::string_view expected_material = "an object, or \"from_file\"";
  bool is_from_file(JsonIndex node) const;
  /// A part of a JSON pointer for a message: cut where it is long.
  static std::string shown_part(std::string_view key);

  template <class Declare>
  void read_material(JsonIndex node, std::string path, Declare&& declare) {
    if (document_[node].kind != JsonKind::object)
      return not_expected_at(node, std::move(path), std::string(expected_material));
    read_object(node, std::move(path), declare);
  }

  template <class Declare>
  void read_object(JsonIndex node, std::string path, Declare&& declare) {
    if (document_[node].kind != JsonKind::object) return not_expected_at(node, std::move(path), "an object");
    SceneReader inner(document_, node, std::move(path), faults_);
    declare(inner);
    inner.finish();
  }

  /// As claim(), without a fault: 0 if it is not there.
  JsonIndex find(std::string_view key) const;

  /// Of a camera that stands where its fit says; hands over to it what the camera says otherwise.
  void check_fit(const Camera& camera, CameraFit& fit);
  void check_direction(std::string_view key, const Double3& value, const Range& range);

  void missing(std::string_view key, const std::string& expected);
  /// A fault of the value of a key that is there; of its object, if it is not.
  void fault(std::string_view key, const std::string& found, const std::string& expected);

  const JsonDocument& document_;
  JsonIndex object_;
  std::string path_;
  FaultList& faults_;
  std::vector<std::string_view> known_;
  bool sound_ = true; // no key of this object was missing or wrong so far
};

} // namespace refraster
