#pragma once
// How the page looks beside io/html/base.css; its charts: io/html/chart_style.h.

namespace refraster::bench {

inline constexpr const char* page_style = R"(
:root { --precision0: #1566b0; --precision1: #d0590b; --precision2: #14866b; --precision3: #8c4aa8; }
@media (prefers-color-scheme: dark) {
  :root { --precision0: #62aef0; --precision1: #f4934f; --precision2: #4cc9a4; --precision3: #c58fe0; } }
main { max-width: 900px; margin: 0 auto; padding: 28px 20px 60px; }
svg { display: block; max-width: 100%; height: auto; } .pair { display: flex; flex-wrap: wrap; gap: 8px; }
.facts td { white-space: normal; }
.facts td:first-child { color: var(--soft); white-space: nowrap; vertical-align: top; }
)";

} // namespace refraster::bench
