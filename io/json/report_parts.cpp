#include "io/json/report_parts.h"

namespace refraster {

void write_build(JsonWriter& json, const BuildInfo& build) {
  json.member("version", build.version);
  json.member("compiler", build.compiler);
  json.member("type", build.type);
  json.member("march", build.march);
  json.member("isa", build.isa);
  json.member("flags", build.flags);
}

void write_size(JsonWriter& json, int width, int height) {
  json.member("size", std::vector<int>{width, height});
}

} // namespace refraster
