#include "verify/device/profile_markdown.h"

#include "verify/device/read_profile.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace refraster {
namespace {

/// "0.35"; "2^-24" for a power of two that is small.
std::string value_text(double x) {
  int exponent = 0;
  std::array<char, 32> text{};
  if (x > 0 && x < 0.01 && std::frexp(x, &exponent) == 0.5)
    std::snprintf(text.data(), text.size(), "2^%d", exponent - 1);
  else std::snprintf(text.data(), text.size(), "%.4g", x);
  return text.data();
}
template <NamedEnum Enum>
std::string value_text(Enum value) {
  return std::string(name_of(value));
}

using Texts = std::map<std::string, std::string>;

Texts value_texts(const DeviceProfile& profile) {
  Texts texts;
  for_each_member(profile, [&](const std::string& place, const auto& value, const Range&, Wider, std::string_view) {
    texts[place] = value_text(value);
  });
  return texts;
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text.append(" ").append(cell).append(" |");
  return text + "\n";
}

} // namespace

std::string device_profiles_markdown() {
  std::vector<DeviceProfile> profiles;
  for (const std::string_view name : device_profile_names()) profiles.push_back(device_profile(std::string(name)));
  const DeviceProfile& widest = profiles.front();

  std::string text = row({"profile", "version", "what it describes"}) + "|---|---|---|\n";
  for (const DeviceProfile& profile : profiles)
    text += row({"`" + profile.name + "`", std::to_string(profile.version), profile.meaning});

  std::vector<std::string> head = {"member", "what it bounds"};
  for (const DeviceProfile& profile : profiles) head.push_back("`" + profile.name + "`");
  text += "\n" + row(head) + "|";
  for (std::size_t i = 0; i < head.size(); ++i) text += "---|";
  text += "\n";
  std::vector<Texts> values;
  for (const DeviceProfile& profile : profiles) values.push_back(value_texts(profile));
  for_each_member(widest, [&](const std::string& place, const auto&, const Range&, Wider, std::string_view meaning) {
    std::vector<std::string> cells = {"`" + place + "`", std::string(meaning)};
    for (const Texts& of_one : values) cells.push_back(of_one.at(place));
    text += row(cells);
  });

  for (std::size_t i = 0; i < profiles.size(); ++i) {
    text += "\n### " + profiles[i].name + "\n" + row({"member", "value", "source"}) + "|---|---|---|\n";
    for_each_member(widest, [&](const std::string& place, const auto&, const Range&, Wider, std::string_view) {
      const std::map<std::string, std::string>& sources = profiles[i].sources;
      const auto source = sources.find(place), before = widest.sources.find(place);
      if (source == sources.end()) return;
      if (i > 0 && before != widest.sources.end() && before->second == source->second) return; // of gl-generic
      text += row({"`" + place + "`", values[i].at(place), source->second});
    });
  }
  return text;
}

} // namespace refraster
