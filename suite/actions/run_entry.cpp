#include "suite/actions/run_entry.h"

#include <refraster/notes.h>

#include "bench/machine/machine.h"
#include "gl/render_gl.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "io/json/json_writer.h"
#include "io/trace/file_trace.h"
#include "raster/stopwatch.h"
#include "suite/actions/actions.h"
#include "suite/actions/input_digests.h"
#include "verify/compare/cluster_objects.h"

#include <new>

namespace refraster::suite {
namespace {

/// The image of the scene, as the entry asks for it.
Picture picture_of(const Entry& entry, const Picture& of_scene) {
  Picture picture = of_scene;
  if (entry.size) picture.width = entry.size->width, picture.height = entry.size->height;
  if (entry.samples) picture.samples = *entry.samples;
  if (entry.transfer) picture.transfer = *entry.transfer;
  const std::uint64_t samples = static_cast<std::uint64_t>(picture.width) * static_cast<std::uint64_t>(picture.height) *
                                static_cast<std::uint64_t>(picture.samples);
  if (samples > limit::frame_samples.value)
    throw InputError(
        InputFault{entry.scene, 0, 0, "", found_of(limit::frame_samples, samples), at_most(limit::frame_samples)});
  return picture;
}

void act(Task& task) {
  if (task.workplace.purpose == Purpose::update) return update_reference(task);
  switch (task.entry.action) {
  case Action::compare:
    return compare_with_reference(task);
  case Action::verify:
    return verify_image(task);
  case Action::render:
  case Action::gl:
    return make_image(task);
  case Action::bench:
    return time_frame(task);
  }
}

/// What went wrong, as the state and its message. The exception that is being handled.
void enter_failure(EntryResult& result) {
  const auto fail = [&](State state, const std::string& message) {
    result.state = state;
    result.message = message;
  };
  try {
    throw;
  } catch (const InputError& error) {
    fail(State::bad_input, error.faults().front().text());
    for (std::size_t i = 1; i < error.faults().size(); ++i) result.details.push_back(error.faults()[i].text());
  } catch (const OutputError& error) {
    fail(State::unwritable, error.what());
  } catch (const NoOpenGl& error) {
    fail(State::no_opengl, error.what());
  } catch (const std::bad_alloc& error) {
    const bool says_more = dynamic_cast<const OutOfMemory*>(&error) != nullptr;
    fail(State::out_of_memory, says_more ? error.what() : "out of memory");
  } catch (const std::exception& error) {
    fail(State::crashed, std::string("internal error: ") + error.what());
  }
  result.page.clear(), result.image.clear(), result.difference.clear();
}

} // namespace

EntryResult unfinished(const Entry& entry, State state, std::string message) {
  EntryResult result;
  result.name = entry.name, result.scene = entry.scene, result.action = entry.action;
  result.tags = entry.tags;
  result.precision = std::string(name_of(entry.precision));
  result.device = entry.device;
  result.state = state;
  result.message = std::move(message);
  result.finished = bench::utc_now();
  return result;
}

std::string settings_of(const Entry& entry, const Workplace& workplace) {
  JsonWriter json;
  json.object([&] {
    json.member("program", workplace.program);
    json.member("scene", entry.scene);
    json.member("action", name_of(entry.action));
    json.member("image", static_cast<int>(entry.image_from));
    json.member("image_file", entry.image_file);
    json.member("device", entry.device);
    json.member("size", entry.size ? std::vector<int>{entry.size->width, entry.size->height} : std::vector<int>{});
    json.member("samples", entry.samples);
    json.member("srgb", entry.transfer ? std::optional<bool>(*entry.transfer == Transfer::srgb) : std::nullopt);
    json.member("precision", name_of(entry.precision));
    json.member("outside", entry.outside == Outside::allowed);
    json.member("max_abs", entry.limits.compare.max_abs);
    json.member("max_rms", entry.limits.compare.max_rms);
    json.member("max_count", entry.limits.compare.max_count);
    json.member("frame_ms", entry.limits.frame_ms);
    for (const ClassLimit& limit : entry.limits.classes) json.member(name_of(limit.pixel_class), limit.most);
    if (entry.needs_gl())
      if (const auto driver = workplace.drivers.find(entry.device); driver != workplace.drivers.end())
        json.member("driver", driver->second);
    if (entry.action == Action::compare && workplace.references != nullptr)
      if (const Reference* const record = workplace.references->find(entry.name)) {
        json.member("reference", name_of(record->kind));
        json.member("reference_sha256", record->sha256);
      }
  });
  return text_sha256(json.text());
}

EntryResult run_entry(const Entry& entry, const Workplace& workplace) {
  const Stopwatch stopwatch;
  const FileTrace trace;
  const FileTime started = file_time_now();
  EntryResult result = unfinished(entry, State::crashed, "");
  if (entry.needs_gl() && workplace.before_gl) workplace.before_gl();
  try {
    SceneOptions reading;
    reading.outside = entry.outside;
    reading.memory = workplace.memory;
    reading.threads = workplace.threads;
    SceneSource source = read_scene_source(entry.scene, reading);
    result.objects = object_labels(source.scene);
    Task task{entry, workplace, source, picture_of(entry, source.view.picture), result};
    result.samples = task.picture.samples;
    act(task);
  } catch (...) {
    enter_failure(result);
  }
  result.seconds = stopwatch.seconds();
  result.settings = settings_of(entry, workplace);
  // Times differ from run to run: what is measured once holds for that run alone.
  if (entry.action != Action::bench && facts_of(result.state).is_repeatable)
    result.inputs = digests_since(trace.paths(), workplace.results, started);
  result.finished = bench::utc_now();
  return result;
}

} // namespace refraster::suite
