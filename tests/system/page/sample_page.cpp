// Writes the page of tests/support/page for a scene, to look at and to drive: sample_page SCENE WIDTHxHEIGHT
// rgb8|values PAGE.html. Prints what the viewer must show of some pixels: x, y, three levels of either image, class and
// object.

#include <refraster/files.h>

#include "app/arguments.h"
#include "io/file/atomic_file.h"
#include "tests/support/page/sample_page.h"

#include <cstdio>
#include <string_view>

namespace {

using namespace refraster;

double level(const PageImage& image, int x, int y, int channel) {
  if (!image.rgb8.empty()) return image.rgb8.at(x, y)[channel];
  return 255 * static_cast<double>(image.values.at(x, y)[channel]);
}

void print_pixel(const ReportPage& page, int x, int y) {
  std::printf("%d %d", x, y);
  for (const PageImage* const image : {&page.reference, &page.actual})
    for (int c = 0; c < 3; ++c) std::printf(" %.6g", level(*image, x, y, c));
  const std::uint32_t object = *page.objects.at(x, y);
  std::printf(" %s %s\n", page.classes[*page.class_map.at(x, y)].name.c_str(),
              object == 0 ? "background" : page.object_names[object - 1].c_str());
}

} // namespace

int main(int count, char** words) {
  const auto size = count == 5 ? size_from(words[2]) : std::nullopt;
  if (!size) {
    std::fprintf(stderr, "usage: sample_page SCENE WIDTHxHEIGHT rgb8|values PAGE.html\n");
    return 2;
  }
  const auto images = std::string_view(words[3]) == "values" ? test::SampleImages::values : test::SampleImages::rgb8;
  const ReportPage page = test::sample_page(read_scene(words[1]), size->width, size->height, images);
  write_file(words[4], report_html(page));
  print_pixel(page, 0, 0);
  print_pixel(page, size->width - 1, size->height - 1);
  print_pixel(page, size->width / 2, size->height / 2);
  if (!page.clusters.empty()) print_pixel(page, page.clusters[0].where.worst_x, page.clusters[0].where.worst_y);
  if (!page.notes.empty()) print_pixel(page, page.notes[0].x, page.notes[0].y);
}
