#pragma once
// What is done with an entry's scene, a file each. All of them fill in the result, throw InputError, OutputError,
// NoOpenGl, std::bad_alloc, and leave to run_entry() what is the same for all.

#include "io/scene/scene_source.h"
#include "suite/actions/workplace.h"
#include "suite/entry/result.h"

#include <string>

namespace refraster::suite {

/// What an action works on.
struct Task {
  const Entry& entry;
  const Workplace& workplace;
  SceneSource& source; // placed for the image's size by whoever knows it
  Picture picture;     // to make
  EntryResult& result;

  /// "images/ball.png": of the entry, below the folder of results.
  std::string file(const char* folder, const char* extension) const {
    return std::string(folder) + "/" + entry.name + extension;
  }
  std::string path_of(const std::string& file) const { return workplace.results + "/" + file; }

  /// How the picture is rendered; and the scene placed for its size.
  RenderOptions placed_options();
};

void compare_with_reference(Task& task); // compare_action.cpp
void update_reference(Task& task);       // update_action.cpp
void verify_image(Task& task);           // verify_action.cpp
void make_image(Task& task);             // make_action.cpp: render and gl
void time_frame(Task& task);             // bench_action.cpp

/// Folders below that of the results.
inline constexpr const char *images_folder = "images", *pages_folder = "pages";

} // namespace refraster::suite
