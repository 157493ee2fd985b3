#include "verify/device/write_profile.h"

namespace refraster {

void write_device_profile(JsonWriter& json, const DeviceProfile& profile) {
  json.object([&] {
    json.member("name", profile.name);
    json.member("version", profile.version);
    json.member("meaning", profile.meaning);
    if (profile.renderer != GlRenderer::system_default) json.member("renderer", name_of(profile.renderer));
    if (!profile.environment.empty())
      json.object("environment", [&] {
        for (const auto& [name, value] : profile.environment) json.member(name, value);
      });
    if (profile.measured)
      json.object("measured", [&] {
        MeasuredDevice::fields(*profile.measured, [&](std::string_view key, const std::string& value,
                                                      std::string_view) { json.member(key, value); });
        json.member("probe_version", profile.measured->probe_version);
      });
    DeviceProfile::groups(profile, [&](std::string_view name, const auto& group, std::string_view) {
      json.object(name, [&] {
        group_fields(group,
                     [&]<class Value>(std::string_view key, const Value& value, const Range&, Wider, std::string_view) {
                       if constexpr (NamedEnum<Value>) json.member(key, name_of(value));
                       else json.member(key, value);
                     });
      });
    });
    if (profile.sources.empty()) return;
    json.object("sources", [&] {
      DeviceProfile::groups(profile, [&](std::string_view name, const auto& group, std::string_view) {
        json.object(name, [&] {
          group_fields(group, [&](std::string_view key, const auto&, const Range&, Wider, std::string_view) {
            const auto source = profile.sources.find(std::string(name).append("/").append(key));
            if (source != profile.sources.end()) json.member(key, source->second);
          });
        });
      });
    });
  });
}

std::string device_profile_json(const DeviceProfile& profile) {
  JsonWriter json;
  write_device_profile(json, profile);
  return json.text();
}

} // namespace refraster
