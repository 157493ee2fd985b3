#pragma once
// refraster.Mesh

#include <refraster/mesh.h>

#include "python/bindings.h"

#include <memory>

namespace refraster::python {

/// A mesh, as Python has it.
struct LiveMesh {
  std::shared_ptr<const Mesh> mesh; ///< not null
  std::shared_ptr<Mesh> own = {};   ///< the same, where Python made it: then its arrays may be written to

  explicit LiveMesh(std::shared_ptr<const Mesh> of_file) : mesh(std::move(of_file)) {}
  explicit LiveMesh(std::shared_ptr<Mesh> made) : mesh(made), own(std::move(made)) {}
};

} // namespace refraster::python
