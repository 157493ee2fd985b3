#include "app/commands/probe_run.h"

#include "app/output.h"
#include "app/progress_line.h"
#include "gl/context/driver_environment.h"
#include "gl/probe/probe_device.h"
#include "verify/device/measured_profile.h"
#include "verify/device/profile_markdown.h"
#include "verify/device/profile_order.h"
#include "verify/device/read_profile.h"
#include "verify/device/write_profile.h"

#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace refraster {

ExitCode run_probe(const ProbeArguments& a) {
  std::optional<DeviceProfile> expected;
  if (!a.device.empty()) expected = device_profile(a.device);
  if (expected) enter_environment(expected->environment);
  const bool is_file = !a.output.empty() && a.output != standard_output;
  if (is_file) check_writable(a.output);
  DeviceFacts facts;
  try {
    const auto line = progress_line(a.diagnostics, "probing");
    facts = probe_device(a.renderer == GlRenderer::system_default && expected ? expected->renderer : a.renderer);
  } catch (const NoOpenGl& error) {
    std::cerr << "refraster: " << error.what() << "\n";
    return ExitCode::no_opengl;
  }
  const DeviceProfile measured =
      measured_profile(facts, is_file ? std::filesystem::path(a.output).stem().string() : "measured");
  if (is_file) std::cout << a.output << "\n";
  if (is_file || !expected)
    write_text(is_file ? a.output : std::string(standard_output), device_profile_json(measured));
  if (!expected) return ExitCode::ok;
  if (a.output != standard_output) std::cout << measured_markdown(measured, *expected);
  std::vector<std::string> beyond = members_beyond(measured, *expected);
  std::erase_if(beyond, [&](const std::string& place) { return !is_measured(measured, place); });
  for (const std::string& place : beyond)
    std::cerr << "refraster: " << place << " was measured to be more than " << a.device << " allows\n";
  return beyond.empty() ? ExitCode::ok : ExitCode::differ;
}

} // namespace refraster
