// The reading of scene_keys.h that makes the documentation's tables.

#include "io/scene/scene_markdown.h"

#include <refraster/files.h>

#include "io/scene/value_kinds.h"

#include <array>
#include <charconv>

namespace refraster {
namespace {

std::string text_of(double x) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}
std::string text_of(int x) {
  return std::to_string(x);
}
std::string text_of(const Double3& v) {
  return '"' + text_of(v.x) + ' ' + text_of(v.y) + ' ' + text_of(v.z) + '"';
}
std::string text_of(const Double2& v) {
  return '"' + text_of(v.x) + ' ' + text_of(v.y) + '"';
}
std::string text_of(const std::string& text) {
  return '"' + text + '"';
}
std::string text_of(const PathText&) {
  return "nothing";
}
std::string text_of(const FragmentFunctionName&) {
  return "nothing";
}
std::string text_of(const SampleCount& samples) {
  return text_of(samples.count);
}
template <NamedEnum Enum>
std::string text_of(Enum value) {
  return json_word(name_of(value));
}

/// One table for the keys of one object; tables of what lies inside it follow.
class MarkdownKeys {
public:
  explicit MarkdownKeys(std::string place) : place_(std::move(place)) {}

  template <class Value>
  void operator()(std::string_view key, Value&& value, const Range& range, std::string_view meaning,
                  Presence presence) {
    const bool needed = presence.need == Presence::Need::required;
    row(key, expected_value(value, range),
        needed                       ? ""
        : presence.otherwise.empty() ? code(text_of(value))
                                     : std::string(presence.otherwise),
        meaning);
  }

  template <class Declare>
  void object(std::string_view key, Presence presence, std::string_view meaning, Declare&& declare) {
    row(key, "an object", presence.otherwise, meaning);
    inside(place_ + '/' + std::string(key), declare);
  }

  template <class Content, class Declare>
  void optional_object(std::string_view key, const std::optional<Content>&, std::string_view meaning,
                       Declare&& declare) {
    row(key, "an object", "nothing", meaning);
    Content content;
    inside(place_ + '/' + std::string(key), [&](MarkdownKeys& keys) { declare(content, keys); });
  }

  template <class Item, class Declare>
  void list(std::string_view key, Presence presence, const Limit& most, std::string_view meaning, std::vector<Item>&,
            Declare&& declare) {
    row(key, "an array of objects, " + at_most(most), presence.otherwise, meaning);
    Item item;
    inside(place_ + '/' + std::string(key) + "/0", [&](MarkdownKeys& keys) { declare(item, keys); });
  }

  void shape(std::string_view key, std::optional<Shape>&, std::string_view meaning) {
    row(key, "an object with one key", "`obj_file_path`", meaning);
    inside(place_ + '/' + std::string(key),
           [](MarkdownKeys& keys) { keys.shapes(static_cast<const Shape*>(nullptr)); });
  }

  void normals(std::string_view key, MeshNormals& normals, std::string_view meaning) {
    row(key, expected_normals(), code(text_of(normals.from)), meaning);
    inside(place_ + '/' + std::string(key), [&](MarkdownKeys& keys) { crease_keys(normals, keys); });
  }

  template <class Declare>
  void shadow(std::string_view key, CastShadow& shadow, std::string_view meaning, Declare&& declare) {
    row(key, expected_shadow(), code(text_of(shadow.kind)), meaning);
    inside(place_ + '/' + std::string(key), [&](MarkdownKeys& keys) { declare(shadow.map, keys); });
  }

  /// What an object may have there is told once, where there is a short form.
  void map(std::string_view key, MapText& text, std::string_view meaning, std::string_view short_form, const Double3*) {
    const auto is_this = [&](const TextureSlot& slot) { return slot.key == key; };
    const Double3 blank = std::find_if(texture_slots.begin(), texture_slots.end(), is_this)->blank;
    row(key, expected_map(), blank == Double3(1) ? "white" : "a map that turns no normal", meaning);
    if (!short_form.empty())
      inside(place_ + '/' + std::string(key) + ", and every other texture",
             [&](MarkdownKeys& keys) { map_keys(text, keys); });
    if (text.reading.channel)
      inside(place_ + '/' + std::string(key) + ", beside those",
             [&](MarkdownKeys& keys) { channel_keys(*text.reading.channel, keys); });
  }

  void expect_material(std::string_view, const ObjectText&) const {}

  template <class Declare>
  void material(std::string_view key, ObjectText& text, std::string_view meaning, Declare&& declare) {
    row(key, "an object or \"from_file\"", "`\"from_file\"` beside `obj_file_path`", meaning);
    inside(place_ + '/' + std::string(key), [&](MarkdownKeys& keys) { declare(text, keys); });
  }
  template <class Declare>
  void materials(std::string_view key, const ObjectText&, std::string_view meaning, Declare&&) {
    row(key, "an object", "nothing", meaning);
  }

  /// The keys of every fragment function, each in a table of its own.
  template <class M>
  void parameters(M& function, Use) {
    inside(place_ + " with `" + std::string(M::name) + '`', [&](MarkdownKeys& keys) {
      M::fields(function,
                [&]<class Value>(std::string_view key, Value& value, const Range& range, std::string_view meaning) {
                  keys(key, value, range, meaning, is_required<Value>(range) ? required : defaulted);
                });
    });
  }

  /// The page is about those of the library.
  void parameters(UserFunction&, Use) {}

  void check(const auto&...) const {}
  void check_light(const auto&) const {}

  std::string text() const {
    return "#### " + place_ + "\n\n| key | value | if left out | meaning |\n|---|---|---|---|\n" + rows_ + "\n" +
           tables_;
  }

private:
  static std::string code(const std::string& text) { return '`' + text + '`'; }

  void row(std::string_view key, std::string_view value, std::string_view otherwise, std::string_view meaning) {
    rows_.append("| `").append(key).append("` | ").append(value).append(" | ");
    rows_.append(otherwise.empty() ? "**must be there**" : otherwise).append(" | ").append(meaning).append(" |\n");
  }

  template <class Declare>
  void inside(std::string place, Declare&& declare) {
    MarkdownKeys inner(std::move(place));
    declare(inner);
    tables_ += inner.text();
  }

  template <class... S>
  void shapes(const std::variant<S...>*) {
    (shape_row<S>(), ...);
  }
  template <class S>
  void shape_row() {
    row(S::name, "an object, may be empty", "another shape", S::meaning);
    S shape;
    MarkdownKeys inner(place_ + '/' + std::string(S::name));
    S::fields(shape, inner);
    if (!inner.rows_.empty()) tables_ += inner.text();
  }

  std::string place_, rows_, tables_;
};

} // namespace

std::string scene_format_markdown() {
  Scene scene;
  SceneView view;
  std::vector<ObjectText> objects;
  MarkdownKeys top("/scene");
  scene_keys(scene, view, objects, {}, top);
  return top.text();
}

} // namespace refraster
