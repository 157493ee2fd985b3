#include "tests/system/faults/sandbox.h"

#include <refraster/files.h>

#include "tests/support/program/scenes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace refraster {

namespace fs = std::filesystem;

Environment::Environment(std::vector<std::pair<std::string, std::string>> variables)
    : variables_(std::move(variables)) {
  for (const auto& [name, value] : variables_) setenv(name.c_str(), value.c_str(), 1);
}

Environment::~Environment() {
  for (const auto& [name, value] : variables_) unsetenv(name.c_str());
}

namespace {

std::string old_text(const std::string& name) {
  return "the old " + name + "\n";
}

/// Reports hold times, which differ from run to run.
bool is_report(const std::string& name) {
  return name.ends_with(".json") || name.ends_with(".html");
}

bool is_temporary_name(const std::string& name) {
  return name.starts_with("refraster-") && name.ends_with(".part");
}

} // namespace

Sandbox::Sandbox(WritingCommand command) : command_(std::move(command)) {
  save_text(folder_ / "s.json", ball_scene);
  save_text(folder_ / "mesh.json", ball_from_file());
  std::string mesh; // of 1.3 MB: smaller ones are not kept
  for (int i = 0; i < 40000; ++i) mesh += "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
  save_text(folder_ / "m.obj", mesh);
  Image<float> picture(16, 12, 3, 0.5f);
  write_image(folder_ / "a.pfm", picture);
  picture.values[7] = 0.75f;
  write_image(folder_ / "b.pfm", picture);
  prepare(Before::nothing);
  const Finished run = run_program(folder(), command_.words);
  if (run.exit_code > 1) throw std::runtime_error(command_.name + ": " + run.err);
  for (const std::string& name : command_.outputs) right_[name] = text_of(out() + "/" + name);
}

void Sandbox::prepare(Before before) {
  fs::remove_all(out());
  fs::remove_all(folder_ / "cache");
  fs::create_directory(out());
  if (before == Before::old_files)
    for (const std::string& name : command_.outputs) save_text(out() + "/" + name, old_text(name));
}

bool Sandbox::run_with_fault(const std::string& fault, Before before, FaultRow& row) {
  prepare(before);
  const std::string hit = folder_ / "hit";
  fs::remove(hit);
  Finished run;
  {
    const Environment environment(
        {{"LD_PRELOAD", REFRASTER_FAULTY_CALLS}, {"REFRASTER_FAULT", fault}, {"REFRASTER_FAULT_HIT", hit}});
    run = run_program(folder(), command_.words);
  }
  if (!fs::exists(hit)) return false;
  judge(run, before, row);
  return true;
}

bool Sandbox::is_whole(const std::string& name, const std::string& text) const {
  const std::string& right = right_.at(name);
  if (!is_report(name)) return text == right;
  const auto end = [](const std::string& all) { return all.substr(all.size() - std::min<std::size_t>(all.size(), 4)); };
  return text.size() > right.size() / 2 && text.substr(0, 16) == right.substr(0, 16) && end(text) == end(right);
}

void Sandbox::judge(const Finished& run, Before before, FaultRow& row) {
  ++row.runs;
  const std::string what = command_.name + ", exit code " + std::to_string(run.exit_code) + ", \"" + run.err + "\"";
  switch (run.exit_code) {
  case 0:
  case 1:
    ++row.done;
    break;
  case 3:
  case 4:
  case 130:
    ++row.refused;
    break;
  case 128 + 9:
    ++row.killed;
    break;
  default:
    row.wrong.push_back(what);
  }
  if (run.exit_code == 3 || run.exit_code == 4) {
    // The last line is the complaint, and the only one; `gl` has said before which shaders it uses.
    const std::size_t complaint = run.err.rfind("refraster: ");
    const bool one_line = complaint != std::string::npos && run.err.find("refraster: ") == complaint &&
                          (complaint == 0 || run.err[complaint - 1] == '\n') &&
                          run.err.find('\n', complaint) == run.err.size() - 1;
    if (!one_line) row.wrong.push_back("not one line: " + what);
  }
  const int new_before = row.new_files;
  judge_outputs(before, what, row);
  const int outputs = static_cast<int>(command_.outputs.size());
  if (run.exit_code <= 1 && row.new_files - new_before != outputs) row.wrong.push_back("said to be done: " + what);
  if (run.exit_code == 4 && row.new_files - new_before == outputs && row.fault.find("close") == std::string::npos)
    row.wrong.push_back("said to have failed: " + what);
}

