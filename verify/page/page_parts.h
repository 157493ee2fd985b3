#pragma once
// The parts of a page: what its script reads, and what is there without a script.

#include "verify/page/report_page.h"

#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// The files of verify/page that become part of each page.
struct PageText {
  std::string_view html, style, script;
};
extern const PageText page_text;

/// One JSON document, fit to stand in a script element: sizes, names, classes, clusters.
std::string page_data(const ReportPage& page);

/// The images, lists of numbers and notes, packed, each a script element of text that docs/report-page.md describes:
/// id, size, type.
std::string page_planes(const ReportPage& page);

/// The headline with what stands by it, and the sections below the viewer. HTML.
std::string page_headline(const ReportPage& page);
std::string page_sections(const ReportPage& page);

/// Those that it says, or Y of a single one, R G B of three, and else numbers from 1.
std::vector<std::string> channel_names(const PageImage& image);

/// "#0a8cff".
std::string css_colour(const Rgb8& colour);

} // namespace refraster
