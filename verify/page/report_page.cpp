#include "verify/page/report_page.h"

#include "io/html/base_style.h"
#include "io/html/filled.h"
#include "io/html/markup.h"
#include "verify/page/page_parts.h"

#include <algorithm>
#include <stdexcept>

namespace refraster {
namespace {

void need(bool holds, const char* found) {
  if (!holds) throw std::invalid_argument(std::string("report_html: found ") + found);
}

void check(const ReportPage& page) {
  const int width = page.reference.width(), height = page.reference.height();
  need(width > 0 && height > 0 && page.reference.channels() > 0, "no reference");
  const auto fits = [&](const PageImage& image) {
    return image.width() == width && image.height() == height && image.channels() > 0 &&
           image.rgb8.empty() != image.values.empty() &&
           (image.names.empty() || image.names.size() == static_cast<std::size_t>(image.channels()));
  };
  const auto plane_fits = [&](const auto& plane) {
    return plane.empty() || (plane.width == width && plane.height == height && plane.channels == 1);
  };
  const auto within = [&](int x, int y) { return x >= 0 && y >= 0 && x < width && y < height; };
  need(fits(page.reference) && fits(page.actual), "images of different sizes");
  for (const PageHypothesis& one : page.hypotheses)
    need(one.image.empty() || fits(one.image), "an image of a hypothesis that has another size");
  need(plane_fits(page.class_map) && plane_fits(page.bound_width) && plane_fits(page.objects) &&
           plane_fits(page.triangles),
       "an image by pixel that has another size");
  need(page.classes.size() <= 256, "more than 256 classes");
  for (const std::uint8_t which : page.class_map.values) need(which < page.classes.size(), "a class beyond the list");
  for (const std::uint32_t which : page.objects.values)
    need(which <= page.object_names.size(), "an object beyond the list");
  for (const PageInterval& interval : page.allowed)
    need(within(interval.x, interval.y), "an interval beyond the image");
  for (const PageNote& note : page.notes) need(within(note.x, note.y), "a note beyond the image");
  for (const PageTable& table : page.tables)
    for (const std::vector<std::string>& row : table.rows)
      need(row.size() == table.columns.size(), "a row that does not fit its table");
}

} // namespace

std::string report_html(const ReportPage& page) {
  check(page);
  return filled(page_text.html, {{"title", escaped(page.title)},
                                 {"style", std::string(base_style) + std::string(page_text.style)},
                                 {"headline", page_headline(page)},
                                 {"sections", page_sections(page)},
                                 {"data", page_data(page)},
                                 {"planes", page_planes(page)},
                                 {"script", std::string(page_text.script)}});
}

} // namespace refraster
