#pragma once
// What JSON reports have in common.

#include "io/file/build_info.h"
#include "io/json/json_writer.h"

namespace refraster {

/// Changes when a member of a report gets another name or meaning.
inline constexpr int report_schema = 2;

/// The members version, compiler, type, march, isa, flags of an object that names a build.
void write_build(JsonWriter& json, const BuildInfo& build);

/// The member "size": width and height in pixels.
void write_size(JsonWriter& json, int width, int height);

} // namespace refraster
