#include "brdf/page/charts.h"

namespace refraster {

const std::string_view brdf_chart_style = R"(
.panel { fill: none; stroke: #c3c8cd; stroke: var(--rule, #c3c8cd); }
text.title { font-weight: 600; fill: #1d2126; fill: var(--ink, #1d2126); } text.tick { font-size: 10.5px; }
text.note { font-size: 11px; font-style: italic; }
.curve { stroke-linejoin: round; stroke-linecap: round; } .curve.second { stroke-dasharray: 5 4; }
.series0 { stroke: #1566b0; stroke: var(--series0, #1566b0); }
.series1 { stroke: #c2510a; stroke: var(--series1, #c2510a); }
.series2 { stroke: #14866b; stroke: var(--series2, #14866b); }
.series3 { stroke: #8c4aa8; stroke: var(--series3, #8c4aa8); }
.red { stroke: #c62f21; stroke: var(--red, #c62f21); } .green { stroke: #1d8040; stroke: var(--green, #1d8040); }
.blue { stroke: #2460c4; stroke: var(--blue, #2460c4); }
.lobe { fill-opacity: .09; stroke-width: 2; stroke-linejoin: round; }
.lobe.series0 { fill: #1566b0; } .lobe.series1 { fill: #c2510a; }
.lobe.series2 { fill: #14866b; } .lobe.series3 { fill: #8c4aa8; }
.lobe.second { fill: none; stroke-dasharray: 5 4; } .ray { stroke-width: 1.5; } .ring { fill: none; }
.sample.second { stroke-dasharray: 5 4; } .sample { stroke: #1d2126; stroke: var(--ink, #1d2126); stroke-width: 2; fill: none; }
)";

const std::vector<BrdfChart> brdf_charts = {
    {"slices", "Slices",
     "Every pair of directions of a surface without a grain has three angles: θh from the normal to the half vector, "
     "θd "
     "from that to the light, φd around it. Each image is a slice of one φd. The highlight is at its left edge, light "
     "from behind the eye at its bottom, grazing light at its top.",
     slices_chart},
    {"profile", "The highlight", "Luminance over θh: how wide the highlight is, and what is left far from it.",
     profile_chart},
    {"lobes", "Lobes",
     "Luminance in the plane of incidence, for light from the left at several angles, shown by the short lines at the "
     "rim. "
     "The distance from the centre is a logarithm.",
     lobes_chart},
    {"albedo", "Albedo",
     "How much of the light from one direction is reflected, by colour. No surface has more than 1.", albedo_chart},
};

void draw_pair_legend(Svg& svg, double x, double y, const ShownBrdfs& shown) {
  svg.line(x, y, x + 26, y, "sample");
  svg.text(x + 32, y + 4, Anchor::start, short_label(shown.a));
  y += 18;
  if (shown.b == nullptr) return;
  svg.line(x, y, x + 26, y, "sample second");
  svg.text(x + 32, y + 4, Anchor::start, short_label(*shown.b));
}

std::string short_label(const Brdf& brdf) {
  constexpr std::size_t longest = 28;
  std::string name = brdf.label();
  if (brdf.table()) name = name.substr(name.rfind('/') + 1);
  if (name.size() > longest) name = name.substr(0, longest - 1) + "…";
  return name;
}

} // namespace refraster
