// Models as a user writes them.

#include "brdf/model.h"

#include "io/file/nearest.h"
#include "io/file/number_text.h"
#include "io/file/text.h"
#include "io/scene/value_kinds.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>

namespace refraster {
namespace {

/// Another name of a model, by which people know it as well.
constexpr std::pair<std::string_view, std::string_view> other_names[] = {{"diffuse", Lambert::name}};

bool same_name(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, {}, [](char c) { return c == '-' ? '_' : c; }, [](char c) { return c == '-' ? '_' : c; });
}

std::optional<BrdfModel> model_named(std::string_view name) {
  for (const auto& [other, known] : other_names)
    if (same_name(name, other)) name = known;
  std::optional<BrdfModel> found;
  for_each_model([&](const auto& model) {
    if (same_name(name, model.name)) found = model;
  });
  for (const BrdfPreset& preset : brdf_presets())
    if (!found && same_name(name, preset.name)) std::visit([&](const auto& formula) { found = formula; }, preset.brdf);
  return found;
}

/// "kd=.5,.4,.3" of "kd=.5,.4,.3,ks=1": up to the comma before the next key. `text` goes on behind it.
std::string_view next_setting(std::string_view& text) {
  std::size_t end = text.size();
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
    const std::size_t next = std::min(text.find(',', comma + 1), text.size());
    if (text.substr(comma, next - comma).find('=') == std::string_view::npos) continue;
    end = comma;
    break;
  }
  const std::string_view setting = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return setting;
}

template <NamedEnum Enum>
bool read_parameter(Enum& value, std::string_view text, const Range&) {
  const std::optional<Enum> named = value_named<Enum>(text);
  if (named) value = *named;
  return named.has_value();
}

template <NamedEnum Enum>
std::string expected_parameter(const Enum& value, const Range& range) {
  return expected_value(value, range);
}

/// Of "KEY=VALUE".
std::optional<ModelFault> set_parameter(BrdfModel& model, std::string_view setting) {
  const std::size_t equals = setting.find('=');
  const std::string_view key = setting.substr(0, equals);
  const std::string place(model_name(model));
  if (equals == std::string_view::npos) return ModelFault{place, in_quotes(setting), "KEY=VALUE"};
  const std::string_view text = setting.substr(equals + 1);
  std::vector<std::string_view> keys;
  std::optional<ModelFault> fault;
  bool known = false;
  std::visit(
      [&]<class Block>(Block& block) {
        Block::fields(block, [&](std::string_view name, auto& value, const Range& range, std::string_view) {
          keys.push_back(name);
          if (name != key) return;
          known = true;
          if (!read_parameter(value, text, range))
            fault = ModelFault{place + ":" + std::string(name), in_quotes(text), expected_parameter(value, range)};
        });
      },
      model);
  if (!known) return ModelFault{place, in_quotes(key), one_of(keys, key)};
  return fault;
}

/// Up to a '+' that a name follows: "1e+5" has one that none does.
std::string_view next_lobe(std::string_view& text) {
  std::size_t end = text.find('+');
  while (end != std::string_view::npos &&
         (end + 1 == text.size() || std::isalpha(static_cast<unsigned char>(text[end + 1])) == 0))
    end = text.find('+', end + 1);
  const std::string_view lobe = text.substr(0, end);
  text.remove_prefix(std::min(lobe.size() + 1, text.size()));
  return lobe;
}

std::optional<ModelFault> read_lobe(std::string_view text, std::vector<BrdfModel>& lobes) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  std::optional<BrdfModel> model = model_named(name);
  if (!model) return ModelFault{"", in_quotes(name), one_of(model_names(), name)};
  std::string_view settings = colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
  while (!settings.empty())
    if (std::optional<ModelFault> fault = set_parameter(*model, next_setting(settings))) return fault;
  lobes.push_back(*model);
  return std::nullopt;
}

/// The shortest that reads back as the same number.
std::string shortest_text(double number) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

template <NamedEnum Enum>
std::string parameter_text(Enum value) {
  return std::string(name_of(value));
}

} // namespace

bool read_parameter(double& value, std::string_view text, const Range& range) {
  double number = 0;
  if (read_number(text, number) != NumberText::good || !range.contains(number)) return false;
  value = number;
  return true;
}

bool read_parameter(Double3& value, std::string_view text, const Range& range) {
  std::array<double, 3> numbers{};
  std::size_t count = 0;
  for (std::size_t start = 0; start <= text.size(); ++count) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    if (count == 3 || !read_parameter(numbers[count], text.substr(start, end - start), range)) return false;
    start = end + 1;
  }
  if (count == 2) return false;
  value = count == 1 ? Double3(numbers[0]) : Double3(numbers[0], numbers[1], numbers[2]);
  return true;
}

std::string expected_parameter(const double& value, const Range& range) {
  return expected_value(value, range);
}

std::string expected_parameter(const Double3&, const Range& range) {
  return expected_value(double{}, range) + ", or three, with commas between them";
}

std::string parameter_text(double value) {
  return shortest_text(value);
}

std::string parameter_text(const Double3& value) {
  if (value.x == value.y && value.y == value.z) return shortest_text(value.x);
  return shortest_text(value.x) + "," + shortest_text(value.y) + "," + shortest_text(value.z);
}

ReadModels read_models(std::string_view text) {
  ReadModels result;
  do {
    if (std::optional<ModelFault> fault = read_lobe(next_lobe(text), result.lobes)) {
      result.faults.push_back(*fault);
      return result;
    }
  } while (!text.empty());
  return result;
}

bool means_model(std::string_view text) {
  std::string_view rest = text;
  const std::string_view name = next_lobe(rest);
  if (model_named(name.substr(0, name.find(':')))) return true;
  return name.find(':') != std::string_view::npos &&
         name.substr(0, name.find(':')).find_first_of("/.") == std::string_view::npos;
}

std::vector<std::string_view> model_names() {
  std::vector<std::string_view> names;
  for_each_model([&](const auto& model) { names.push_back(model.name); });
  for (const BrdfPreset& preset : brdf_presets())
    if (std::find(names.begin(), names.end(), preset.name) == names.end()) names.push_back(preset.name);
  return names;
}

std::string model_text(const BrdfModel& model) {
  std::string text(model_name(model));
  std::visit(
      [&]<class Block>(const Block& block) {
        char before = ':';
        Block::fields(block,
                      [&]<class Value>(std::string_view name, const Value& value, const Range&, std::string_view) {
                        if (!is_of_f(block, name)) return;
                        if constexpr (NamedEnum<Value>)
                          if (value == EnumNames<Value>::names[0].first) return; // as by default
                        text += before + std::string(name) + "=" + parameter_text(value);
                        before = ',';
                      });
      },
      model);
  return text;
}

std::string model_text(const std::vector<BrdfModel>& lobes) {
  std::string text;
  for (const BrdfModel& lobe : lobes) text += (text.empty() ? "" : "+") + model_text(lobe);
  return text;
}

} // namespace refraster
