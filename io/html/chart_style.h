#pragma once
// How a chart looks.

namespace refraster {

/// Each colour is said twice: for a program that knows no variables of CSS, as many that read SVG do, the second is a
/// fault and the first stands. In a page the variables are the page's (style.h), in a file of its own there are none.
inline constexpr const char* chart_style = R"(
.paper { fill: #fdfdfc; fill: var(--paper, #fdfdfc); }
text { font: 12px system-ui, sans-serif; fill: #5d6670; fill: var(--soft, #5d6670); }
text.name, text.strong, text.small { fill: #1d2126; fill: var(--ink, #1d2126); }
text.strong { font-weight: 600; } text.small { font-size: 11px; }
.grid { stroke: #e7e9eb; stroke: var(--grid, #e7e9eb); }
.one, .joined, .reference { stroke: #5d6670; stroke: var(--soft, #5d6670); }
.one { stroke-width: 1.5; } .reference { stroke-dasharray: 6 5; opacity: .7; }
.joined { fill: none; stroke-width: 1; stroke-dasharray: 3 4; opacity: .6; }
circle { stroke: #fdfdfc; stroke: var(--paper, #fdfdfc); stroke-width: 1; }
.curve { fill: none; stroke-width: 2; } .dashed { stroke-dasharray: 6 4; } .range { stroke-width: 4; opacity: .35; }
circle.precision0, .mark.precision0 { fill: #1566b0; fill: var(--precision0, #1566b0); }
circle.precision1, .mark.precision1 { fill: #d0590b; fill: var(--precision1, #d0590b); }
circle.precision2, .mark.precision2 { fill: #14866b; fill: var(--precision2, #14866b); }
circle.precision3, .mark.precision3 { fill: #8c4aa8; fill: var(--precision3, #8c4aa8); }
.curve.precision0, .range.precision0 { stroke: #1566b0; stroke: var(--precision0, #1566b0); }
.curve.precision1, .range.precision1 { stroke: #d0590b; stroke: var(--precision1, #d0590b); }
.curve.precision2, .range.precision2 { stroke: #14866b; stroke: var(--precision2, #14866b); }
.curve.precision3, .range.precision3 { stroke: #8c4aa8; stroke: var(--precision3, #8c4aa8); }
.part0 { fill: #94a7ba; } .part1 { fill: #64809c; } .part2 { fill: #3f9c93; } .part3 { fill: #9cb76b; }
.part4 { fill: #e5b54b; } .part5 { fill: #d9683c; } .part6 { fill: #a670a5; } .part7 { fill: #a9adb1; }
)";

} // namespace refraster
