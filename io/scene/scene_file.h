#pragma once
// The scene file: docs/scene-format.md.

#include <refraster/memory.h>
#include <refraster/scene.h>

#include "io/file/notes.h"

#include <memory>
#include <string>
#include <vector>

namespace refraster {

/// Whether a scene may name files that lie outside its own folder, symbolic links followed. A scene from someone else
/// should not: it could show, or tell apart by what is said of them, files that are not its author's.
enum class Outside { refused, allowed };

struct SceneOptions {
  Outside outside = Outside::refused;
  MemoryBudget memory = {};
  NoteList* notes = nullptr; // where remarks on the files that are read go; nowhere if null
  // Fragment functions of one's own that a scene may name: user_function() of the fragment kit makes them. A material
  // has a copy, with its parameters.
  std::vector<std::shared_ptr<UserFunction>> user_functions = {};
  std::string mesh_cache; // a folder of large meshes that were read before (io/mesh/mesh_cache.h); none if empty
};

/// Reads a scene with every file that it names: meshes, textures, measured tables. A file named twice is loaded once.
/// Throws InputError with all faults: of the scene in the order of the file, then of the files it names; and
/// OutputError if a folder for meshes is given that lets nothing be written to it.
Scene read_scene(const std::string& path, const SceneOptions& options = {});

/// The keys of a scene file as Markdown tables, made from the declaration that the reader follows.
std::string scene_format_markdown();

} // namespace refraster
