#pragma once
// What a worker has to do its entries with.

#include <refraster/memory.h>

#include "suite/references/references.h"

#include <functional>
#include <map>
#include <string>

namespace refraster::suite {

/// Whether images are held against references, or become them.
enum class Purpose { judge, update };

struct Workplace {
  const References* references = nullptr;
  std::string results; // folder; images and pages are written below it. Of an update unused
  Purpose purpose = Purpose::judge;
  int threads = 1;
  MemoryBudget memory;
  std::function<void()> before_gl;            // called once OpenGL is about to be used: drivers bear no limit of memory
  std::string program;                        // sha256 of it
  std::map<std::string, std::string> drivers; // by Entry::device: OpenGL's own words; none where there is no OpenGL
};

} // namespace refraster::suite
