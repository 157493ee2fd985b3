#include "verify/page/page_parts.h"

#include "io/file/text.h"
#include "io/html/markup.h"
#include "io/json/json_writer.h"
#include "verify/page/packed.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace refraster {
namespace {

void write_image_facts(JsonWriter& json, const std::string& plane, const PageImage& image) {
  json.object([&] {
    json.member("plane", plane);
    json.member("label", image.label);
    json.member("source", image.source);
    json.member("channels", channel_names(image));
  });
}

std::string hypothesis_plane(std::size_t i) {
  return "hypothesis-" + std::to_string(i);
}

void write_classes(JsonWriter& json, const ReportPage& page) {
  std::vector<std::uint64_t> counts(page.classes.size());
  for (const std::uint8_t which : page.class_map.values) ++counts[which];
  json.array("classes", [&] {
    for (std::size_t i = 0; i < page.classes.size(); ++i) {
      json.object([&] {
        json.member("name", page.classes[i].name);
        json.member("colour", css_colour(page.classes[i].colour));
        json.member("meaning", page.classes[i].meaning);
        json.member("pixels", counts[i]);
      });
    }
  });
}

/// A document of its own: there may be thousands of notes, and they are much alike.
std::string notes_json(const ReportPage& page) {
  JsonWriter json;
  json.array([&] {
    for (const PageNote& note : page.notes) {
      json.object([&] {
        json.member("x", note.x);
        json.member("y", note.y);
        json.array("attribution", [&] {
          for (const auto& part : note.attribution) {
            json.object([&] {
              json.member("cause", part.first);
              json.member("fraction", part.second);
            });
          }
        });
        json.member("text", note.text);
      });
    }
  });
  return json.text();
}

/// In a script element, `<` could end it; in JSON it stands within texts only.
std::string without_less_than(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') text += "\\u003c";
    else text += c;
  }
  return text;
}

/// A script element of text; base: the plane that is to be added to it.
void add_plane(std::string& planes, const std::string& id, std::string_view type, const std::array<int, 3>& size,
               const std::string& content, std::string_view base = {}) {
  planes += "<script type=\"text/plain\" id=\"plane-" + id + "\" data-type=\"" + std::string(type) +
            format("\" data-width=\"%d\" data-height=\"%d\" data-channels=\"%d\"", size[0], size[1], size[2]);
  if (!base.empty()) planes += " data-base=\"" + std::string(base) + "\"";
  planes += ">" + content + "</script>\n";
}

template <class Value>
void add_plane(std::string& planes, const std::string& id, std::string_view type, const Image<Value>& image) {
  if (!image.empty()) add_plane(planes, id, type, {image.width, image.height, image.channels}, packed(image));
}

bool same_layout(const PageImage& a, const PageImage& b) {
  return a.rgb8.empty() == b.rgb8.empty() && a.channels() == b.channels();
}

/// As it is or, where that can be, as what is to be added to another one: nearly the same image takes little so.
void add_image(std::string& planes, const std::string& id, const PageImage& image, const std::string& base_id,
               const PageImage& base) {
  if (image.empty()) return;
  const bool bytes = !image.rgb8.empty();
  std::string content = bytes ? packed(image.rgb8) : packed(image.values);
  std::string_view base_name;
  if (same_layout(image, base)) {
    std::string left = bytes ? packed_difference(image.rgb8, base.rgb8) : packed_difference(image.values, base.values);
    if (left.size() < content.size()) {
      content = std::move(left);
      base_name = base_id;
    }
  }
  add_plane(planes, id, bytes ? "u8" : "f32", {image.width(), image.height(), image.channels()}, content, base_name);
}

/// Rising by pixel, so that the viewer can search.
void add_intervals(std::string& planes, const ReportPage& page) {
  if (page.allowed.empty()) return;
  std::vector<std::size_t> order(page.allowed.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto index_of = [&](std::size_t i) {
    const PageInterval& interval = page.allowed[i];
    return static_cast<std::uint32_t>(interval.y) * static_cast<std::uint32_t>(page.reference.width()) +
           static_cast<std::uint32_t>(interval.x);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return index_of(i) < index_of(j); });
  const int count = static_cast<int>(order.size());
  Image<std::uint32_t> pixels(count, 1, 1);
  Image<float> ends(count, 1, 6);
  for (int i = 0; i < count; ++i) {
    const std::size_t from = order[static_cast<std::size_t>(i)];
    *pixels.at(i, 0) = index_of(from);
    std::copy(page.allowed[from].low.begin(), page.allowed[from].low.end(), ends.at(i, 0));
    std::copy(page.allowed[from].high.begin(), page.allowed[from].high.end(), ends.at(i, 0) + 3);
  }
  add_plane(planes, "allowed-pixels", "u32", pixels);
  add_plane(planes, "allowed-ends", "f32", ends);
}

} // namespace

std::vector<std::string> channel_names(const PageImage& image) {
  if (!image.names.empty()) return image.names;
  if (image.channels() == 1) return {"Y"};
  if (image.channels() == 3) return {"R", "G", "B"};
  std::vector<std::string> names;
  for (int c = 1; c <= image.channels(); ++c) names.push_back(std::to_string(c));
  return names;
}

std::string css_colour(const Rgb8& colour) {
  return format("#%02x%02x%02x", unsigned{colour[0]}, unsigned{colour[1]}, unsigned{colour[2]});
}

std::string page_data(const ReportPage& page) {
  JsonWriter json;
  json.object([&] {
    json.member("width", page.reference.width());
    json.member("height", page.reference.height());
    json.array("images", [&] {
      write_image_facts(json, "reference", page.reference);
      write_image_facts(json, "actual", page.actual);
      for (std::size_t i = 0; i < page.hypotheses.size(); ++i)
        if (!page.hypotheses[i].image.empty()) write_image_facts(json, hypothesis_plane(i), page.hypotheses[i].image);
    });
    write_classes(json, page);
    json.member("objects", page.object_names);
    json.array("clusters", [&] {
      for (const PageCluster& cluster : page.clusters)
        json.value(std::vector<int>{cluster.where.x, cluster.where.y, cluster.where.width, cluster.where.height,
                                    cluster.where.worst_x, cluster.where.worst_y});
    });
    json.array("ramp", [&] { // of widths
      for (int i = 0; i < 256; ++i) json.value(css_colour(heat_colour(i / 255.0)));
    });
    json.member("not_a_number", css_colour(incomparable_colour));
  });
  return without_less_than(json.text());
}

std::string page_planes(const ReportPage& page) {
  std::string planes;
  add_image(planes, "reference", page.reference, {}, {});
  add_image(planes, "actual", page.actual, "reference", page.reference);
  for (std::size_t i = 0; i < page.hypotheses.size(); ++i)
    add_image(planes, hypothesis_plane(i), page.hypotheses[i].image, "actual", page.actual);
  add_plane(planes, "classes", "u8", page.class_map);
  add_plane(planes, "bound", "f32", page.bound_width);
  add_plane(planes, "objects", "u32", page.objects);
  add_plane(planes, "triangles", "u32", page.triangles);
  add_intervals(planes, page);
  if (!page.notes.empty())
    planes += "<script type=\"text/plain\" id=\"plane-notes\">" + packed(notes_json(page)) + "</script>\n";
  return planes;
}

} // namespace refraster
