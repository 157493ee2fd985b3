#include "app/parts/frame_parts.h"

#include <refraster/files.h>

#include "app/interrupt.h"
#include "app/output.h"
#include "app/parts/part_list.h"
#include "app/progress_line.h"
#include "app/turntable/film.h"
#include "app/turntable/frame_names.h"
#include "app/usage_error.h"
#include "io/file/atomic_file.h"
#include "io/file/input_file.h"
#include "io/file/sha256.h"
#include "io/file/text.h"

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

namespace refraster {
namespace {

namespace fs = std::filesystem;

/// A frame stands beside the report that names it, wherever both were brought.
std::string path_beside(const std::string& report, const std::string& frame) {
  return (fs::path(report).parent_path() / fs::path(frame).filename()).string();
}

/// Puts the frames of a part into the whole; says which of them are not there.
void take_frames(const std::string& report, const FrameDigests& part, WholeTurn& turn, FaultList& faults) {
  for (std::size_t i = 0; i < part.frames.size(); ++i) {
    if (!has_frame(*part.shard, i)) continue;
    const std::string path = path_beside(report, part.frames[i]), place = "frame " + std::to_string(i + 1);
    if (part.digests[i].empty())
      faults.add({report, 0, 0, place, "none, since the run was not done", "all of its frames"});
    else if (!is_whole_frame(path, part.digests[i]))
      faults.add({report, 0, 0, place, path + " missing or other than it was written", "the frame of its sha256"});
    turn.known.digests[i] = part.digests[i];
    turn.paths[i] = path;
  }
}

Image<std::uint8_t> film_frame(const std::string& path, const std::string& digest) {
  const std::string bytes = read_file(path, "a frame", limit::image_bytes.value);
  if (text_sha256(bytes) != digest) throw InputError(InputFault{path, 0, 0, "", "another file than before", "a frame"});
  const ImageFile file = read_image(path);
  if (file.bits != 8 || file.values.channels != 3 || format_of_name(path)->wants_all_rows)
    throw InputError(
        InputFault{path, 0, 0, "", "another image", "one of red, green and blue of 8 bits, without loss, for a film"});
  Image<std::uint8_t> rgb8(file.values.width, file.values.height, 3);
  std::transform(file.values.values.begin(), file.values.values.end(), rgb8.values.begin(),
                 [](float value) { return static_cast<std::uint8_t>(value); });
  return rgb8;
}

} // namespace

WholeTurn read_turn(const std::vector<std::string>& reports) {
  WholeTurn turn;
  FaultList faults;
  PartList list;
  std::string first;
  for (const std::string& report : reports) try {
      FrameDigests part = read_digests(report);
      if (!part.shard) {
        faults.add({report, 0, 0, "shard", "nothing", "the report of a run with --shard"});
        continue;
      }
      if (first.empty()) {
        first = report, turn.known = part;
        turn.known.shard.reset();
        turn.known.digests.assign(part.frames.size(), "");
        turn.paths.resize(part.frames.size());
      }
      if (auto fault = settings_fault(report, part.settings, first, turn.known.settings)) {
        faults.add(std::move(*fault));
        continue;
      }
      if (part.frames.size() != turn.paths.size()) {
        faults.add({report, 0, 0, "frames", std::to_string(part.frames.size()),
                    std::to_string(turn.paths.size()) + ", as " + first + " has"});
        continue;
      }
      list.add(report, *part.shard, faults);
      if (part.shard->part == 1) turn.known.scene = part.scene; // as one run would name it
      take_frames(report, part, turn, faults);
    } catch (const InputError& error) {
      faults.add(error);
    }
  list.check_complete(faults);
  faults.throw_if_any();
  return turn;
}

std::vector<std::string> collect_frames(WholeTurn turn, const std::string& pattern, const Diagnostics& diagnostics) {
  const std::optional<FrameNames> names = FrameNames::of(pattern);
  if (!names)
    throw UsageError("--output", in_quotes(pattern),
                     "one place for the number of a frame, as in out/####.png; or a film, as out.mp4");
  if (format_of_name(pattern) != format_of_name(turn.paths.front()))
    throw UsageError("--output", in_quotes(pattern),
                     "a name ending in ." + extension(turn.paths.front()) + ", as the frames have");
  if (const std::string folder = fs::path(pattern).parent_path(); !folder.empty()) prepare_folder(folder);
  check_writable(names->report_name());
  const auto line = progress_line(diagnostics, "collecting " + counted(turn.paths.size(), "frame"));
  for (std::size_t i = 0; i < turn.paths.size(); ++i) {
    turn.known.frames[i] = names->name(i);
    if (line) line->show(static_cast<double>(i) / static_cast<double>(turn.paths.size()));
    if (canonical_path(turn.paths[i]) == canonical_path(turn.known.frames[i])) continue;
    check_different({turn.known.frames[i]}, {});
    const std::string bytes = read_file(turn.paths[i], "a frame", std::numeric_limits<std::uint64_t>::max());
    if (text_sha256(bytes) != turn.known.digests[i])
      throw InputError(InputFault{turn.paths[i], 0, 0, "", "another file than before", "the frame of its sha256"});
    write_file(turn.known.frames[i], bytes);
  }
  write_text(names->report_name(), digests_json(turn.known));
  return turn.known.frames;
}

bool film_frames(WholeTurn turn, const std::string& path, int frames_per_second, const Diagnostics& diagnostics) {
  check_writable(path);
  const auto line = progress_line(diagnostics, "making " + path);
  std::unique_ptr<Film> film;
  for (std::size_t i = 0; i < turn.paths.size(); ++i) {
    if (interrupted()) return false;
    const Image<std::uint8_t> frame = film_frame(turn.paths[i], turn.known.digests[i]);
    if (!film) film = std::make_unique<Film>(path, frame.width, frame.height, frames_per_second);
    film->add(frame);
    turn.known.frames[i].clear();
    turn.known.digests[i] = pixels_sha256(frame);
    if (line) line->show(static_cast<double>(i + 1) / static_cast<double>(turn.paths.size()));
  }
  film->finish();
  write_text(path + ".json", digests_json(turn.known));
  return true;
}

} // namespace refraster
