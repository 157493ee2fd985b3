#pragma once
// All that decides what an image's files hold, as words: by them parts are told to be of one image.

#include <refraster/notes.h>

#include "io/json/json.h"
#include "io/json/json_writer.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

/// Names and values, in an order that is the same in every run of one version.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// The value of a name; nothing where it has none.
std::optional<std::string_view> setting(const Settings& settings, std::string_view name);

/// What `found`, of the file at `path`, has otherwise than `expected`, of the file at `other`; nothing if all is the
/// same.
std::optional<InputFault> settings_fault(const std::string& path, const Settings& found, const std::string& other,
                                         const Settings& expected);

/// The sha256 of all of them.
std::string settings_digest(const Settings& settings);

/// The member of that name: an object of texts.
void write_settings(JsonWriter& json, std::string_view name, const Settings& settings);
/// The same, read; nothing unless that is what it is.
std::optional<Settings> settings_from(const JsonDocument& document, JsonIndex object);

} // namespace refraster
