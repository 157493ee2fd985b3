#include "tests/system/faults/disks.h"

#include "tests/support/program/scenes.h"
#include "tests/system/faults/sandbox.h"

#include <filesystem>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

namespace refraster {
namespace {

namespace fs = std::filesystem;

const std::vector<WritingCommand>& commands() {
  static const std::vector<WritingCommand> list = [] {
    std::vector<WritingCommand> result;
    for (const char* const name : {"o.png", "o.pfm", "o.exr", "o.hdr"})
      result.push_back({std::string("render ") + name,
                        {"render", "s.json", "--size", "160x120", "-o", std::string("out/") + name},
                        {name}});
    result.push_back({"mesh", {"mesh", "sphere", "-o", "out/m.obj"}, {"m.obj"}});
    return result;
  }();
  return list;
}

/// A small disk in the place of the outputs.
class SmallDisk {
public:
  explicit SmallDisk(const Sandbox& sandbox) : path_(sandbox.out()) {
    mounted_ = mount("tmpfs", path_.c_str(), "tmpfs", 0, "size=256k") == 0;
  }
  ~SmallDisk() {
    if (mounted_) umount2(path_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;

  bool mounted() const { return mounted_; }
  void let_read_only() const { mount(nullptr, path_.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr); }

private:
  std::string path_;
  bool mounted_ = false;
};

void run_and_judge(Sandbox& sandbox, Before before, FaultRow& row) {
  sandbox.judge(run_program(sandbox.folder(), sandbox.command().words), before, row);
}

void save_old_files(const Sandbox& sandbox) {
  for (const std::string& name : sandbox.command().outputs)
    save_text(sandbox.out() + "/" + name, "the old " + name + "\n");
}

FaultRow full_disk() {
  FaultRow row;
  row.fault = "a disk of 256 KiB with less and less room";
  for (const WritingCommand& command : commands()) {
    Sandbox sandbox(command);
    for (int room = 256 - 8; room >= 0; room -= 16) {
      sandbox.prepare(Before::nothing);
      const SmallDisk disk(sandbox);
      if (!disk.mounted()) return row;
      save_old_files(sandbox);
      // Out of sight of the judge: a file without a name would be, but only while it is open.
      const std::string filler = sandbox.out() + "/filler";
      save_text(filler, std::string(static_cast<std::size_t>(256 - 8 - room) << 10, 'x'));
      const Finished run = run_program(sandbox.folder(), command.words);
      fs::remove(filler);
      sandbox.judge(run, Before::old_files, row);
    }
  }
  return row;
}

FaultRow read_only_disk() {
  FaultRow row;
  row.fault = "a disk that may only be read";
  for (const WritingCommand& command : commands()) {
    Sandbox sandbox(command);
    const SmallDisk disk(sandbox);
    if (!disk.mounted()) return row;
    save_old_files(sandbox);
    disk.let_read_only();
    run_and_judge(sandbox, Before::old_files, row);
  }
  return row;
}

FaultRow limited_sizes() {
  FaultRow row;
  row.fault = "a limit of file sizes, ulimit -f";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  for (const WritingCommand& command : commands()) {
    Sandbox sandbox(command);
    for (const rlim_t most : {0u, 100u, 1000u, 5000u, 20000u}) {
      sandbox.prepare(Before::old_files);
      const rlimit limit{most + 200, before.rlim_max}; // 200: what it says about it goes to a file too
      setrlimit(RLIMIT_FSIZE, &limit);
      const Finished run = run_program(sandbox.folder(), command.words);
      setrlimit(RLIMIT_FSIZE, &before);
      sandbox.judge(run, Before::old_files, row);
    }
  }
  return row;
}

} // namespace

std::vector<FaultRow> bad_disks() {
  std::vector<FaultRow> rows = {limited_sizes()};
  if (unshare(CLONE_NEWNS) != 0 || mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return {};
  for (const auto disk : {full_disk, read_only_disk}) {
    rows.push_back(disk());
    if (rows.back().runs == 0) return {};
  }
  return rows;
}

} // namespace refraster
