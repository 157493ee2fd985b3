// refraster mesh sphere | cube | plane | torus | knot: the shapes of a scene's "mesh", with the same parameters, as a
// file.

#include "app/arguments.h"
#include "app/command.h"
#include "app/memory_limit.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "io/mesh/obj_file.h"
#include "io/scene/shape_mesh.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

/// "tube_radius" in a scene file is "--tube-radius" here.
std::string option_name(std::string_view key) {
  std::string name = "--" + std::string(key);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

template <class S>
void add_shape(CLI::App& mesh, Action& chosen) {
  const std::string name(S::name);
  CLI::App& command = add_sub_command(mesh, name, std::string(S::meaning));
  const auto shape = std::make_shared<S>();
  const auto output = std::make_shared<std::string>(name + ".obj");
  S::fields(*shape, [&](std::string_view key, auto& value, const Range& range, std::string_view meaning, Presence) {
    add_number_option(command, option_name(key), value, range, std::string(meaning));
  });
  command.add_option("-o,--output", *output, "OBJ file to write")->type_name("FILE");
  const auto max_memory = std::make_shared<std::uint64_t>(0);
  add_memory_option(command, *max_memory);
  command.final_callback([&chosen, shape, output, max_memory] {
    chosen = [shape, output, max_memory] {
      const MemoryBudget memory = set_memory_limit(*max_memory, 1);
      check_writable(*output);
      {
        const ProgressLine line("making " + *output);
        const MeshCounts counts = mesh_counts(*shape);
        memory.need(counts.size_bytes(), std::to_string(counts.triangles) + " triangles");
        write_obj(*output, *make_mesh(*shape));
      }
      std::cout << *output << "\n";
      return ExitCode::ok;
    };
  });
}

template <class... S>
void add_shapes(CLI::App& mesh, Action& chosen, const std::variant<S...>*) {
  (add_shape<S>(mesh, chosen), ...);
}

} // namespace

void add_mesh(CLI::App& program, Action& chosen) {
  CLI::App& mesh = add_sub_command(program, "mesh", "Make a mesh and write it as OBJ");
  mesh.require_subcommand(1);
  add_shapes(mesh, chosen, static_cast<const Shape*>(nullptr));
}

} // namespace refraster
