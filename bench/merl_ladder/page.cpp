#include "bench/merl_ladder/page.h"

#include <cstdarg>
#include <cstdio>
#include <stdexcept>

namespace refraster::ladder {

namespace {

[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...) {
  char buffer[512];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

/// Two digits: 0.15, 3.4e-5, 0.
std::string number(double x) {
  std::string digits = text(x != 0 && x < 1e-2 ? "%.1e" : "%.2g", x);
  if (const std::size_t at = digits.find("e-0"); at != std::string::npos) digits.erase(at + 2, 1);
  return digits;
}

std::string cell(const Errors& errors) {
  return number(errors.mean) + " / " + number(errors.mostly) + " / " + number(errors.max);
}

std::string name(const Way& way) {
  std::string row = "| `";
  row.append(way.lookup_name)
      .append("` | ")
      .append(way.reader.precision)
      .append(" | ")
      .append(way.format().name)
      .append(" | ");
  return row;
}

std::string table(const Material& material) {
  std::string rows = "**" + material.name + "**\n\n";
  rows += "| look-up | precision | table | S: from the formula | S: from trilinear in double | U: from the formula | "
          "U: from "
          "trilinear in double |\n|---|---|---|---|---|---|---|\n";
  for (const Step& step : material.steps)
    rows += name(step.way) + cell(step.specular.from_material) + " | " + cell(step.specular.from_trilinear) + " | " +
            cell(step.uniform.from_material) + " | " + cell(step.uniform.from_trilinear) + " |\n";
  return rows + "\n";
}

} // namespace

std::string markdown(const std::vector<Material>& materials, const std::vector<Cost>& costs, int pairs) {
  std::string all =
      text("Errors: mean / 99 %% / max of |Δf| / (f + ε), the worst channel of each of %d pairs.\n\n", pairs);
  for (const Material& material : materials) all += table(material);
  all += "Cost: nanoseconds of one look-up with the angles before it, one thread.\n\n"
         "| look-up | precision | table | MiB | pixels of a sphere | random pairs |\n|---|---|---|---|---|---|\n";
  for (const Cost& cost : costs)
    all += name(cost.way) + text("%.1f | %.1f | %.1f |\n", static_cast<double>(cost.way.format().bytes) / 0x1p20,
                                 cost.sphere_ns, cost.random_ns);
  return all;
}

std::string updated_page(std::string page, const std::string& ladder) {
  const std::string begin = "<!-- refraster_merl_ladder -->\n", end = "<!-- end -->\n";
  const std::size_t from = page.find(begin);
  const std::size_t to = from == std::string::npos ? from : page.find(end, from);
  if (to == std::string::npos) throw std::runtime_error("the page has no place for the ladder");
  return page.replace(from + begin.size(), to - from - begin.size(), ladder);
}

} // namespace refraster::ladder
