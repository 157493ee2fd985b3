#pragma once
// How the page looks.

namespace refraster::bench {

inline constexpr const char* page_style = R"(
:root { color-scheme: light dark; --paper: #fdfdfc; --ink: #1d2126; --soft: #5d6670; --rule: #d9dcdf; --grid: #e7e9eb;
  --rung0: #1566b0; --rung1: #d0590b; --rung2: #14866b; --rung3: #8c4aa8; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #16191d; --ink: #e6e8ea; --soft: #9aa4ae; --rule: #363c43; --grid: #262b31;
    --rung0: #62aef0; --rung1: #f4934f; --rung2: #4cc9a4; --rung3: #c58fe0; } }
body { margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.5 system-ui, sans-serif; }
main { max-width: 900px; margin: 0 auto; padding: 28px 20px 60px; }
h1 { font-size: 26px; margin: 0 0 4px; } h2 { font-size: 19px; margin: 40px 0 6px; } h3 { font-size: 15px; margin: 22px 0 4px; }
p { margin: 4px 0 10px; max-width: 46em; } .soft, .soft code { color: var(--soft); }
code { font: 13px/1.4 ui-monospace, monospace; overflow-wrap: anywhere; }
svg { display: block; max-width: 100%; height: auto; } .pair { display: flex; flex-wrap: wrap; gap: 8px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 13.5px; margin: 8px 0; font-variant-numeric: tabular-nums; }
th, td { padding: 3px 12px 3px 0; text-align: right; white-space: nowrap; }
th { color: var(--soft); font-weight: 600; border-bottom: 1px solid var(--rule); vertical-align: bottom; }
th.left, td.left { text-align: left; } tr.first td { border-top: 1px solid var(--rule); } .facts td { white-space: normal; }
.facts td:first-child { color: var(--soft); white-space: nowrap; vertical-align: top; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 16px; font-size: 13px; color: var(--soft); margin: 6px 0; }
.legend span::before { content: ""; display: inline-block; width: 11px; height: 11px; margin-right: 6px; border-radius: 2px;
  background: var(--mark); vertical-align: -1px; }
.legend.dots span::before { border-radius: 50%; }
svg text { font: 12px system-ui, sans-serif; fill: var(--soft); } svg text.name { fill: var(--ink); }
svg text.strong { fill: var(--ink); font-weight: 600; } svg text.small { font-size: 11px; fill: var(--ink); }
.grid { stroke: var(--grid); } .one { stroke: var(--soft); stroke-width: 1.5; }
.joined { fill: none; stroke: var(--soft); stroke-width: 1; stroke-dasharray: 3 4; opacity: .6; }
.reference { stroke: var(--soft); stroke-dasharray: 6 5; opacity: .7; }
circle { fill: var(--colour); stroke: var(--paper); stroke-width: 1; }
.curve { fill: none; stroke: var(--colour); stroke-width: 2; } .dashed.curve { stroke-dasharray: 6 4; }
.range { stroke: var(--colour); stroke-width: 4; opacity: .35; }
.rung0 { --colour: var(--rung0); --mark: var(--rung0); } .rung1 { --colour: var(--rung1); --mark: var(--rung1); }
.rung2 { --colour: var(--rung2); --mark: var(--rung2); } .rung3 { --colour: var(--rung3); --mark: var(--rung3); }
.part0 { fill: #94a7ba; --mark: #94a7ba; } .part1 { fill: #64809c; --mark: #64809c; } .part2 { fill: #3f9c93; --mark: #3f9c93; }
.part3 { fill: #9cb76b; --mark: #9cb76b; } .part4 { fill: #e5b54b; --mark: #e5b54b; } .part5 { fill: #d9683c; --mark: #d9683c; }
.part6 { fill: #a670a5; --mark: #a670a5; } .part7 { fill: #a9adb1; --mark: #a9adb1; }
)";

} // namespace refraster::bench
