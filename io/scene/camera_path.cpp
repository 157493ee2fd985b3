#include "io/scene/camera_path.h"

#include "io/file/input_file.h"
#include "io/json/json.h"
#include "io/scene/scene_keys.h"
#include "io/scene/scene_reader.h"

namespace refraster {

std::vector<PathCamera> read_cameras(const std::string& path, const Camera& otherwise) {
  const JsonDocument document(path, read_file(path, "a list of cameras", JsonDocument::max_bytes));
  FaultList faults;
  const auto fail = [&](const JsonNode& node, std::string place) {
    faults.add(document.fault_at(node.begin, std::move(place), document.describe(node), "an object: a camera"));
  };
  const JsonNode& root = document[0];
  if (root.kind != JsonKind::array || root.children == 0) {
    faults.add(document.fault_at(root.begin, "", document.describe(root), "a list of cameras"));
    faults.throw_if_any();
  }
  std::vector<PathCamera> cameras;
  for (JsonIndex i = root.first_child; i; i = document[i].next) {
    const std::string place = "/" + std::to_string(cameras.size());
    PathCamera& camera = cameras.emplace_back(PathCamera{otherwise, {}});
    if (document[i].kind != JsonKind::object) {
      fail(document[i], place);
      continue;
    }
    SceneReader reader(document, i, place, faults);
    SceneView view;
    camera_keys(camera.camera, view, reader);
    camera.fit = view.fit;
    reader.finish();
  }
  faults.throw_if_any();
  return cameras;
}

} // namespace refraster
