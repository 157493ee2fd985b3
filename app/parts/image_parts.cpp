#include "app/parts/image_parts.h"

#include "app/output.h"
#include "app/parts/part_list.h"
#include "app/parts/picture_settings.h"
#include "app/usage_error.h"
#include "io/file/text.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace refraster {
namespace {

constexpr const char* colour_name = "image";

/// Files of parts that are open: not more than a system lets a process have.
class OpenParts {
public:
  explicit OpenParts(std::vector<ImagePart> parts) : parts_(std::move(parts)) {}

  const PartHeader& header() const { return parts_.front().header(); }

  /// By any thread.
  void read_row(std::size_t image, int y, void* to) {
    const auto part = std::upper_bound(parts_.begin(), parts_.end(), y, [](int row, const ImagePart& one) {
      return row < one.header().rows().first + one.header().rows().count;
    });
    part->read_row(*opened(static_cast<std::size_t>(part - parts_.begin())), image, y, to);
  }

private:
  static constexpr std::size_t max_open = 256; // a quarter of what Linux lets a process have unless told otherwise

  std::shared_ptr<const InputFile> opened(std::size_t part) {
    const std::lock_guard lock(mutex_);
    if (const auto found = open_.find(part); found != open_.end()) return found->second;
    if (open_.size() == max_open) open_.clear(); // whoever reads one of them holds it
    return open_[part] = parts_[part].open();
  }

  std::vector<ImagePart> parts_;
  std::mutex mutex_;
  std::map<std::size_t, std::shared_ptr<const InputFile>> open_;
};

template <class Value>
ImageRows<Value> joined(const std::shared_ptr<OpenParts>& parts, std::size_t image) {
  const PartHeader& header = parts->header();
  return {header.width, header.height, header.images[image].channels,
          [parts, image](int y, std::vector<Value>& scratch) {
            const PartHeader& of = parts->header();
            scratch.resize(static_cast<std::size_t>(of.width) * static_cast<std::size_t>(of.images[image].channels));
            parts->read_row(image, y, scratch.data());
            return static_cast<const Value*>(scratch.data());
          }};
}

/// What of a part is not as in the first.
std::optional<InputFault> contradiction(const ImagePart& part, const ImagePart& first) {
  const PartHeader &here = part.header(), &there = first.header();
  if (auto fault = settings_fault(part.path(), here.settings, first.path(), there.settings)) return fault;
  const auto size_of = [](const PartHeader& header) {
    return std::to_string(header.width) + "x" + std::to_string(header.height);
  };
  if (size_of(here) != size_of(there))
    return InputFault{part.path(), 0, 0, "size", size_of(here), size_of(there) + ", as " + first.path() + " has it"};
  const bool same_images = std::equal(here.images.begin(), here.images.end(), there.images.begin(), there.images.end(),
                                      [](const PartImage& a, const PartImage& b) { return a.is_alike(b); });
  if (!same_images) return InputFault{part.path(), 0, 0, "images", "other images", "those of " + first.path()};
  return std::nullopt;
}

/// Throws InputError unless the images are those that the options ask for.
void check_images(const ImagePart& part, const FrameFiles& files) {
  const std::vector<PartImage>& images = part.header().images;
  const auto refuse = [&](const std::string& name) {
    throw InputError(
        InputFault{part.path(), 0, 0, "images", name + " missing or of other values", "what its options say"});
  };
  if (images[0].name != colour_name || images[0].channels != 3) refuse(colour_name);
  std::vector<Aov> wanted = written_aovs(files);
  if (files.background == Background::transparent) wanted.push_back(Aov::alpha);
  for (const Aov aov : wanted) {
    const AovKind& kind = kind_of(aov);
    const PartImage expected{std::string(kind.name), ImageValues::floats, kind.channels};
    if (std::none_of(images.begin() + 1, images.end(), [&](const PartImage& one) { return one.is_alike(expected); }))
      refuse(expected.name);
  }
}

} // namespace

void write_part(const std::string& path, PartHeader header, const FrameRows& rows) {
  std::vector<AnyRows> images = {rows.image};
  header.images = {{colour_name, values_of(rows.image), 3}};
  for (const auto& [aov, image] : rows.aovs) {
    images.emplace_back(image);
    header.images.push_back({std::string(kind_of(aov).name), ImageValues::floats, kind_of(aov).channels});
  }
  write_image_part(path, std::move(header), images);
}

WholeImage read_parts(const std::vector<std::string>& paths) {
  WholeImage whole;
  FaultList faults;
  PartList list;
  for (const std::string& path : paths) try {
      ImagePart part(path);
      if (!whole.parts.empty())
        if (auto fault = contradiction(part, whole.parts.front())) {
          faults.add(std::move(*fault));
          continue;
        }
      list.add(path, part.header().shard, faults);
      whole.parts.push_back(std::move(part));
    } catch (const InputError& error) {
      faults.add(error);
    }
  list.check_complete(faults);
  faults.throw_if_any();
  take_file_settings(whole.parts.front().path(), whole.parts.front().header().settings, whole.files, whole.transfer);
  check_images(whole.parts.front(), whole.files);
  for (const ImagePart& part : whole.parts) try {
      part.check_values();
    } catch (const InputError& error) {
      faults.add(error);
    }
  faults.throw_if_any();
  std::sort(whole.parts.begin(), whole.parts.end(),
            [](const ImagePart& a, const ImagePart& b) { return a.header().shard.part < b.header().shard.part; });
  return whole;
}

void check_whole_output(const WholeImage& whole, const std::string& output) {
  FrameFiles files = whole.files;
  const ImageValues values = whole.parts.front().header().images[0].values;
  const int channels = files.background == Background::transparent ? 4 : 3;
  check_extension("--output", output, {{values, channels}});
  if (output_values(files, output) != values)
    throw UsageError("--output", in_quotes(output),
                     "a name that `render` writes " + std::string(depth_of(values).name) + " to: the parts hold these");
  check_output(files, output, whole.transfer, {});
}

std::vector<std::string> write_whole(WholeImage whole, const std::string& output, int threads,
                                     const MemoryBudget& memory) {
  const auto parts = std::make_shared<OpenParts>(std::move(whole.parts));
  const PartHeader& header = parts->header();
  if (format_of_name(output)->wants_all_rows)
    memory.need(static_cast<std::uint64_t>(header.width) * static_cast<std::uint64_t>(header.height) * 3, output);
  const auto colours = [&]() -> AnyRows {
    switch (header.images[0].values) {
    case ImageValues::uint8:
      return joined<std::uint8_t>(parts, 0);
    case ImageValues::uint16:
      return joined<std::uint16_t>(parts, 0);
    default:
      return joined<float>(parts, 0);
    }
  };
  FrameRows rows{colours(), {}};
  for (std::size_t i = 1; i < header.images.size(); ++i)
    for (std::size_t kind = 0; kind < std::size(aov_kinds); ++kind)
      if (header.images[i].name == aov_kinds[kind].name)
        rows.aovs.emplace_back(static_cast<Aov>(kind), joined<float>(parts, i));
  return write_frame_rows(whole.files, output, whole.transfer, threads, rows);
}

} // namespace refraster