void Sandbox::judge_outputs(Before before, const std::string& what, FaultRow& row) {
  for (const std::string& name : command_.outputs) {
    const std::string path = out() + "/" + name;
    if (!fs::exists(path)) {
      if (before == Before::old_files) row.wrong.push_back(name + " is gone: " + what);
      ++row.absent;
      continue;
    }
    const std::string text = text_of(path);
    if (before == Before::old_files && text == old_text(name)) ++row.old_files;
    else if (is_whole(name, text)) ++row.new_files;
    else row.wrong.push_back(name + " is neither old nor new: " + what);
  }
  for (const auto& entry : fs::directory_iterator(out())) {
    const std::string name = entry.path().filename();
    if (std::find(command_.outputs.begin(), command_.outputs.end(), name) != command_.outputs.end()) continue;
    const std::string text = text_of(entry.path());
    const bool whole = std::any_of(command_.outputs.begin(), command_.outputs.end(),
                                   [&](const std::string& output) { return is_whole(output, text); });
    ++row.left_over;
    // Only a process that is killed may leave something, and only something whole.
    if (row.killed == 0 || !is_temporary_name(name) || !whole) row.wrong.push_back(name + " is left: " + what);
  }
}

void Sandbox::run_again(FaultRow& row) {
  const Finished run = run_program(folder(), command_.words);
  const std::string what = "the run after it, " + command_.name + ": " + run.err;
  if (run.exit_code > 1) row.wrong.push_back(what);
  for (const std::string& name : command_.outputs)
    if (!is_whole(name, text_of(out() + "/" + name))) row.wrong.push_back(name + " is not whole in " + what);
}

std::vector<WritingCommand> commands_that_write(Effort effort) {
  const std::vector<std::string> render = {"render", "s.json", "--size", "16x12", "--threads", "2", "-o"};
  const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  std::vector<WritingCommand> commands = {
      {"render .png, depth .pfm, report",
       with(render, {"out/o.png", "--aov", "depth", "--report", "out/r.json"}),
       {"o.png", "o.depth.pfm", "r.json"}},
      {"render .exr, normal .exr", with(render, {"out/o.exr", "--aov", "normal"}), {"o.exr", "o.normal.exr"}},
      {"compare, difference, report",
       {"compare", "a.pfm", "b.pfm", "--diff", "out/d.png", "--json", "out/c.json"},
       {"d.png", "c.json"}},
  };
  if (effort == Effort::quick) return commands;
  commands.push_back({"render .hdr", with(render, {"out/o.hdr"}), {"o.hdr"}});
  commands.push_back(
      {"render, a part", with(render, {"out/o.png", "--shard", "1/2", "--aov", "depth"}), {"o.png.part-1-of-2"}});
  commands.push_back({"render .pfm", with(render, {"out/o.pfm"}), {"o.pfm"}});
  commands.push_back({"mesh", {"mesh", "sphere", "--segments", "8", "--rings", "4", "-o", "out/m.obj"}, {"m.obj"}});
  commands.push_back({"render with --cache", with(render, {"out/o.png", "--cache", "cache"}), {"o.png"}});
  commands.back().words[1] = "mesh.json";
  commands.push_back({"brdf synth", {"brdf", "synth", "lambert", "-o", "out/t.binary"}, {"t.binary"}});
  commands.push_back(
      {"bench, report, page",
       {"bench", "s.json", "--size", "16x12", "--frames", "1", "--seconds", "0", "--threads", "1", "--gl", "none",
        "--no-marginal", "--no-command", "--no-error", "--json", "out/b.json", "--html", "out/b.html"},
       {"b.json", "b.html"}});
  const WritingCommand gl{"gl .png, float .exr, depth .pfm, report",
                   {"gl", "s.json", "--size", "16x12", "-o", "out/g.png", "--float", "out/f.exr", "--depth",
                    "out/d.pfm", "--json", "out/g.json"},
                   {"g.png", "f.exr", "d.pfm", "g.json"}};
  const TemporaryFolder trial;
  save_text(trial / "s.json", ball_scene);
  if (run_program(trial.path, {"gl", "s.json", "--size", "8x8", "-o", "i.png"}).exit_code == 0) commands.push_back(gl);
  return commands;
}

} // namespace refraster
