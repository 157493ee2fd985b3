#include "suite/actions/made_image.h"

#include <refraster/render.h>

#include "gl/context/driver_environment.h"
#include "gl/drawn_by_gl.h"
#include "gl/render_gl.h"
#include "io/file/text.h"
#include "suite/judging/fewer_samples.h"
#include "verify/device/read_profile.h"

namespace refraster::suite {
namespace {

MadeImage rendered(Task& task, Floats floats) {
  RenderOptions options = task.placed_options();
  options.want_radiance = floats == Floats::wanted;
  Frame frame = render(task.source.scene, options);
  return {std::move(frame.rgb8), std::move(frame.radiance), options.transfer};
}

MadeImage drawn(Task& task) {
  GlOptions options;
  options.width = task.picture.width, options.height = task.picture.height;
  options.transfer = task.picture.transfer;
  int samples = task.picture.samples;
  if (!task.entry.device.empty()) {
    const DeviceProfile profile = device_profile(task.entry.device);
    enter_environment(profile.environment);
    options.renderer = profile.renderer;
  }
  check_drawn_by_gl(task.entry.scene, task.source.scene);
  place(task.source.scene, task.source.view, options.width, options.height);
  std::string fewer;
  GlFrame frame = draw_with_samples(samples, task.entry.samples, fewer, [&](int count) {
    options.samples = count;
    return render_gl(task.source.scene, options);
  });
  if (!fewer.empty()) task.result.details.push_back(fewer);
  task.result.samples = samples;
  task.result.driver = frame.driver.renderer;
  return {std::move(frame.rgb8), {}, options.transfer};
}

MadeImage read(Task& task) {
  const std::string& path = task.entry.image_file;
  const ImageFile file = read_image(path, task.workplace.memory);
  if (file.bits != 8 || file.values.channels < 3)
    throw InputError(InputFault{path, 0, 0, "", format("%d bits and %d channels", file.bits, file.values.channels),
                                "8 bits, red, green and blue"});
  MadeImage made;
  made.transfer = task.picture.transfer;
  made.rgb8 = Image<std::uint8_t>(file.values.width, file.values.height, 3);
  for (int y = 0; y < file.values.height; ++y)
    for (int x = 0; x < file.values.width; ++x)
      for (int c = 0; c < 3; ++c) made.rgb8.at(x, y)[c] = static_cast<std::uint8_t>(file.values.at(x, y)[c]);
  place(task.source.scene, task.source.view, file.values.width, file.values.height);
  return made;
}

} // namespace

RenderOptions Task::placed_options() {
  place(source.scene, source.view, picture.width, picture.height);
  RenderOptions options;
  options.width = picture.width, options.height = picture.height;
  options.samples = picture.samples;
  options.transfer = picture.transfer;
  options.precision = entry.precision;
  options.threads = workplace.threads;
  options.memory = workplace.memory;
  return options;
}

MadeImage make_image_of(Task& task, Floats floats) {
  MadeImage made = task.entry.needs_gl()                      ? drawn(task)
                   : task.entry.image_from == ImageFrom::file ? read(task)
                                                              : rendered(task, floats);
  task.result.width = made.rgb8.width, task.result.height = made.rgb8.height;
  return made;
}

void write_made(Task& task, const MadeImage& made) {
  task.result.image = task.file(images_folder, ".png");
  WriteOptions options;
  options.threads = task.workplace.threads;
  if (made.transfer == Transfer::srgb) options.curve = StatedCurve::srgb;
  write_image(task.path_of(task.result.image), made.rgb8, options);
}

} // namespace refraster::suite
