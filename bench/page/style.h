#pragma once
// How the page looks; its charts: chart_style.h.

namespace refraster::bench {

inline constexpr const char* page_style = R"(
:root { color-scheme: light dark; --paper: #fdfdfc; --ink: #1d2126; --soft: #5d6670; --rule: #d9dcdf; --grid: #e7e9eb;
  --precision0: #1566b0; --precision1: #d0590b; --precision2: #14866b; --precision3: #8c4aa8; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #16191d; --ink: #e6e8ea; --soft: #9aa4ae; --rule: #363c43; --grid: #262b31;
    --precision0: #62aef0; --precision1: #f4934f; --precision2: #4cc9a4; --precision3: #c58fe0; } }
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
)";

} // namespace refraster::bench
