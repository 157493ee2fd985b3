#pragma once
// A result as JSON, and back.

#include "io/json/json.h"
#include "io/json/json_writer.h"
#include "suite/entry/result.h"

#include <optional>
#include <string>

namespace refraster::suite {

/// An object with the members of EntryResult::fields; without those of the journal alone, unless they are asked for.
void write_result(JsonWriter& json, const EntryResult& result, MemberOf up_to);

/// A document with all of them.
std::string result_text(const EntryResult& result);

/// What result_text() wrote. Nothing where a member is missing or of another kind: then another version wrote it.
std::optional<EntryResult> result_from(const JsonDocument& document, JsonIndex object);

} // namespace refraster::suite
