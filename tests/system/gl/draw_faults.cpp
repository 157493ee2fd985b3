// draw_faults FOLDER: every seeded fault as a PNG file, and the reference and the right image of each scene, for
// tests/long/other_metrics/run. A line for each image, tabs between: its kind, its file, the reference's, its name, how
// many pixels verify leaves unexplained in 8 bits and in floats, and mean FLIP beside the reference.

#include <refraster/files.h>

#include "gl/render_gl.h"
#include "tests/support/gl/fault_images.h"
#include "verify/compare/flip.h"
#include "verify/device/read_profile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

namespace {

using namespace refraster;

/// Values in levels, rounded as a file of 8 bits has them.
Image<std::uint8_t> levels(const Image<float>& radiance) {
  const DeviceImage stored = stored_image(radiance, StoredAs::rgb8);
  Image<std::uint8_t> image(radiance.width, radiance.height, 3);
  std::transform(stored.colour.values.begin(), stored.colour.values.end(), image.values.begin(),
                 [](float level) { return static_cast<std::uint8_t>(level); });
  return image;
}

class Faults {
public:
  explicit Faults(const std::filesystem::path& folder) : folder_(folder), right_(right_fault_images()) {}

  /// False if a fault shows nowhere.
  bool draw_all() const {
    for (std::size_t i = 0; i < right_.size(); ++i) {
      const std::string name = std::string(fault_scenes()[i].name);
      const Verdict verdict = judged(i, right_[i], StoredAs::rgb8);
      write_image((folder_ / reference_name(i)).string(), levels(verdict.reference));
      report("right", "right-" + std::to_string(i) + ".png", name, i, right_[i]);
    }
    bool all_show = true;
    for (std::size_t k = 0; k < seeded_faults().size(); ++k) {
      const SeededFault& fault = seeded_faults()[k];
      const std::optional<ShownFault> shown = shown_fault(fault, right_);
      all_show &= shown.has_value();
      if (!shown) continue;
      const char* const kind = !fault.glsl.empty() ? "GLSL" : fault.scene ? "scene" : "image";
      report(kind, "fault-" + std::to_string(k) + ".png", std::string(fault.name), shown->scene, shown->image);
    }
    return all_show;
  }

private:
  static std::string reference_name(std::size_t scene) { return "reference-" + std::to_string(scene) + ".png"; }

  Verdict judged(std::size_t scene, const Image<float>& image, StoredAs as) const {
    return judge(fault_scenes()[scene].scene, stored_image(image, as), profile_, {});
  }

  void report(const char* kind, const std::string& file, const std::string& name, std::size_t scene,
              const Image<float>& image) const {
    write_image((folder_ / file).string(), levels(image));
    const Verdict in_8_bits = judged(scene, image, StoredAs::rgb8), in_floats = judged(scene, image, StoredAs::floats);
    const double flip =
        mean_flip(stored_image(in_8_bits.reference, StoredAs::rgb8).colour, stored_image(image, StoredAs::rgb8).colour);
    const auto unexplained = [](const Verdict& verdict) {
      return static_cast<unsigned long long>(verdict.count(PixelClass::unexplained));
    };
    std::printf("%s\t%s\t%s\t%s\t%llu\t%llu\t%.6f\n", kind, file.c_str(), reference_name(scene).c_str(), name.c_str(),
                unexplained(in_8_bits), unexplained(in_floats), flip);
    std::fflush(stdout);
  }

  std::filesystem::path folder_;
  std::vector<Image<float>> right_;
  DeviceProfile profile_ = device_profile("llvmpipe");
};

} // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: draw_faults FOLDER\n");
    return 2;
  }
  return Faults(argv[1]).draw_all() ? 0 : 1;
} catch (const refraster::NoOpenGl& error) {
  std::fprintf(stderr, "SKIPPED, not tested: %s\n", error.what());
  return 77;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 70;
}
